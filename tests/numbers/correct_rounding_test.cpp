// Rotated vectors and quotients are rounded once; the quick sine and cosine keep their error bound.
#include "numbers/correct_rounding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

TEST(TurnedVector, IsExactAtRightAngles) {
  for (const double turns : {-1.0, 0.0, 1.0}) {
    const auto is = [&](double degrees, double x, double y) {
      const Turned turned = turned_clockwise(0.1, 0.3, degrees);
      EXPECT_EQ(turned.x, x);
      EXPECT_EQ(turned.y, y);
    };
    if (turns <= 0) is(360 * turns, 0.1, 0.3), is(360 * turns + 90, 0.3, -0.1);
    if (turns >= 0 && turns < 1) is(180, -0.1, -0.3), is(270, -0.3, 0.1);
  }
  const Turned stopped = turned_clockwise(0, -0.0, 33);
  EXPECT_FALSE(std::signbit(stopped.x) || std::signbit(stopped.y));
}

TEST(TurnedVector, IsTheExactOneRoundedOnce) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double x = random.in(-9, 9), y = random.in(-9, 9), degrees = random.in(-45, 45);
    const Turned turned = turned_clockwise(x, y, degrees);
    const SineCosine<Midrad> at = sine_cosine(degrees, 1024);
    const auto exact = [&](double along, double across) {
      return Midrad(Dyadic(along), 1024) * at.cosine + Midrad(Dyadic(across), 1024) * at.sine;
    };
    EXPECT_EQ(turned.x, rounded(exact(x, y).middle()));
    EXPECT_EQ(turned.y, rounded(exact(y, -x).middle()));
  }
}

TEST(TurnedVector, HalvesAtSixtyDegrees) {
  EXPECT_EQ(turned_clockwise(0, 7, 60).y, 3.5);
  EXPECT_EQ(turned_clockwise(0, 7, 30).x, 3.5);
}

TEST(RoundedQuotient, TakesTiesToEven) {
  const Dyadic one(1.0), ulp(0x1p-52), half(0x1p-53);
  EXPECT_EQ(rounded_quotient((one + half) * Dyadic(3.0), Dyadic(3.0)), 1);
  EXPECT_EQ(rounded_quotient((one + ulp + half) * Dyadic(3.0), Dyadic(3.0)), 1 + 0x1p-51);
  EXPECT_EQ(rounded_quotient((one + half + Dyadic(0x1p-600)) * Dyadic(3.0), Dyadic(3.0)), 1 + 0x1p-52);
  EXPECT_EQ(rounded_quotient(Dyadic(-1.0), Dyadic(3.0)), -1.0 / 3.0);
  EXPECT_FALSE(std::signbit(rounded_quotient(Dyadic(0.0), Dyadic(3.0))));
}

TEST(RoundedRoot, TakesTiesToEven) {
  EXPECT_EQ(rounded_root(Dyadic(2.0)), std::sqrt(2.0));
  EXPECT_EQ(rounded_root(Dyadic(0x1p-1074)), 0x1p-537);
  EXPECT_EQ(rounded_root(Dyadic(0.0)), 0);
  EXPECT_EQ(rounded_root(Dyadic(-1.0)), 0);
  const Dyadic one(1.0), ulp(0x1p-52), half(0x1p-53), little(0x1p-900);
  const auto square = [](const Dyadic& root) { return root * root; };
  EXPECT_EQ(rounded_root(square(one + half)), 1);
  EXPECT_EQ(rounded_root(square(one + ulp + half)), 1 + 0x1p-51);
  EXPECT_EQ(rounded_root(square(one + half) + little), 1 + 0x1p-52);
  EXPECT_EQ(rounded_root(square(one + ulp + half) - little), 1 + 0x1p-52);
}

TEST(QuickSineCosine, IsWithinItsErrorBound) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const double degrees = random.in(-720, 720), quarters = std::rint(degrees / 90);
    const SineCosine<double> quick = quick_sine_cosine(degrees);
    const SineCosine<Midrad128> exact = sine_cosine(degrees - 90 * quarters);
    double sine = exact.sine.rounded(), cosine = exact.cosine.rounded();
    for (int quarter = 0; quarter < (static_cast<int>(quarters) & 3); ++quarter) {
      const double before = sine;
      sine = cosine, cosine = -before;
    }
    EXPECT_NEAR(quick.sine, sine, quick_sine_error / 4);
    EXPECT_NEAR(quick.cosine, cosine, quick_sine_error / 4);
  }
}

TEST(QuickSinc, IsWithinItsErrorBound) {
  EXPECT_EQ(quick_sinc(0), 1);
  EXPECT_EQ(quick_sinc(180), 0);
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const double degrees = random.in(0.001, 1) * std::exp2(i % 12);
    const Turned exact = turned_clockwise(0, 1, std::fmod(degrees, 360));  // (sine, cosine), each rounded
    EXPECT_NEAR(quick_sinc(degrees), exact.x / (degrees * radians_per_degree), 2 * quick_sine_error)
        << degrees;
    EXPECT_EQ(quick_sinc(-degrees), quick_sinc(degrees)) << degrees;
  }
}

TEST(QuickTurned, IsNearTheExactVectorAtAnyAngle) {
  EXPECT_EQ(quick_turned(0, 5, 90 + 360 * 1000.0).x, 5);
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.in(-9, 9), y = random.in(-9, 9), degrees = random.in(-5000, 5000);
    const Turned quick = quick_turned(x, y, degrees), exact = turned_clockwise(x, y, std::fmod(degrees, 360));
    const double error = 2 * quick_sine_error * (std::abs(x) + std::abs(y));
    EXPECT_NEAR(quick.x, exact.x, error) << degrees;
    EXPECT_NEAR(quick.y, exact.y, error) << degrees;
  }
}

TEST(QuickDegrees, AreTheAngle) {
  for (double degrees = -179.75; degrees <= 180; degrees += 0.25)
    EXPECT_NEAR(quick_degrees(quick_sine_cosine(degrees)), degrees, 1e-12);
  EXPECT_EQ(quick_degrees({0, 1}), 0);
  EXPECT_EQ(quick_degrees({0, -1}), 180);
}

}  // namespace
}  // namespace foresee
