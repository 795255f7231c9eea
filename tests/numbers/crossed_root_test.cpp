// The Newton step with an error radius: a known instant is the exact one rounded once, all others are NaN.
#include "numbers/crossed_root.h"

#include <gtest/gtest.h>

#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

/// A parabola about `base`, exactly, and what the certain stage knows of it.
struct Parabola {
  Rational value, slope, bend;
  Crossed known;
};

/// Falls through 0 within some 2^-`digits` of the base, and turns slowly; known with errors.
Parabola falling(Inputs& inputs, int digits) {
  const double slope = -std::abs(inputs.number(-10, 10)),
               bend = slope * std::ldexp(inputs.number(-3, 3), -20);
  const DoubleDouble value = sum(slope * std::ldexp(inputs.number(0, 1), -digits), slope * 0x1p-100);
  const double value_error = inputs.one_in(2) ? 0x1p-988 : -slope * std::ldexp(0x1p-80, inputs.below(20));
  const double slope_error = -slope * std::ldexp(1, -inputs.between(30, 50));
  // The true one differs from what is known by as much as the errors allow.
  return {rational(value.high) + rational(value.low) + inputs.between(-1, 1) * rational(value_error),
          rational(slope) + inputs.between(-1, 1) * rational(slope_error),
          rational(bend),
          {value, value_error, slope, slope_error, std::abs(bend)}};
}

/// The exact sign at a distance from the base.
int sign_at(const Parabola& p, const Rational& s) {
  return Rational(p.value + s * (p.slope + s * p.bend)).sign();
}

/// Is `instant` the double nearest to origin + root, where p falls through 0 at its root?
bool is_nearest(const Parabola& p, const Rational& origin, double instant) {
  const double inf = std::numeric_limits<double>::infinity();
  const Rational x = rational(instant), before = rational(std::nextafter(instant, -inf)),
                 after = rational(std::nextafter(instant, inf));
  return sign_at(p, (before + x) / 2 - origin) >= 0 && sign_at(p, (x + after) / 2 - origin) <= 0;
}

TEST(CrossedRoot, KnownInstantsAreTheExactOnesRoundedOnce) {
  Inputs inputs(1);
  int known = 0, all = cases(4000);
  for (int i = 0; i < all; ++i) {
    const Parabola p = falling(inputs, inputs.between(15, 60));
    const double base = std::abs(inputs.number(-4, 4)), now = inputs.number(-4, 12);
    const Instant in = root_of<CrossingDirection::entering>(p.known, now, base, 0x1p-15);
    if (in.dt == in.dt) {
      EXPECT_TRUE(is_nearest(p, rational(base), in.dt));
    }
    if (in.t == in.t) {
      EXPECT_TRUE(is_nearest(p, rational(base) + rational(now), in.t));
    }
    known += in.known();
  }
  EXPECT_GT(known, all / 2);
}

/// Out of -p is into p.
TEST(CrossedRoot, LeavingIsEnteringOfTheNegative) {
  Inputs inputs(2);
  for (int i = 0; i < cases(1000); ++i) {
    const Crossed p = falling(inputs, 40).known;
    const Crossed negative{-p.value, p.value_error, -p.slope, p.slope_error, p.bend};
    const Instant in = root_of<CrossingDirection::entering>(p, 7, 3, 0x1p-15),
                  out = root_of<CrossingDirection::leaving>(negative, 7, 3, 0x1p-15);
    EXPECT_EQ(in.known(), out.known());
    if (!in.known()) continue;
    EXPECT_EQ(in.dt, out.dt);
    EXPECT_EQ(in.t, out.t);
  }
}

/// Where the slope may vanish within reach there may be a second root, or none.
TEST(CrossedRoot, IsUnknownWhereTheSlopeMayVanish) {
  const DoubleDouble value{0x1p-50, 0};
  const auto entered = [&](double slope, double slope_error, double bend, double width) {
    return root_of<CrossingDirection::entering>({value, 0x1p-988, slope, slope_error, bend}, 0, 1, width)
        .known();
  };
  EXPECT_TRUE(entered(-1, 0x1p-40, 0x1p-10, 0x1p-40));
  EXPECT_FALSE(entered(-1, 0x1p-40, 1, 1)) << "turns within the width";
  EXPECT_FALSE(entered(-1, 0.75, 0, 0x1p-40)) << "the slope is hardly known";
  EXPECT_FALSE(entered(1, 0x1p-40, 0, 0x1p-40)) << "rises";
  EXPECT_FALSE(entered(0, 0, 0, 0x1p-40)) << "is level";
  EXPECT_FALSE(entered(-0x1p-49, 0, 1, 0x1p-60)) << "turns before it reaches 0";
  EXPECT_FALSE(entered(-0x1p1010, 0, 0, 0x1p-40)) << "the inverse underflows";
}

TEST(CrossedRoot, IsUnknownWhereTheErrorReachesATie) {
  const double ulp = 0x1p-52;
  const auto entered = [&](double step, double error) {
    return root_of<CrossingDirection::entering>({{step, 0}, error, -1, 0x1p-900, 0}, 0, 1, ulp);
  };
  EXPECT_EQ(entered(0.25 * ulp, 0x1p-80).dt, 1);
  EXPECT_EQ(entered(0.75 * ulp, 0x1p-80).dt, 1 + ulp);
  EXPECT_FALSE(entered(0.5 * ulp, 0x1p-80).known());
  EXPECT_FALSE(entered(0.375 * ulp, 0.25 * ulp).known());
}

/// The radius has room for the rounding of step +- radius.
TEST(RoundedInstant, EveryNumberWithinTheRadiusRoundsToIt) {
  Inputs inputs(3);
  int known = 0, all = cases(2000);
  for (int i = 0; i < all; ++i) {
    const double now = inputs.number(-6, 12), base = std::abs(inputs.number(-6, 6));
    const double step = inputs.number(-60, -4),
                 radius = std::abs(step) * std::ldexp(1, -inputs.between(3, 50));
    const Instant instant = rounded_instant(now, base, step, radius);
    known += instant.known();
    const Rational rounding = rational(std::abs(step)) * power_of_two(-52);
    for (const int side : {-1, 0, 1}) {
      const Rational s = rational(step) + side * (rational(radius) - rounding), dt = rational(base) + s;
      if (instant.dt == instant.dt) {
        EXPECT_EQ(instant.dt, nearest_double(dt));
      }
      if (instant.t == instant.t) {
        EXPECT_EQ(instant.t, nearest_double(dt + rational(now)));
      }
    }
  }
  EXPECT_GT(known, all / 4);
}

}  // namespace
}  // namespace foresee
