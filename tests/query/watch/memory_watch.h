// A watch in memory over tables in memory, and a reader of its log.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "never_interrupt.h"
#include "query/join_cases.h"
#include "query/memory_table.h"
#include "query/watch/pair_contacts.h"
#include "query/watch/pair_update.h"

namespace foresee::testing {

inline constexpr Layout boats{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true};

class MemoryWatch final : public WatchStorage {
 public:
  using Ids = std::pair<std::int64_t, std::int64_t>;

  std::vector<WatchedPair> pairs() override {
    return those([](const WatchedPair&) { return true; });
  }
  std::vector<WatchedPair> stored_pairs_of(std::span<const std::int64_t> a,
                                           std::span<const std::int64_t> b) override {
    return those([&](const WatchedPair& pair) {
      return std::binary_search(a.begin(), a.end(), pair.a) || std::binary_search(b.begin(), b.end(), pair.b);
    });
  }
  std::vector<WatchedPair> due_pairs(PairState state, double until) override {
    return those([&](const WatchedPair& pair) { return pair.state == state && pair.due <= until; });
  }
  std::optional<WatchedPair> pair(std::int64_t a, std::int64_t b) override {
    const auto found = rows.find({a, b});
    return found == rows.end() ? std::nullopt : std::optional(found->second);
  }
  void write_pair(const WatchedPair* before, const WatchedPair& pair, bool with_reported_t) override {
    EXPECT_EQ(rows.contains({pair.a, pair.b}), before != nullptr);
    if (before) expect_stored(*before);
    WatchedPair& row = rows[{pair.a, pair.b}] = pair;
    if (!with_reported_t) row.reported_t = row.t;
    keys_wait = true;
  }
  void erase_pair(const WatchedPair& pair) override {
    expect_stored(pair);
    rows.erase({pair.a, pair.b});
    keys_wait = true;
  }
  void erase_all_pairs() override {
    rows.clear();
    keys_wait = true;
  }
  void write_keys() override { keys_wait = false; }
  void append(const LoggedChange& change) override { log.push_back(change); }
  void trim(std::int64_t up_to) override {
    std::erase_if(log, [&](const LoggedChange& change) { return change.seq <= up_to; });
  }

  std::map<Ids, WatchedPair> rows;
  std::vector<LoggedChange> log;
  bool keys_wait = false;

 private:
  /// The keys of a row can only be erased if the caller knows them.
  void expect_stored(const WatchedPair& pair) {
    const WatchedPair& row = rows[{pair.a, pair.b}];
    EXPECT_EQ(row.state, pair.state);
    EXPECT_EQ(row.due, pair.due);
  }
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
  Watched(bool between, WatchDeclaration declaration, const Layout& layout = boats)
      : ships(std::make_shared<MemoryTable>("ships", layout)),
        ferries(std::make_shared<MemoryTable>("ferries", layout)) {
    tables.a = ships;
    if (between) tables.b = ferries;
    static_cast<WatchDeclaration&>(state) = std::move(declaration);
  }

  void update() {
    const std::size_t known = watch.log.size();
    PairUpdate update(tables, state, watch, {never});
    if (const auto after = update.run()) state = *after;
    EXPECT_FALSE(watch.keys_wait);
    ships->commit();
    ferries->commit();
    for (std::size_t i = known; i < watch.log.size(); ++i) {
      const LoggedChange& change = watch.log[i];
      if (change.op == '-')
        EXPECT_EQ(reader.erase({change.a, change.b}), 1u);
      else
        EXPECT_EQ(reader.insert_or_assign({change.a, change.b}, change.t).second, change.op == '+');
    }
  }

  /// Its reported pairs with the times that readers see: those of the join at the clock, and of the log.
  void expect_join() {
    JoinQuestion all = question_of_all(tables, state, {state.now(), state.horizon}, {never});
    std::map<MemoryWatch::Ids, double> joined;
    for (const JoinRow& row : rows_of(all)) joined[{row.a, row.b}] = row.contact.t;
    expect_pairs(joined);
  }

  /// The same for pairs with their times, by another way.
  void expect_pairs(const std::map<MemoryWatch::Ids, double>& joined) {
    std::map<MemoryWatch::Ids, double> reported;
    for (const auto& [ids, row] : watch.rows)
      if (row.is_reported()) reported[ids] = std::max(row.t, state.now());
    EXPECT_TRUE(reported == joined) << reported.size() << " pairs, of the join " << joined.size();
    for (auto& [ids, t] : reader) t = std::max(t, state.now());
    EXPECT_TRUE(reader == joined) << reader.size() << " pairs in the log, of the join " << joined.size();
  }

  NeverInterrupt never;
  std::shared_ptr<MemoryTable> ships, ferries;
  JoinedTables tables;
  MemoryWatch watch;
  WatchState state;
  std::map<MemoryWatch::Ids, double> reader;
};

}  // namespace foresee::testing
