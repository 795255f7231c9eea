// Doubles with an error bound: the exact number is within the bound, and the bound is not much larger than
// the roundings.
#include "numbers/bounded.h"

#include <gtest/gtest.h>

#include "numbers/coefficients.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

/// An expression as Bounded computes it, and its exact value.
struct Number {
  Bounded bounded;
  Rational exact;
};

constexpr double lost = 0x1p-1000;  ///< more than underflow can take from what is tested here

::testing::AssertionResult is_within(const Bounded& b, const Rational& exact) {
  if (abs(rational(b.value) - exact) <= rational(b.error_bound(lost))) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << b.value << " is off by more than " << b.error_bound(lost);
}

Number leaf(Inputs& inputs) {
  const double value = inputs.number(-20, 20);
  if (inputs.one_in(2)) return {{value, 0}, rational(value)};
  const double error = std::ldexp(std::abs(value), -inputs.between(20, 60));
  // As far off as it may be.
  return {{value, error}, rational(value) + rational(inputs.sign() * error)};
}

bool surely_not_zero(const Bounded& b) {
  return std::abs(b.value) > 2 * b.error;
}

Number bounded_expression(Inputs& inputs, int depth) {
  if (depth == 0) return leaf(inputs);
  const Number a = bounded_expression(inputs, depth - 1), b = bounded_expression(inputs, depth - 1);
  switch (inputs.below(6)) {
    case 0:
      return {a.bounded + b.bounded, a.exact + b.exact};
    case 1:
      return {a.bounded - b.bounded, a.exact - b.exact};
    case 2:
      return {square(a.bounded), a.exact * a.exact};
    case 3:
      return {twice(-a.bounded), -2 * a.exact};
    case 4:
      if (surely_not_zero(b.bounded)) return {a.bounded / b.bounded, a.exact / b.exact};
      [[fallthrough]];
    default:
      return {a.bounded * b.bounded, a.exact * b.exact};
  }
}

TEST(Bounded, ExactNumberIsWithinTheBound) {
  Inputs inputs(1);
  for (int depth = 1; depth <= 4; ++depth)
    for (int i = 0; i < cases(3000 >> depth); ++i) {
      const Number n = bounded_expression(inputs, depth);
      EXPECT_TRUE(is_within(n.bounded, n.exact));
    }
}

/// One operation at a time, with all errors to the side where they add up.
TEST(Bounded, EachOperationCoversTheWorstErrors) {
  Inputs inputs(2);
  for (int i = 0; i < cases(1000); ++i) {
    const Bounded a = leaf(inputs).bounded, b = leaf(inputs).bounded;
    for (const int side_a : {-1, 1})
      for (const int side_b : {-1, 1}) {
        const Rational x = rational(a.value) + side_a * rational(a.error),
                       y = rational(b.value) + side_b * rational(b.error);
        EXPECT_TRUE(is_within(a + b, x + y));
        EXPECT_TRUE(is_within(a - b, x - y));
        EXPECT_TRUE(is_within(a * b, x * y));
        EXPECT_TRUE(is_within(a / b, x / y));
        EXPECT_TRUE(is_within(square(a), x * x));
      }
  }
}

TEST(Bounded, RootCoversTheWorstErrors) {
  Inputs inputs(3);
  for (int i = 0; i < cases(1000); ++i) {
    Bounded a = leaf(inputs).bounded;
    a.value = std::abs(a.value);
    const Bounded root = sqrt(a);
    const Rational error = rational(root.error_bound(lost)), value = rational(root.value);
    const Rational low = value - error, high = value + error;
    EXPECT_LE(low * low, rational(a.value) - rational(a.error));
    EXPECT_GE(high * high, rational(a.value) + rational(a.error));
  }
}

TEST(Bounded, BoundOfExactArgumentsIsHalfAnUlp) {
  Inputs inputs(4);
  for (int i = 0; i < cases(1000); ++i) {
    const Bounded a{inputs.number(-20, 20), 0}, b{inputs.number(-20, 20), 0};
    for (const Bounded& result : {a + b, a - b, a * b, a / b, square(a)})
      EXPECT_EQ(result.error, unit_roundoff * std::abs(result.value));
    EXPECT_EQ(twice(a).error, 0);
    EXPECT_EQ((-a).error, 0);
  }
}

TEST(Bounded, BoundContainsWhatUnderflowLoses) {
  const double tiny = 0x1p-600;
  const Bounded product = Bounded{tiny, 0} * Bounded{tiny, 0};
  EXPECT_EQ(product.value, 0);
  EXPECT_TRUE(is_within(product, rational(tiny) * rational(tiny)));
  EXPECT_GE(Bounded{}.error_bound(lost), lost);
}

}  // namespace
}  // namespace foresee
