// The legs of a turn against the arc in 300 bits.
#include "motion/plan/arc.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>

#include "base/error.h"
#include "motion/plan/plan_legs.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

using Long = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<300, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;
/// Where the mover is at `time`: on the arc up to `end`, then straight on.
std::array<Long, 2> true_place(const TurnManoeuvre& turn, double end, const Long& time) {
  const Long radians = boost::math::constants::pi<Long>() / 180 * Long(turn.rate);
  const Long tau = (time < Long(end) ? time : Long(end)) - Long(turn.t), rest = time - Long(turn.t) - tau;
  const Long s = sin(radians * tau), c = cos(radians * tau), vx = turn.v[0], vy = turn.v[1];
  const Long half = sin(radians * tau / 2), versed = 2 * half * half;
  return {Long(turn.x[0]) + (vx * s + vy * versed) / radians + rest * (vx * c + vy * s),
          Long(turn.x[1]) + (vy * s - vx * versed) / radians + rest * (vy * c - vx * s)};
}

Long square_of_distance(const TurnManoeuvre& turn, double end, const Leg& leg, const Long& time) {
  const Long s = time - Long(leg.t);
  const std::array<Long, 2> place = true_place(turn, end, time);
  Long square = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const Long away = Long(leg.x[j]) + s * (Long(leg.v[j]) + s * Long(leg.a[j]) / 2) - place[j];
    square += away * away;
  }
  return square;
}

/// The largest distance to the arc, at many times of some thirty legs.
Long largest_distance(const TurnManoeuvre& turn, const Plan& plan) {
  const double end = turn.t + turn.duration;
  Long largest = 0;
  const std::size_t step = plan.legs.size() / 30 + 1;
  for (std::size_t i = 0; i < plan.legs.size(); i += i + step < plan.legs.size() ? step : 1) {
    const Leg& leg = plan.legs[i];
    const double until = std::isfinite(leg.until) ? leg.until : leg.t;
    for (int k = 0; k <= 16; ++k) {
      const Long time = Long(leg.t) + (Long(until) - Long(leg.t)) * k / 16;
      largest = std::max(largest, square_of_distance(turn, end, leg, time));
    }
  }
  return sqrt(largest);
}

TEST(Arc, LegsAreWithinTheError) {
  judge::Inputs inputs(21);
  Long tightest = 0;
  for (int i = judge::cases(150); i > 0; --i) {
    TurnManoeuvre turn{.t = inputs.number(-9, 31), .x = {inputs.number(-9, 30), inputs.number(-9, 30)}};
    turn.v = {inputs.number(-9, 12), inputs.number(-9, 12)};
    turn.rate = inputs.number(-8, 6), turn.duration = std::abs(inputs.number(-4, 9));
    turn.until = inputs.one_in(3) ? no_end : turn.t + turn.duration + std::abs(inputs.number(-3, 9));
    const double radius = std::hypot(turn.v[0], turn.v[1]) / std::abs(turn.rate * 0.0174533);
    double error = radius * std::ldexp(1, -inputs.between(-2, 14));
    Plan plan;
    try {
      plan = turn_plan(turn, error);
    } catch (const Error&) {
      error = 1, plan = turn_plan(turn, error);
    }
    check_plan(plan);
    const Long away = largest_distance(turn, plan);
    ASSERT_LE(away, Long(error)) << turn.t << ' ' << turn.rate << ' ' << turn.duration << ' ' << error;
    if (plan.legs.size() > 4) tightest = std::max(tightest, Long(away / error));
  }
  if (!testing::sanitized) {  // few cases then
    EXPECT_GT(tightest, 0.95);
  }
}

/// Errors close to what doubles can prove.
TEST(Arc, RoundingsAreWithinTheError) {
  judge::Inputs inputs(22);
  for (int i = judge::cases(40); i > 0; --i) {
    TurnManoeuvre turn{.t = inputs.number(-9, 20), .x = {inputs.number(-9, 30), inputs.number(-9, 30)}};
    turn.v = {inputs.number(-3, 6), inputs.number(-3, 6)};
    turn.rate = inputs.number(-3, 3), turn.duration = std::abs(inputs.number(-4, 4));
    turn.until = turn.t + turn.duration + std::abs(inputs.number(-3, 3));
    std::string message;
    double error = 1e-300;
    for (int tries = 0; tries < 100; ++tries) try {
        const Plan plan = turn_plan(turn, error);
        ASSERT_LE(largest_distance(turn, plan), Long(error));
        break;
      } catch (const Error&) {
        error = error < 1e-30 ? 1e-17 : error * 2;
      }
  }
}

TEST(Arc, ARightAngleOfAKilometreWithinAMetreHasFourLegs) {
  const double speed = 1000 * 0.0174532925199433 * 3;
  const TurnManoeuvre turn{.t = 0, .x = {0, 0}, .v = {0, speed}, .rate = 3, .duration = 30, .until = 30};
  const Plan plan = turn_plan(turn, 1);
  EXPECT_EQ(plan.legs.size(), 4u);
  EXPECT_EQ(plan.axes, 2);
  EXPECT_EQ(plan.kind, PlanKind::accelerated);
  EXPECT_EQ(turn_plan(turn, 1000).legs.size(), 1u);
  EXPECT_NEAR(static_cast<double>(true_place(turn, 30, Long(30))[0]), 1000, 1e-9);
}

TEST(Arc, GoesStraightBehindTheTurn) {
  const TurnManoeuvre turn{.t = 100, .x = {5, 7}, .v = {0, 10}, .rate = 9, .duration = 10, .until = no_end};
  const Leg last = turn_plan(turn, 0.5).legs.back();
  EXPECT_EQ(last.t, 110);
  EXPECT_EQ(last.until, no_end);
  EXPECT_NEAR(last.v[0], 10, 1e-12);
  EXPECT_NEAR(last.v[1], 0, 1e-12);
  EXPECT_EQ(last.a, (std::array<double, 3>{}));
}

TEST(Arc, WithoutTurnOrSpeedIsOneLeg) {
  const TurnManoeuvre straight{.t = 1, .x = {2, 3}, .v = {4, 5}, .rate = 0, .duration = 6, .until = 99};
  const Plan plan = turn_plan(straight, 1e-9);
  ASSERT_EQ(plan.legs.size(), 1u);
  EXPECT_EQ(plan.legs[0], (Leg{1, 99, {2, 3}, {4, 5}, {}}));
  const TurnManoeuvre resting{.t = 1, .x = {2, 3}, .v = {0, 0}, .rate = 9, .duration = 6};
  EXPECT_EQ(turn_plan(resting, 1e-9).legs[0], (Leg{1, no_end, {2, 3}, {}, {}}));
}

std::string refusal_of_turn(const TurnManoeuvre& turn, double error) {
  try {
    turn_plan(turn, error);
  } catch (const Error& refused) {
    return refused.what();
  }
  return "";
}

TEST(Arc, SaysWhatIsWrong) {
  TurnManoeuvre turn{.t = 100, .x = {5, 7}, .v = {0, 10}, .rate = 9, .duration = 10, .until = 120};
  EXPECT_EQ(refusal_of_turn(turn, 1), "");
  EXPECT_EQ(refusal_of_turn(turn, 1e-20).substr(0, 57),
            "error is 1e-20: the doubles of this turn prove no less th");
  turn.until = 109;
  EXPECT_EQ(refusal_of_turn(turn, 1),
            "until is 109, before the turn ends at 110: write a later time, or NULL");
  turn.until = 120, turn.duration = 0;
  EXPECT_EQ(refusal_of_turn(turn, 1), "duration is 0: write a number greater than 0");
  turn.duration = 1, turn.t = 1e300;
  EXPECT_EQ(refusal_of_turn(turn, 1),
            "duration is 1: at t = 1e+300 no double holds the end of the turn; count t from a later origin");
  turn.t = 0, turn.rate = 1e300;
  EXPECT_EQ(refusal_of_turn(turn, 1),
            "rate is 1e+300: the turn has more than 1e12 degrees; write degrees per unit of time");
  turn.rate = 5730, turn.v = {0, 1000}, turn.duration = 10000, turn.until = 10001;
  EXPECT_EQ(
      refusal_of_turn(turn, 0.001),
      "error is 0.001: the turn needs more than 1048575 legs; write a larger error, or a shorter duration");
}

}  // namespace
}  // namespace foresee
