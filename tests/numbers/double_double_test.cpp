// Sums of two doubles: what is exact, and how near the rest is to the exact result.
#include "numbers/double_double.h"

#include <gtest/gtest.h>

#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

Rational exact(const DoubleDouble& a) {
  return rational(a.high) + rational(a.low);
}

/// Some 106 bits; now and then a double, or one with a gap between its parts.
DoubleDouble any(Inputs& inputs, int lower, int upper) {
  const double high = inputs.number(lower, upper);
  if (inputs.one_in(8)) return {high, 0};
  return sum(high, std::ldexp(high, -inputs.between(53, 90)) * inputs.number(-1, 0));
}

void expect_near(const DoubleDouble& result, const Rational& right) {
  EXPECT_LE(abs(exact(result) - right), abs(right) * power_of_two(-102)) << result.high;
  EXPECT_EQ(result.high, result.high + result.low) << "the high part is not the nearest double";
}

TEST(DoubleDouble, SumAndDifferenceOfTwoDoublesAreExact) {
  Inputs inputs(1);
  for (int i = 0; i < cases(4000); ++i) {
    double a = inputs.any_double() / 2, b = inputs.any_double() / 2;
    if (inputs.one_in(2)) b = a * inputs.number(-60, 60);
    if (!std::isfinite(a + b) || !std::isfinite(a - b)) continue;
    EXPECT_EQ(exact(sum(a, b)), rational(a) + rational(b)) << a << ' ' << b;
    EXPECT_EQ(exact(difference(a, b)), rational(a) - rational(b)) << a << ' ' << b;
    const double more = std::max(std::abs(a), std::abs(b)), less = std::min(std::abs(a), std::abs(b));
    EXPECT_EQ(exact(ordered_sum(more, -less)), rational(more) - rational(less));
    EXPECT_EQ(exact(ordered_sum(0, less)), rational(less));
  }
}

TEST(DoubleDouble, HighPartIsTheRoundedResult) {
  Inputs inputs(2);
  for (int i = 0; i < cases(500); ++i) {
    const double a = inputs.number(-30, 30), b = inputs.number(-30, 30);
    EXPECT_EQ(sum(a, b).high, nearest_double(rational(a) + rational(b)));
    EXPECT_EQ(product(a, b).high, nearest_double(rational(a) * rational(b)));
  }
}

/// Down to products of 2^-968, whose last bit is the smallest double.
TEST(DoubleDouble, ProductOfTwoDoublesIsExactUnlessItUnderflows) {
  Inputs inputs(3);
  for (int i = 0; i < cases(4000); ++i) {
    const int middle = inputs.between(-480, 480);
    const double a = inputs.number(middle - 2, middle + 2), b = inputs.number(middle - 2, middle + 2);
    EXPECT_EQ(exact(product(a, b)), rational(a) * rational(b)) << a << ' ' << b;
  }
  const double all_bits = 0x1.fffffffffffffp0;
  EXPECT_EQ(exact(product(all_bits, all_bits)), rational(all_bits) * rational(all_bits));
  EXPECT_EQ(exact(product(-0.0, all_bits)), 0);
}

TEST(DoubleDouble, OperationsAreWithinTheirPromise) {
  Inputs inputs(4);
  for (int i = 0; i < cases(3000); ++i) {
    const DoubleDouble a = any(inputs, -100, 100), b = any(inputs, -100, 100);
    expect_near(a + b, exact(a) + exact(b));
    expect_near(a - b, exact(a) - exact(b));
    expect_near(a * b, exact(a) * exact(b));
    expect_near(a / b, exact(a) / exact(b));
    EXPECT_EQ(exact(-a), -exact(a));
    EXPECT_EQ(exact(half_of(a)), exact(a) / 2);
  }
}

/// The high parts cancel, or all but the last bits of them.
TEST(DoubleDouble, SumsThatCancelKeepTheirPromise) {
  Inputs inputs(5);
  for (int i = 0; i < cases(3000); ++i) {
    const DoubleDouble a = any(inputs, -100, 100);
    DoubleDouble b = any(inputs, 0, 0);
    const double nearly = a.high * (1 + inputs.between(-3, 3) * 0x1p-52);
    b = sum(-nearly, b.low * std::abs(a.high));
    expect_near(a + b, exact(a) + exact(b));
    expect_near(b - a, exact(b) - exact(a));
    expect_near(a - a, 0);
  }
}

TEST(DoubleDouble, OverflowEndsInNaN) {
  const double huge = 0x1p1023;
  const DoubleDouble a{huge, 0}, b{0x1p600, 0};
  EXPECT_TRUE(std::isnan((a + a).high));
  EXPECT_TRUE(std::isnan((-a - a).high));
  EXPECT_TRUE(std::isnan((b * b).high));
  EXPECT_TRUE(std::isnan((a / DoubleDouble{0x1p-600, 0}).high));
}

TEST(DoubleDouble, IsSymmetricUnderNegationAndExchange) {
  Inputs inputs(6);
  const auto same = [](const DoubleDouble& a, const DoubleDouble& b) {
    return a.high == b.high && a.low == b.low;
  };
  for (int i = 0; i < cases(1000); ++i) {
    const DoubleDouble a = any(inputs, -200, 200), b = any(inputs, -200, 200);
    EXPECT_TRUE(same(a + b, b + a));
    EXPECT_TRUE(same(a * b, b * a));
    EXPECT_TRUE(same(-(a + b), -a - b));
    EXPECT_TRUE(same(-(a / b), -a / b));
  }
}

}  // namespace
}  // namespace foresee
