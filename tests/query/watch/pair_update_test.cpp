// A watch over tables in memory, without SQL: after every update its rows are those of the join of all
// objects, and its log leads from the rows before to them.
#include "query/watch/pair_update.h"

#include <gtest/gtest.h>

#include "query/watch/watched.h"

namespace foresee::testing {
namespace {

std::vector<double> report(Random& random, double t) {
  return {t, random.in(0, 100), random.in(0, 100), random.in(-2, 2), random.in(-2, 2), random.in(0, 2)};
}

class PairUpdateLives : public ::testing::TestWithParam<bool> {};

TEST_P(PairUpdateLives, EveryUpdateGivesTheRowsOfTheJoin) {
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
      watched.update();
      watched.expect_join();
    }
    reported += watched.watch.log().size();
  }
  EXPECT_GT(reported, 500u);
}

INSTANTIATE_TEST_SUITE_P(WithinOneAndBetweenTwo, PairUpdateLives, ::testing::Bool());

TEST(PairUpdate, NothingIsWrittenIfNothingChanged) {
  Watched watched(false, {.tbl = "ships", .horizon = 20});
  Random random(1);
  for (std::int64_t id = 1; id <= 30; ++id) watched.ships->put(id, report(random, 0));
  watched.update();
  const std::size_t changes = watched.watch.log().size();
  EXPECT_GT(changes, 0u);
  PairUpdate update(watched.tables, watched.state, watched.watch, {watched.never});
  EXPECT_FALSE(update.run());
  EXPECT_FALSE(update.has_written());
  EXPECT_EQ(watched.watch.log().size(), changes);
}

TEST(PairUpdate, AnAdvanceMovesTheClockWithoutChangesForwardAndBack) {
  Watched watched(false, {.tbl = "ships", .horizon = 20, .manual = true});
  Random random(2);
  for (std::int64_t id = 1; id <= 40; ++id) watched.ships->put(id, report(random, 0));
  for (const double clock : {0.0, 5.0, 12.0, 300.0, 6.0}) {
    watched.state.requested_clock = clock;
    watched.update();
    EXPECT_EQ(watched.state.clock, clock);
    std::size_t reported = 0;
    for (const auto& [ids, row] : watched.watch.rows()) reported += row.is_reported();
    JoinQuestion all = question_of_all(watched.tables, watched.state, {clock, 20}, {watched.never});
    EXPECT_EQ(reported, rows_of(all).size()) << clock;
  }
}

TEST(PairUpdate, ALookAheadComesBeforeTheClockPassesTheKnownEnds) {
  for (const double step : {0.01, 0.3, 1.0}) {
    Watched watched(false, {.tbl = "ships", .horizon = 20, .manual = true});
    Random random(3);
    for (std::int64_t id = 1; id <= 200; ++id) watched.ships->put(id, report(random, 0));
    int look_aheads = 0;
    for (int i = 0; i <= 200; ++i) {
      const double known_to = watched.state.known_to;
      watched.state.requested_clock = i * step;
      watched.update();
      watched.expect_join();
      look_aheads += watched.state.known_to > known_to;
      const double ends = ends_known_to(watched.state);
      EXPECT_GE(ends, i * step);
      for (const auto& [ids, row] : watched.watch.rows())
        EXPECT_TRUE(!row.is_reported() || row.due == never_due || row.due <= ends);
    }
    EXPECT_EQ(watched.watch.recomputations, 1) << step;
    EXPECT_GE(look_aheads, step == 0.01 ? 1 : 3) << step;
  }
}

TEST(PairUpdate, ChangesThatAreUnknownAreRecomputed) {
  Watched watched(false, {.tbl = "ships", .horizon = 20});
  Random random(3);
  for (std::int64_t id = 1; id <= 40; ++id) watched.ships->put(id, report(random, 0));
  watched.update();
  watched.ships->put(1, report(random, 1));
  watched.ships->commit();  // without an update: its changes are forgotten
  watched.ships->put(2, report(random, 1));
  EXPECT_FALSE(watched.ships->changes_since(watched.state.stamp).are_known);
  watched.update();
  watched.expect_join();
}

}  // namespace
}  // namespace foresee::testing
