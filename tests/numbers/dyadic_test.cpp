// Exact numbers m 2^e: their arithmetic and order beside rational numbers, and the one rounding to a double.
#include "numbers/dyadic.h"

#include <gtest/gtest.h>

#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = 5e-324;
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Dyadic, HoldsEveryDoubleExactly) {
  Inputs inputs(1);
  for (int i = 0; i < cases(2000); ++i) {
    const double x = inputs.any_double();
    EXPECT_EQ(rational(Dyadic(x)), rational(x)) << x;
    EXPECT_EQ(rounded(Dyadic(x)), x);
  }
  EXPECT_EQ(Dyadic(-0.0).sign(), 0);
  EXPECT_EQ(Dyadic(-smallest).sign(), -1);
}

TEST(Dyadic, SumsAndProductsAreExact) {
  Inputs inputs(2);
  for (int i = 0; i < cases(2000); ++i) {
    const Dyadic a = inputs.dyadic(-300, 300), b = inputs.dyadic(-300, 300);
    const Rational exact_a = rational(a), exact_b = rational(b);
    const int shift = inputs.between(-3000, 3000);
    EXPECT_EQ(rational(a + b), exact_a + exact_b);
    EXPECT_EQ(rational(a - b), exact_a - exact_b);
    EXPECT_EQ(rational(a * b), exact_a * exact_b);
    EXPECT_EQ(rational(-a), -exact_a);
    EXPECT_EQ(rational(half_of(a)), exact_a / 2);
    EXPECT_EQ(rational(a.scaled(shift)), exact_a * power_of_two(shift));
    EXPECT_EQ((a - a).sign(), 0);
  }
}

/// Numbers of few digits, so that many are equal and have different exponents.
TEST(Dyadic, OrderIsThatOfTheRationals) {
  Inputs inputs(3);
  for (int i = 0; i < cases(4000); ++i) {
    const auto few_digits = [&] { return Dyadic(Integer(inputs.between(-8, 8)), inputs.between(-2, 2)); };
    const Dyadic a = few_digits(), b = few_digits();
    EXPECT_EQ(a == b, rational(a) == rational(b));
    EXPECT_EQ(a < b, rational(a) < rational(b));
    EXPECT_EQ(a <= b, rational(a) <= rational(b));
  }
}

TEST(Dyadic, ReducedHasAnOddMantissaAndTheSameValue) {
  Inputs inputs(4);
  EXPECT_EQ(Dyadic(Integer(0), 77).reduced().exponent(), 0);
  for (int i = 0; i < cases(1000); ++i) {
    const Dyadic a = inputs.dyadic() * Dyadic(Integer(1) << inputs.below(300), 5), reduced = a.reduced();
    EXPECT_EQ(rational(reduced), rational(a));
    if (a.sign() != 0) {
      EXPECT_TRUE(bit_test(abs(reduced.mantissa()), 0));
    }
  }
}

TEST(Dyadic, MagnitudeIsTheFloorOfTheBinaryLogarithm) {
  Inputs inputs(5);
  for (int i = 0; i < cases(1000); ++i) {
    const Dyadic a = inputs.dyadic();
    if (a.sign() == 0) continue;
    const Rational size = abs(rational(a));
    EXPECT_LE(power_of_two(a.magnitude()), size);
    EXPECT_LT(size, power_of_two(a.magnitude() + 1));
  }
  EXPECT_EQ(Dyadic(-8.0).magnitude(), 3);
  EXPECT_EQ(Dyadic(smallest).magnitude(), -1074);
}

TEST(Dyadic, RoundsToTheNearestDouble) {
  Inputs inputs(6);
  for (int i = 0; i < cases(1000); ++i) {
    const int top = inputs.between(-1100, 1030);
    const Dyadic a = inputs.dyadic(top - 120, top);
    EXPECT_EQ(rounded(a), nearest_double(rational(a)));
    EXPECT_EQ(rounded(-a), -rounded(a));
  }
}

/// Halfway between neighbours anywhere in the range, and less than 2^-2000 of it away.
TEST(Dyadic, RoundsTiesToEvenAndNothingElse) {
  Inputs inputs(7);
  for (int i = 0; i < cases(500); ++i) {
    const double x = std::abs(inputs.any_double()), y = std::nextafter(x, infinity);
    const Dyadic tie = half_of(Dyadic(x) + (y < infinity ? Dyadic(y) : Dyadic::power_of_two(1024)));
    const Dyadic little = tie.scaled(-2000);
    const bool is_even = std::bit_cast<std::uint64_t>(x) % 2 == 0;
    EXPECT_EQ(rounded(tie), is_even ? x : y) << x;
    EXPECT_EQ(rounded(tie + little), y) << x;
    EXPECT_EQ(rounded(tie - little), x) << x;
    EXPECT_EQ(rounded(-tie), is_even ? -x : -y) << x;
  }
}

TEST(Dyadic, RoundsToInfinityFromHalfAnUlpBeyondTheLargest) {
  const Dyadic half_ulp = Dyadic::power_of_two(970), limit = Dyadic(largest) + half_ulp;
  EXPECT_EQ(rounded(limit), infinity);
  EXPECT_EQ(rounded(limit - Dyadic(smallest)), largest);
  EXPECT_EQ(rounded(-limit), -infinity);
  EXPECT_EQ(rounded(Dyadic::power_of_two(100000)), infinity);
}

TEST(Dyadic, RoundsToZeroUpToHalfTheSmallestDouble) {
  const Dyadic half = Dyadic::power_of_two(-1075);
  EXPECT_EQ(rounded(half), 0);
  EXPECT_EQ(rounded(half + half.scaled(-200)), smallest);
  EXPECT_EQ(rounded(half + half + half), 2 * smallest);
  EXPECT_EQ(rounded(Dyadic::power_of_two(-1076)), 0);
  EXPECT_EQ(rounded(-Dyadic::power_of_two(-100000)), 0);
  EXPECT_FALSE(std::signbit(rounded(-half)));
}

/// Also beyond the 1024 bits that live inside an Integer.
TEST(Integer, LengthAndZerosAreThoseOfTheBinaryDigits) {
  EXPECT_EQ(bit_length(Integer(0)), 0);
  for (int exponent = 0; exponent < 2500; exponent += 13) {
    const Integer power = Integer(1) << exponent;
    EXPECT_EQ(bit_length(power), exponent + 1);
    EXPECT_EQ(bit_length(-power), exponent + 1);
    EXPECT_EQ(bit_length(power - 1), exponent);
    EXPECT_EQ(zeros_of(power), exponent);
    EXPECT_EQ(zeros_of(-3 * power), exponent);
  }
}

TEST(Integer, WithoutLastCutsTowardsZero) {
  Inputs inputs(8);
  for (int i = 0; i < cases(2000); ++i) {
    const Integer number = inputs.dyadic(-400, 400).mantissa();
    const int bits = inputs.below(600);
    const Whole size(abs(number)), cut(abs(without_last(number, bits)));
    EXPECT_EQ(cut, size >> bits);
    EXPECT_TRUE(cut == 0 || (without_last(number, bits) < 0) == (number < 0));
  }
}

/// Whose lowest word is 1: >> of Boost 1.74 makes it positive.
TEST(Integer, CutNegativeNumbersRemainNegative) {
  const Integer number = -((Integer(5) << 128) + 1);
  EXPECT_EQ(without_last(number, 3), -(Integer(5) << 125));
}

}  // namespace
}  // namespace foresee
