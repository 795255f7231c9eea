// A watch over tables in memory, without SQL: after every settlement its rows are those of the join of all
// objects, and its log leads from the rows before to them.
#include "query/watch/settlement.h"

#include <gtest/gtest.h>

#include <map>

#include "query/join_cases.h"
#include "query/memory_table.h"
#include "query/watch/pair_contacts.h"

namespace foresee::testing {
namespace {

constexpr Layout boats{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true};

class MemoryWatch final : public WatchPairs, public WatchLog {
 public:
  using Ids = std::pair<std::int64_t, std::int64_t>;

  std::vector<WatchedPair> pairs() override {
    return those([](const WatchedPair&) { return true; });
  }
  std::vector<WatchedPair> pairs_of_a(std::int64_t id) override {
    return those([&](const WatchedPair& pair) { return pair.a == id; });
  }
  std::vector<WatchedPair> pairs_of_b(std::int64_t id) override {
    return those([&](const WatchedPair& pair) { return pair.b == id; });
  }
  std::vector<WatchedPair> due_pairs(bool held, double until) override {
    return those([&](const WatchedPair& pair) { return pair.held == held && pair.due <= until; });
  }
  std::optional<WatchedPair> pair(std::int64_t a, std::int64_t b) override {
    const auto found = rows.find({a, b});
    return found == rows.end() ? std::nullopt : std::optional(found->second);
  }
  void write_pair(const WatchedPair& pair, PairWrite how, bool with_told) override {
    EXPECT_EQ(rows.contains({pair.a, pair.b}), how != PairWrite::adds);
    WatchedPair& row = rows[{pair.a, pair.b}];
    if (how == PairWrite::moves) {
      EXPECT_EQ(row.held, pair.held);
      EXPECT_EQ(row.due, pair.due);
    }
    row = pair;
    if (!with_told) row.told = row.t;
  }
  void erase_pair(std::int64_t a, std::int64_t b) override { EXPECT_EQ(rows.erase({a, b}), 1u); }
  void erase_all_pairs() override { rows.clear(); }
  void append(const LoggedChange& change) override { log.push_back(change); }
  void trim(std::int64_t up_to) override {
    std::erase_if(log, [&](const LoggedChange& change) { return change.seq <= up_to; });
  }

  std::map<Ids, WatchedPair> rows;
  std::vector<LoggedChange> log;

 private:
  template <class Keep>
  std::vector<WatchedPair> those(Keep keep) const {
    std::vector<WatchedPair> found;
    for (const auto& [ids, row] : rows)
      if (keep(row)) found.push_back(row);
    return found;
  }
};

/// A watch within one table, or between two, and what a reader of its log knows.
struct Watched {
  Watched(bool between, WatchDeclaration declaration) {
    tables.a = ships;
    if (between) tables.b = ferries;
    static_cast<WatchDeclaration&>(state) = std::move(declaration);
  }

  void settle() {
    const std::size_t known = watch.log.size();
    Settlement settlement(tables, state, watch, watch, {never});
    if (const auto after = settlement.settle()) state = *after;
    ships->commit(), ferries->commit();
    for (std::size_t i = known; i < watch.log.size(); ++i) {
      const LoggedChange& change = watch.log[i];
      if (change.op == '-')
        EXPECT_EQ(reader.erase({change.a, change.b}), 1u);
      else
        EXPECT_EQ(reader.insert_or_assign({change.a, change.b}, change.t).second, change.op == '+');
    }
  }

  /// Its held pairs with the times that readers see: those of the join at the clock, and of the log.
  void expect_join() {
    JoinQuestion all = question_of_all(tables, state, {state.now(), state.horizon}, {never});
    std::map<MemoryWatch::Ids, double> joined, held;
    for (const JoinRow& row : rows_of(all)) joined[{row.a, row.b}] = row.contact.t;
    for (const auto& [ids, row] : watch.rows)
      if (row.held) held[ids] = std::max(row.t, state.now());
    EXPECT_TRUE(held == joined) << held.size() << " pairs, of the join " << joined.size();
    for (auto& [ids, t] : reader) t = std::max(t, state.now());
    EXPECT_TRUE(reader == joined) << reader.size() << " pairs in the log, of the join " << joined.size();
  }

  NeverInterrupt never;
  std::shared_ptr<MemoryTable> ships = std::make_shared<MemoryTable>("ships", boats);
  std::shared_ptr<MemoryTable> ferries = std::make_shared<MemoryTable>("ferries", boats);
  JoinedTables tables;
  MemoryWatch watch;
  WatchState state;
  std::map<MemoryWatch::Ids, double> reader;
};

std::vector<double> report(Random& random, double t) {
  return {t, random.in(0, 100), random.in(0, 100), random.in(-2, 2), random.in(-2, 2), random.in(0, 2)};
}

class SettlementLives : public ::testing::TestWithParam<bool> {};

TEST_P(SettlementLives, EverySettlementGivesTheRowsOfTheJoin) {
  std::size_t reported = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Watched watched(GetParam(), {.tbl = "ships", .horizon = 20, .within = seed % 3 == 0 ? 1.5 : 0});
    Random random(seed);
    double t = 1000;
    for (int step = 0; step < 60; ++step, t += random.in(0, step % 15 == 14 ? 60 : 3)) {
      const std::uint64_t many = step == 0 ? 60 : step % 20 == 19 ? 40 : random.below(4);
      for (std::uint64_t i = 0; i < many; ++i) {
        MemoryTable& table = random.below(2) ? *watched.ships : *watched.ferries;
        const auto id = static_cast<std::int64_t>(1 + random.below(60));
        if (random.below(8) == 0)
          table.erase(id);
        else
          table.put(id, report(random, t));
      }
      watched.settle();
      watched.expect_join();
    }
    reported += watched.watch.log.size();
  }
  EXPECT_GT(reported, 500u);
}

INSTANTIATE_TEST_SUITE_P(WithinOneAndBetweenTwo, SettlementLives, ::testing::Bool());

TEST(Settlement, NothingIsWrittenIfNothingChanged) {
  Watched watched(false, {.tbl = "ships", .horizon = 20});
  Random random(1);
  for (std::int64_t id = 1; id <= 30; ++id) watched.ships->put(id, report(random, 0));
  watched.settle();
  const std::size_t changes = watched.watch.log.size();
  EXPECT_GT(changes, 0u);
  Settlement settlement(watched.tables, watched.state, watched.watch, watched.watch, {watched.never});
  EXPECT_FALSE(settlement.settle());
  EXPECT_FALSE(settlement.has_written());
  EXPECT_EQ(watched.watch.log.size(), changes);
}

TEST(Settlement, AnAdvanceMovesTheClockWithoutChangesForwardAndBack) {
  Watched watched(false, {.tbl = "ships", .horizon = 20, .manual = true});
  Random random(2);
  for (std::int64_t id = 1; id <= 40; ++id) watched.ships->put(id, report(random, 0));
  for (const double clock : {0.0, 5.0, 12.0, 300.0, 6.0}) {
    watched.state.asked = clock;
    watched.settle();
    EXPECT_EQ(watched.state.clock, clock);
    std::size_t held = 0;
    for (const auto& [ids, row] : watched.watch.rows) held += row.held;
    JoinQuestion all = question_of_all(watched.tables, watched.state, {clock, 20}, {watched.never});
    EXPECT_EQ(held, rows_of(all).size()) << clock;
  }
}

TEST(Settlement, ChangesThatAreUnknownAreRecomputed) {
  Watched watched(false, {.tbl = "ships", .horizon = 20});
  Random random(3);
  for (std::int64_t id = 1; id <= 40; ++id) watched.ships->put(id, report(random, 0));
  watched.settle();
  watched.ships->put(1, report(random, 1));
  watched.ships->commit();  // without a settlement: its changes are forgotten
  watched.ships->put(2, report(random, 1));
  EXPECT_FALSE(watched.ships->changes_since(watched.state.stamp).reported);
  watched.settle();
  watched.expect_join();
}

}  // namespace
}  // namespace foresee::testing
