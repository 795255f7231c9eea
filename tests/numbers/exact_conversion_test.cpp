// Conversions of doubles for code that is written once over several kinds of numbers: what they hold is the
// double.
#include "numbers/exact_conversion.h"

#include <gtest/gtest.h>

#include "numbers/bounded.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

TEST(Exactly, NumbersAndDifferencesAreThoseOfTheDoubles) {
  Inputs inputs(1);
  for (int i = 0; i < cases(1000); ++i) {
    const double a = inputs.number(-300, 300),
                 b = inputs.one_in(2) ? a * inputs.number(-2, 2) : inputs.number(-9, 9);
    const Rational gap = rational(a) - rational(b);
    const DoubleDouble pair = Exactly<DoubleDouble>::difference_of(a, b);
    EXPECT_EQ(rational(pair.high) + rational(pair.low), gap);
    EXPECT_EQ(Exactly<DoubleDouble>::number(a).high, a);
    EXPECT_EQ(Exactly<DoubleDouble>::number(a).low, 0);
    EXPECT_EQ(rational(Exactly<Dyadic>::difference_of(a, b)), gap);
    EXPECT_EQ(rational(Exactly<Dyadic>::number(a)), rational(a));
    EXPECT_TRUE(holds(Exactly<Midrad128>::difference_of(a, b), gap));
    EXPECT_TRUE(holds(Exactly<Midrad128>::number(a), rational(a)));
    const Bounded bounded = Exactly<Bounded>::difference_of(a, b);
    EXPECT_LE(abs(rational(bounded.value) - gap), rational(bounded.error_bound(0)));
    EXPECT_EQ(Exactly<Bounded>::number(a).error, 0);
  }
}

}  // namespace
}  // namespace foresee
