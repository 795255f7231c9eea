#include "query/watch/watched_pair.h"

#include <gtest/gtest.h>

namespace foresee::query {
namespace {

constexpr WatchClock at_ten{.clock = 10, .tolerance = 0};

WatchedPair held(double t, double due = 100) {
  return {.a = 1, .b = 2, .t = t, .due = due, .told = t, .held = true};
}

WatchedPair waiting(double t) {
  return {.a = 1, .b = 2, .t = t, .due = t, .told = t, .held = false};
}

TEST(WatchedPair, NewPairsAreToldWhereTheyAreHeld) {
  const WatchedPair now = held(12), later = waiting(90);
  EXPECT_EQ(compare(nullptr, &now, at_ten).op, '+');
  EXPECT_EQ(compare(nullptr, &later, at_ten).op, 0);
  EXPECT_TRUE(compare(nullptr, &later, at_ten).writes);
}

TEST(WatchedPair, PairsThatGoAreToldWhereTheyWereHeld) {
  const WatchedPair now = held(12), later = waiting(90);
  EXPECT_EQ(compare(&now, nullptr, at_ten).op, '-');
  EXPECT_EQ(compare(&later, nullptr, at_ten).op, 0);
  EXPECT_TRUE(compare(&later, nullptr, at_ten).erases);
  EXPECT_EQ(compare(&now, &later, at_ten).op, '-');
  EXPECT_EQ(compare(&later, &now, at_ten).op, '+');
}

TEST(WatchedPair, TimesBeforeTheClockAreAllTheSame) {
  const WatchedPair before = held(3), after = held(10);
  const PairChange change = compare(&before, &after, at_ten);
  EXPECT_EQ(change.op, 0);
  EXPECT_FALSE(change.writes);
}

TEST(WatchedPair, AMoveWithinTheToleranceIsWrittenAndNotTold) {
  const WatchedPair before = held(20), after = held(22);
  const PairChange change = compare(&before, &after, {.clock = 10, .tolerance = 2});
  EXPECT_EQ(change.op, 0);
  EXPECT_TRUE(change.writes);
  EXPECT_EQ(change.row.t, 22);
  EXPECT_EQ(change.row.told, 20);
  const WatchedPair further = held(22.5);
  EXPECT_EQ(compare(&change.row, &further, {.clock = 10, .tolerance = 2}).op, '~');
}

TEST(WatchedPair, AnEarlierEndIsWrittenAndALaterOneOnlyOnceItIsDue) {
  const WatchedPair before = held(12, 50), earlier = held(12, 40), later = held(12, 60);
  EXPECT_TRUE(compare(&before, &earlier, at_ten).writes);
  EXPECT_FALSE(compare(&before, &later, at_ten).writes);
  EXPECT_TRUE(compare(&before, &later, {.clock = 50, .tolerance = 0}).writes);
}

}  // namespace
}  // namespace foresee::query
