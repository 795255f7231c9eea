#include "query/watch/watched_pair.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

constexpr WatchClock at_ten{.clock = 10, .tolerance = 0};

WatchedPair held(double t, double due = 100) {
  return {.a = 1, .b = 2, .t = t, .due = due, .told = t, .held = true};
}

WatchedPair waiting(double t) {
  return {.a = 1, .b = 2, .t = t, .due = t, .told = t, .held = false};
}

TEST(WatchedPair, NewPairsAreReportedIfTheyAreHeld) {
  const WatchedPair now = held(12), later = waiting(90);
  EXPECT_EQ(change_between(nullptr, &now, at_ten).op, '+');
  EXPECT_EQ(change_between(nullptr, &later, at_ten).op, 0);
  EXPECT_TRUE(change_between(nullptr, &later, at_ten).writes);
}

TEST(WatchedPair, PairsThatEndAreReportedIfTheyWereHeld) {
  const WatchedPair now = held(12), later = waiting(90);
  EXPECT_EQ(change_between(&now, nullptr, at_ten).op, '-');
  EXPECT_EQ(change_between(&later, nullptr, at_ten).op, 0);
  EXPECT_TRUE(change_between(&later, nullptr, at_ten).erases);
  EXPECT_EQ(change_between(&now, &later, at_ten).op, '-');
  EXPECT_EQ(change_between(&later, &now, at_ten).op, '+');
}

TEST(WatchedPair, TimesBeforeTheClockAreAllTheSame) {
  const WatchedPair before = held(3), after = held(10);
  const PairChange change = change_between(&before, &after, at_ten);
  EXPECT_EQ(change.op, 0);
  EXPECT_FALSE(change.writes);
}

TEST(WatchedPair, AMoveWithinTheToleranceIsWrittenAndNotReported) {
  const WatchedPair before = held(20), after = held(22);
  const PairChange change = change_between(&before, &after, {.clock = 10, .tolerance = 2});
  EXPECT_EQ(change.op, 0);
  EXPECT_TRUE(change.writes);
  EXPECT_EQ(change.row.t, 22);
  EXPECT_EQ(change.row.told, 20);
  const WatchedPair further = held(22.5);
  EXPECT_EQ(change_between(&change.row, &further, {.clock = 10, .tolerance = 2}).op, '~');
}

TEST(WatchedPair, AnEarlierEndIsWrittenAndALaterOneOnlyOnceItIsDue) {
  const WatchedPair before = held(12, 50), earlier = held(12, 40), later = held(12, 60);
  EXPECT_TRUE(change_between(&before, &earlier, at_ten).writes);
  EXPECT_FALSE(change_between(&before, &later, at_ten).writes);
  EXPECT_TRUE(change_between(&before, &later, {.clock = 50, .tolerance = 0}).writes);
}

}  // namespace
}  // namespace foresee
