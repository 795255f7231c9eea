// Sine and cosine beside the same numbers to 1,500 bits.
#include "numbers/sine_cosine.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <random>

namespace foresee {
namespace {

using namespace judge;

/// The ball holds the number, and is narrow.
void expect_holds(const Dyadic& low, const Dyadic& high, const Wide& number, int bits) {
  EXPECT_LE(wide(low), number);
  EXPECT_LE(number, wide(high));
  EXPECT_LE(wide(high - low), ldexp(abs(number), -bits));
}

void expect_close(double degrees) {
  const Wide angle = Wide(degrees) * boost::math::constants::pi<Wide>() / 180, s = sin(angle), c = cos(angle);
  const SineCosine<Midrad128> quick = sine_cosine(degrees);
  expect_holds(quick.sine.low().dyadic(), quick.sine.high().dyadic(), s, 107);
  expect_holds(quick.cosine.low().dyadic(), quick.cosine.high().dyadic(), c, 107);
  const SineCosine<Midrad> close = sine_cosine(degrees, 512);
  expect_holds(close.sine.low(), close.sine.high(), s, 470);
  expect_holds(close.cosine.low(), close.cosine.high(), c, 470);
}

TEST(SineCosine, HoldTheRealNumbers) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> degrees(-45, 45);
  for (int i = 0; i < 100; ++i) expect_close(degrees(random));
}

TEST(SineCosine, HoldThemAtTheEnds) {
  for (const double degrees : {45.0, -45.0, 30.0, -30.0, 1.0, 1e-9, std::nextafter(45, 0), 1e-30})
    expect_close(degrees);
}

}  // namespace
}  // namespace foresee
