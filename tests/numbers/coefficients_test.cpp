// Twice and square of every number type: exact where the type is, else they hold the exact number. Those of
// Bounded are in bounded_test.cpp.
#include "numbers/coefficients.h"

#include <gtest/gtest.h>

#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

TEST(Coefficients, TwiceAndSquareAreExactWhereTheNumbersAre) {
  Inputs inputs(1);
  for (int i = 0; i < cases(500); ++i) {
    const Dyadic a = inputs.dyadic();
    EXPECT_EQ(rational(twice(a)), 2 * rational(a));
    EXPECT_EQ(rational(square(a)), rational(a) * rational(a));
    EXPECT_TRUE(holds(twice(Midrad128(a)), 2 * rational(a)));
    EXPECT_TRUE(holds(square(Midrad(a, 100)), rational(a) * rational(a)));
    const DoubleDouble pair = sum(inputs.number(-5, 5), inputs.number(-60, -55)), doubled = twice(pair);
    EXPECT_EQ(rational(doubled.high) + rational(doubled.low), 2 * (rational(pair.high) + rational(pair.low)));
  }
}

}  // namespace
}  // namespace foresee
