#include "query/watch/watched_pair.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foresee {
namespace {

constexpr WatchClock at_ten{.clock = 10, .tolerance = 0, .horizon_end = 70};

WatchedPair reported(double t, double due = 100) {
  return {.a = 1, .b = 2, .t = t, .due = due, .reported_t = t, .state = PairState::reported};
}

WatchedPair waiting(double t) {
  return {.a = 1, .b = 2, .t = t, .due = t, .reported_t = t, .state = PairState::waiting};
}

TEST(WatchedPair, NewPairsAreLoggedIfTheyAreReported) {
  const WatchedPair now = reported(12), later = waiting(90);
  EXPECT_EQ(change_between(nullptr, &now, at_ten).op, '+');
  EXPECT_EQ(change_between(nullptr, &later, at_ten).op, 0);
  EXPECT_TRUE(change_between(nullptr, &later, at_ten).writes);
}

TEST(WatchedPair, PairsThatEndAreLoggedIfTheyWereReported) {
  const WatchedPair now = reported(12), later = waiting(90);
  EXPECT_EQ(change_between(&now, nullptr, at_ten).op, '-');
  EXPECT_EQ(change_between(&later, nullptr, at_ten).op, 0);
  EXPECT_TRUE(change_between(&later, nullptr, at_ten).erases);
  EXPECT_EQ(change_between(&now, &later, at_ten).op, '-');
  EXPECT_EQ(change_between(&later, &now, at_ten).op, '+');
}

TEST(WatchedPair, TimesBeforeTheClockAreAllTheSame) {
  const WatchedPair before = reported(3), after = reported(10);
  const PairChange change = change_between(&before, &after, at_ten);
  EXPECT_EQ(change.op, 0);
  EXPECT_FALSE(change.writes);
}

TEST(WatchedPair, AMoveWithinTheToleranceIsWrittenAndNotReported) {
  const WatchedPair before = reported(20), after = reported(22);
  const PairChange change = change_between(&before, &after, {.clock = 10, .tolerance = 2});
  EXPECT_EQ(change.op, 0);
  EXPECT_TRUE(change.writes);
  EXPECT_EQ(change.row.t, 22);
  EXPECT_EQ(change.row.reported_t, 20);
  const WatchedPair further = reported(22.5);
  EXPECT_EQ(change_between(&change.row, &further, {.clock = 10, .tolerance = 2}).op, '~');
}

TEST(WatchedPair, AnEarlierEndIsWrittenAndALaterOneOnlyOnceItIsDue) {
  const WatchedPair before = reported(12, 50), earlier = reported(12, 40), later = reported(12, 60);
  EXPECT_TRUE(change_between(&before, &earlier, at_ten).writes);
  EXPECT_FALSE(change_between(&before, &later, at_ten).writes);
  EXPECT_TRUE(change_between(&before, &later, {.clock = 50, .tolerance = 0}).writes);
}

TEST(WatchedPair, AWaitingPairIsDueNotAfterItsStartAndIsWrittenOnlyIfThatIsTooLate) {
  const WatchedPair found = waiting(90), later = waiting(120), sooner = waiting(71),
                    much_later = waiting(1e300);
  const WatchedPair before = change_between(nullptr, &found, at_ten).row;
  EXPECT_GT(before.due, at_ten.horizon_end);
  EXPECT_LE(before.due, found.t);
  EXPECT_FALSE(change_between(&before, &found, at_ten).writes);
  EXPECT_FALSE(change_between(&before, &later, at_ten).writes);
  EXPECT_FALSE(change_between(&before, &much_later, at_ten).writes);
  const PairChange moved = change_between(&before, &sooner, at_ten);
  EXPECT_TRUE(moved.writes);
  EXPECT_GT(moved.row.due, at_ten.horizon_end);
  EXPECT_LE(moved.row.due, sooner.t);
  // Once the horizon has reached `due`, the pair gets one that is not reached yet.
  const WatchClock then{.clock = 25, .tolerance = 0, .horizon_end = before.due};
  const PairChange again = change_between(&before, &later, then);
  EXPECT_TRUE(again.writes);
  EXPECT_EQ(again.op, 0);
  EXPECT_GT(again.row.due, then.horizon_end);
}

TEST(WatchedPair, AnEndThatMovesIsWrittenOnlyIfItIsSooner) {
  const WatchedPair first = reported(12, 110), later = reported(12, 120), sooner = reported(12, 100);
  const WatchedPair before = change_between(nullptr, &first, at_ten).row;
  EXPECT_EQ(before.due, 110);
  EXPECT_FALSE(change_between(&before, &later, at_ten).writes);
  EXPECT_EQ(change_between(&before, &sooner, at_ten).row.due, 100);
  const WatchClock due{.clock = 110, .tolerance = 0, .horizon_end = 170};
  EXPECT_EQ(change_between(&before, &later, due).row.due, 120);
}

TEST(WatchedPair, ATimeIsNeverDueLateWhateverTheNumbers) {
  for (const double clock : {-1e308, -5.0, 0.0, 1e9, 1e308})
    for (const double wait : {0.0, 5e-324, 1e-9, 3.0, 1e308, HUGE_VAL})
      for (const double time : {clock, clock + wait, clock - wait, 1e308, -1e308}) {
        const WatchClock at{.clock = clock, .tolerance = 0, .horizon_end = clock + 60};
        for (const PairState state : {PairState::waiting, PairState::reported}) {
          const WatchedPair pair{.a = 1, .b = 2, .t = time, .due = time, .reported_t = time, .state = state};
          const double due = change_between(nullptr, &pair, at).row.due,
                       from = state == PairState::reported ? clock : at.horizon_end;
          EXPECT_LE(due, time) << clock << ", " << wait;
          EXPECT_TRUE(due > from || due == time) << clock << ", " << wait;
        }
      }
}

}  // namespace
}  // namespace foresee
