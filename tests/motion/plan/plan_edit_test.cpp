#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "motion/plan/plan_legs.h"
#include "motion/plan/plan_text.h"
#include "motion/plan/random_legs.h"

namespace foresee {
namespace {

using testing::read_plan;
using testing::write_plan;

std::string cut(const char* text, double from, double to) {
  const auto part = cut_plan(read_plan(text), from, to);
  return part ? write_plan(*part) : "nothing";
}

TEST(PlanEdit, ShiftsTimes) {
  EXPECT_EQ(write_plan(shifted_plan(read_plan("MULTILINESTRING M((0 0 0, 1 0 1), (7 7 2, 7 7 inf))"), 60)),
            "MULTILINESTRING M((0 0 60, 1 0 61), (7 7 62, 7 7 inf))");
  const Plan legs{
      .kind = PlanKind::uniform, .axes = 1, .legs = {{0, 5, {1}, {2}, {}}, {5, no_end, {3}, {0}, {}}}};
  const Plan shifted = shifted_plan(legs, -2);
  EXPECT_EQ(shifted.legs[0], (Leg{-2, 3, {1}, {2}, {}}));
  EXPECT_EQ(shifted.legs[1], (Leg{3, no_end, {3}, {0}, {}}));
}

TEST(PlanEdit, RefusesAShiftThatDoublesDoNotHold) {
  const auto refusal = [](double seconds) -> std::string {
    try {
      shifted_plan(read_plan("LINESTRING M(0 0 1e308, 1 0 1.1e308)"), seconds);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(1e308), "seconds is 1e+308: no double holds a time of the shifted plan; write less");
  try {
    shifted_plan(read_plan("LINESTRING M(0 0 0, 1 0 1)"), 1e300);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "knot 2: t is 1e+300 after 1e+300: times must rise; write MULTILINESTRING M for a jump");
  }
}

TEST(PlanEdit, CutsKnots) {
  const char* plan = "LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 19)";
  EXPECT_EQ(cut(plan, -no_end, no_end), plan);
  EXPECT_EQ(cut(plan, 2, 12), "LINESTRING M(4 0 2, 10 0 5, 10 0 9, 10 6 12)");
  EXPECT_EQ(cut(plan, 5, 9), "LINESTRING M(10 0 5, 10 0 9)");
  EXPECT_EQ(cut(plan, 6, 7), "LINESTRING M(10 0 6, 10 0 7)");
  EXPECT_EQ(cut(plan, 19, 30), "nothing");
  EXPECT_EQ(cut(plan, 5, 5), "nothing");
  EXPECT_EQ(cut(plan, 30, 40), "nothing");
}

TEST(PlanEdit, CutsParts) {
  const char* plan = "MULTILINESTRING M((0 0 0, 4 0 4), (7 7 6, 7 9 8), (0 0 8, 0 0 inf))";
  EXPECT_EQ(cut(plan, 1, 7), "MULTILINESTRING M((1 0 1, 4 0 4), (7 7 6, 7 8 7))");
  EXPECT_EQ(cut(plan, 4, 8), "LINESTRING M(7 7 6, 7 9 8)");
  EXPECT_EQ(cut(plan, 4, 6), "nothing");
  EXPECT_EQ(cut(plan, 9, no_end), "LINESTRING M(0 0 9, 0 0 inf)");
  EXPECT_EQ(cut(plan, 9, 12), "LINESTRING M(0 0 9, 0 0 12)");
}

TEST(PlanEdit, CutsLegs) {
  const Plan plan{.kind = PlanKind::accelerated,
                  .axes = 1,
                  .legs = {{0, 4, {0}, {0}, {2}}, {4, 4, {9}, {1}, {}}, {6, no_end, {7}, {1}, {}}}};
  const auto part = cut_plan(plan, 1, 8);
  ASSERT_TRUE(part);
  ASSERT_EQ(part->legs.size(), 3u);
  EXPECT_EQ(part->legs[0], (Leg{1, 4, {1}, {2}, {2}}));
  EXPECT_EQ(part->legs[1], plan.legs[1]);
  EXPECT_EQ(part->legs[2], (Leg{6, 8, {7}, {1}, {}}));
  EXPECT_EQ(cut_plan(plan, 10, no_end)->legs[0], (Leg{10, no_end, {11}, {1}, {}}));
  EXPECT_FALSE(cut_plan(plan, 5, 6));
}

/// At any time of the part, the position is that of the whole plan within rounding.
TEST(PlanEdit, ACutKeepsPositions) {
  judge::Inputs inputs(31);
  const auto place = [](const Plan& plan, double time, std::size_t axis) {
    double found = no_end;
    for (const Leg& leg : legs_of(plan))
      if (leg.t <= time && time <= leg.until) {
        const double s = time - leg.t;
        found = leg.x[axis] + s * (leg.v[axis] + leg.a[axis] * s / 2);
      }
    return found;
  };
  int compared = 0;
  for (int i = judge::cases(2000); i > 0; --i) {
    Plan plan{.kind = PlanKind::accelerated, .axes = 3};
    plan.legs = testing::random_legs(inputs, inputs.between(1, 12), true, false);
    if (inputs.one_in(2)) {
      plan.kind = PlanKind::knots;
      for (const Leg& leg : plan.legs)
        if (plan.knots.empty() || plan.knots.back().t < leg.t) plan.knots.push_back({leg.t, leg.x});
      plan.legs.clear();
      if (plan.knots.size() < 2) continue;
    }
    const double from = inputs.number(-3, 6), to = from + std::abs(inputs.number(-3, 6));
    const auto part = cut_plan(plan, from, to);
    if (!part) continue;
    check_plan(*part);
    for (int k = 0; k < 5; ++k) {
      const double time = from + (to - from) * inputs.below(100) / 100.0;
      for (std::size_t j = 0; j < 3; ++j) {
        const double whole = place(plan, time, j), kept = place(*part, time, j);
        ASSERT_EQ(std::isfinite(whole), std::isfinite(kept)) << time;
        if (!std::isfinite(whole)) continue;
        ASSERT_NEAR(whole, kept, 1e-9) << time << ' ' << from << ' ' << to;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, judge::cases(2000) / 2);
}

}  // namespace
}  // namespace foresee
