// A watch in memory whose calls are checked, over tables in memory, and a reader of its log.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "never_interrupt.h"
#include "query/join_cases.h"
#include "query/memory_table.h"
#include "query/watch/memory_watch.h"
#include "query/watch/pair_contacts.h"
#include "query/watch/pair_update.h"

namespace foresee::testing {

inline constexpr Layout boats{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true};

/// A watch that checks the calls of an update: the keys of a row can only be erased if the caller knows them.
class CheckedWatch final : public MemoryWatch {
 public:
  std::vector<WatchedPair> pairs() override {
    ++recomputations;
    return MemoryWatch::pairs();
  }
  void write_pair(const WatchedPair* before, const WatchedPair& pair, bool with_reported_t) override {
    EXPECT_EQ(rows().contains({pair.a, pair.b}), before != nullptr);
    if (before) expect_stored(*before);
    MemoryWatch::write_pair(before, pair, with_reported_t);
    keys_wait = true;
  }
  void erase_pair(const WatchedPair& pair) override {
    expect_stored(pair);
    MemoryWatch::erase_pair(pair);
    keys_wait = true;
  }
  void erase_all_pairs() override {
    MemoryWatch::erase_all_pairs();
    keys_wait = true;
  }
  void write_keys() override { keys_wait = false; }

  bool keys_wait = false;
  int recomputations = 0;  ///< only these read all pairs

 private:
  void expect_stored(const WatchedPair& given) {
    const std::optional<WatchedPair> row = pair(given.a, given.b);
    ASSERT_TRUE(row);
    EXPECT_EQ(row->state, given.state);
    EXPECT_EQ(row->due, given.due);
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
    const std::size_t known = watch.log().size();
    PairUpdate update(tables, state, watch, {never});
    if (const auto after = update.run()) state = *after;
    EXPECT_FALSE(watch.keys_wait);
    ships->commit();
    ferries->commit();
    for (std::size_t i = known; i < watch.log().size(); ++i) {
      const LoggedChange& change = watch.log()[i];
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
    for (const auto& [ids, row] : watch.rows())
      if (row.is_reported()) reported[ids] = std::max(row.t, state.now());
    EXPECT_TRUE(reported == joined) << reported.size() << " pairs, of the join " << joined.size();
    for (auto& [ids, t] : reader) t = std::max(t, state.now());
    EXPECT_TRUE(reader == joined) << reader.size() << " pairs in the log, of the join " << joined.size();
  }

  NeverInterrupt never;
  std::shared_ptr<MemoryTable> ships, ferries;
  JoinedTables tables;
  CheckedWatch watch;
  WatchState state;
  std::map<MemoryWatch::Ids, double> reader;
};

}  // namespace foresee::testing
