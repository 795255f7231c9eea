#include "query/join/join.h"

#include <gtest/gtest.h>

#include "query/join_cases.h"

namespace foresee {
namespace {

using testing::after_now;
using testing::discs;
using testing::IdPairs;
using testing::pairs_of;
using testing::rows_of;
using testing::scene_of;

/// Three discs on the x-axis: 1 and 2 collide head-on and touch from 3 to 4, 3 rests far away.
std::shared_ptr<const Scene> head_on() {
  return scene_of(discs, {2, 1, 3},
                  {10, 0, -1, 0, 1,   //
                   0, 0, 1, 0, 3,     //
                   0, 99, 0, 0, 1});  //
}

TEST(Join, GivesStartEndAndClosestApproach) {
  const auto rows = rows_of({.a = head_on(), .now = 1, .h = 20});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].a, 1);
  EXPECT_EQ(rows[0].b, 2);
  EXPECT_EQ(rows[0].contact.t, 3);
  EXPECT_EQ(rows[0].contact.dt, 2);
  EXPECT_EQ(rows[0].contact.t_end, 7);
  EXPECT_EQ(rows[0].contact.dt_end, 6);
  EXPECT_EQ(rows[0].approach.t, 5);
  EXPECT_EQ(rows[0].approach.dt, 4);
  EXPECT_EQ(rows[0].approach.d, 0);
}

TEST(Join, ClosesTheHorizonAtBothEnds) {
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 0, .h = 3}).size(), 1u);
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 0, .h = 2.999}).size(), 0u);
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 7, .h = 0}).size(), 1u);
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 7.001, .h = 1e300}).size(), 0u);
}

TEST(Join, TakesAnyFiniteTimeAsNow) {
  for (double now : {-1e308, -1e9, 0.0, 1e9, 1e308})
    for (double h : {0.0, 1.0, 1e308}) {
      const auto question = JoinQuestion{.a = head_on(), .now = now, .h = h, .method = JoinMethod::scan};
      auto by_grid = question;
      by_grid.method = JoinMethod::grid;
      EXPECT_EQ(pairs_of(question), pairs_of(by_grid)) << now << ", " << h;
    }
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 0, .h = 1e308}), (IdPairs{{1, 2}}));
}

TEST(Join, WithinWidensTheContact) {
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 0, .h = 1, .within = 4}).size(), 1u);
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 0, .h = 1, .within = 3.999}).size(), 0u);
}

TEST(Join, OfTwoTablesPutsEachIdInItsColumn) {
  const auto buoys = scene_of(Layout{.axes = 2}, {1, 2, 3}, {5, 0, 0, 98, 50, 50}, "buoys");
  EXPECT_EQ(pairs_of({.a = head_on(), .b = buoys, .h = 10}), (IdPairs{{1, 1}, {2, 1}, {3, 2}}));
  EXPECT_EQ(pairs_of({.a = buoys, .b = head_on(), .h = 10}), (IdPairs{{1, 1}, {1, 2}, {2, 3}}));
}

TEST(Join, OfATableWithItselfAsTwoSidesGivesBothOrdersAndNoObjectWithItself) {
  const auto ships = head_on();
  for (JoinMethod method : {JoinMethod::scan, JoinMethod::grid})
    EXPECT_EQ(pairs_of({.a = ships, .b = ships, .h = 10, .method = method}), (IdPairs{{1, 2}, {2, 1}}));
}

TEST(Join, OfFewerThanTwoObjectsIsEmpty) {
  const auto none = scene_of(discs, {}, {});
  const auto one = scene_of(discs, {1}, {0, 0, 0, 0, 1});
  for (JoinMethod method : {JoinMethod::automatic, JoinMethod::scan, JoinMethod::grid}) {
    EXPECT_EQ(pairs_of({.a = none, .h = 1, .method = method}), IdPairs{});
    EXPECT_EQ(pairs_of({.a = one, .h = 1, .method = method}), IdPairs{});
    EXPECT_EQ(pairs_of({.a = one, .b = none, .h = 1, .method = method}), IdPairs{});
    EXPECT_EQ(pairs_of({.a = none, .b = one, .h = 1, .method = method}), IdPairs{});
  }
}

TEST(Join, TestsOneObjectIfItsIdIsRequested) {
  const auto ships = head_on();
  EXPECT_EQ(pairs_of({.a = ships, .h = 10, .only_a = 1}), (IdPairs{{1, 2}}));
  EXPECT_EQ(pairs_of({.a = ships, .h = 10, .only_b = 2}), (IdPairs{{1, 2}}));
  EXPECT_EQ(pairs_of({.a = ships, .h = 10, .only_a = 2}), IdPairs{});
  EXPECT_EQ(pairs_of({.a = ships, .h = 10, .only_b = 1}), IdPairs{});
  EXPECT_EQ(pairs_of({.a = ships, .h = 10, .only_a = 1, .only_b = 2}), (IdPairs{{1, 2}}));
  EXPECT_EQ(pairs_of({.a = ships, .h = 10, .only_a = 77}), IdPairs{});
  EXPECT_EQ(pairs_of({.a = ships, .b = ships, .h = 10, .only_a = 2}), (IdPairs{{2, 1}}));
}

TEST(Join, LeavesOutPairsThatTouchAlready) {
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 2, .h = 5, .queried_dt = after_now}).size(), 1u);
  EXPECT_EQ(pairs_of({.a = head_on(), .now = 3, .h = 5, .queried_dt = after_now}).size(), 0u);
}

TEST(Join, ComputesOnlyWhatIsWanted) {
  const auto rows = rows_of({.a = head_on(), .h = 20, .wants = {.contact = false, .approach = false}});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].contact.t, 0);
}

std::string error_of(const JoinQuestion& question) {
  try {
    rows_of(question);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Join, SaysWhichParameterIsWrong) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of({.a = head_on(), .h = -3}), "h must be a finite number >= 0, not -3");
  EXPECT_EQ(error_of({.a = head_on(), .h = infinity}), "h must be a finite number >= 0, not inf");
  EXPECT_EQ(error_of({.a = head_on(), .within = -0.5}), "within must be a finite number >= 0, not -0.5");
  EXPECT_EQ(error_of({.a = head_on(), .within_z = -1}), "within_z must be a finite number >= 0, not -1");
  EXPECT_EQ(error_of({.a = head_on(), .now = -infinity}), "now must be a finite number, not -inf");
  EXPECT_EQ(error_of({.a = head_on(), .b = scene_of(Layout{.axes = 1}, {}, {}, "rails")}),
            "ships has 2 axes and rails has 1 axis: a join takes two tables with the same number of axes");
  EXPECT_THROW(join_method("quick"), Error);
}

}  // namespace
}  // namespace foresee
