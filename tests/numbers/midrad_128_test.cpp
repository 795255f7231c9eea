// Ball arithmetic of 128 bits: balls contain the exact number, short numbers remain exact, midpoints are
// rounded correctly.
#include "numbers/midrad_128.h"

#include <gtest/gtest.h>

#include <functional>

#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

/// A ball and a number that it must hold.
struct Held {
  Midrad128 ball;
  Rational number;
};

/// Exact, cut, or as wide as a few digits.
Held held(Inputs& inputs) {
  const Dyadic number = inputs.one_in(2) ? inputs.dyadic(-60, 60) : Dyadic(inputs.number(-60, 60));
  if (!inputs.one_in(3) || number.sign() == 0) return {Midrad128(number), rational(number)};
  const Dyadic size = number.sign() < 0 ? -number : number, more = size + size.scaled(-inputs.below(100));
  Midrad128 ball = Midrad128::hull(Midrad128(inputs.one_in(8) ? Dyadic() : size), Midrad128(more));
  return {number.sign() < 0 ? -ball : ball, rational(number)};
}

Held ball_expression(Inputs& inputs, int depth) {
  if (depth == 0) return held(inputs);
  const Held a = ball_expression(inputs, depth - 1), b = ball_expression(inputs, depth - 1);
  const int sign_b = b.ball.sign();
  switch (inputs.below(6)) {
    case 0:
      return {a.ball + b.ball, a.number + b.number};
    case 1:
      return {a.ball - b.ball, a.number - b.number};
    case 2:
      return {half_of(-a.ball), -a.number / 2};
    case 3:
      if (sign_b != 0 && sign_b != unknown_sign) return {a.ball / b.ball, a.number / b.number};
      [[fallthrough]];
    default:
      return {a.ball * b.ball, a.number * b.number};
  }
}

TEST(Midrad128, HoldsEveryDoubleExactly) {
  Inputs inputs(1);
  for (int i = 0; i < cases(1000); ++i) {
    const double x = inputs.any_double();
    const Midrad128 ball(x);
    EXPECT_TRUE(ball.exact());
    EXPECT_EQ(rational(ball.dyadic()), rational(x));
    EXPECT_EQ(ball.rounded(), x);
    EXPECT_EQ(ball.sign(), (x > 0) - (x < 0));
    if (x != 0) {
      EXPECT_EQ(ball.magnitude(), std::ilogb(x));
    }
  }
}

TEST(Midrad128, CutsLongNumbersWithinAUnit) {
  Inputs inputs(2);
  int cut = 0;
  for (int i = 0; i < cases(1000); ++i) {
    const Dyadic number = inputs.dyadic();
    const Midrad128 ball(number);
    EXPECT_TRUE(holds(ball, rational(number)));
    EXPECT_LE(width_of(ball), abs(rational(number)) * power_of_two(-126));
    cut += !ball.exact();
    if (number.sign() == 0 || bit_length(number.reduced().mantissa()) <= 128) {
      EXPECT_TRUE(ball.exact());
    }
  }
  EXPECT_GT(cut, cases(1000) / 4);
}

TEST(Midrad128, HoldsWhatExpressionsAreExactly) {
  Inputs inputs(3);
  int wide = 0;
  for (int depth = 1; depth <= 4; ++depth)
    for (int i = 0; i < cases(4000 >> depth); ++i) {
      const auto [ball, number] = ball_expression(inputs, depth);
      EXPECT_TRUE(holds(ball, number));
      if (ball.exact()) {
        EXPECT_EQ(rational(ball.dyadic()), number);
      }
      if (ball.sign() != unknown_sign) {
        EXPECT_EQ(ball.sign(), number.sign());
      }
      wide += ball.sign() == unknown_sign;
    }
  EXPECT_GT(wide, cases(100));
}

/// The worst that the operands may be: their ends.
TEST(Midrad128, OperationsHoldTheResultsOfAllEnds) {
  Inputs inputs(4);
  for (int i = 0; i < cases(1000); ++i) {
    const Midrad128 a = held(inputs).ball, b = ball_expression(inputs, 1).ball;
    const bool divides = b.sign() != 0 && b.sign() != unknown_sign;
    for (const Rational& x : {low_of(a), high_of(a)})
      for (const Rational& y : {low_of(b), high_of(b)}) {
        EXPECT_TRUE(holds(a + b, x + y));
        EXPECT_TRUE(holds(a - b, x - y));
        EXPECT_TRUE(holds(a * b, x * y));
        if (divides) {
          EXPECT_TRUE(holds(a / b, x / y));
        }
      }
  }
}

TEST(Midrad128, RootHoldsTheRootsOfBothEnds) {
  Inputs inputs(5);
  for (int i = 0; i < cases(1000); ++i) {
    Midrad128 square = ball_expression(inputs, 1).ball;
    if (square.side() < 0) square = -square;
    if (square.sign() == unknown_sign) continue;
    const Midrad128 root = sqrt(square);
    EXPECT_TRUE(low_of(root) <= 0 || low_of(root) * low_of(root) <= low_of(square));
    EXPECT_GE(high_of(root) * high_of(root), high_of(square));
  }
}

TEST(Midrad128, NumbersThatFitRemainExact) {
  Inputs inputs(6);
  for (int i = 0; i < cases(1000); ++i) {
    const Midrad128 a(inputs.number(-500, 500)), b(inputs.number(-500, 500));
    EXPECT_TRUE(same(a * b, b * a));
    EXPECT_TRUE((a * b).exact());
    EXPECT_TRUE(same(a * b / b, a));
    EXPECT_TRUE(same(sqrt(a * a), a.side() < 0 ? -a : a));
    EXPECT_EQ((a - a).sign(), 0);
    EXPECT_TRUE((a + a.scaled(70)).exact());
    EXPECT_FALSE((a + a.scaled(200)).exact());
  }
}

TEST(Midrad128, QuotientsAndRootsAreNarrow) {
  Inputs inputs(7);
  for (int i = 0; i < cases(500); ++i) {
    const Midrad128 a(std::abs(inputs.number(-100, 100))), b(inputs.number(-100, 100));
    const Midrad128 quotient = a / b, root = sqrt(a);
    EXPECT_LE(width_of(quotient), abs(rational(quotient.dyadic())) * power_of_two(-118));
    EXPECT_LE(width_of(root), abs(rational(root.dyadic())) * power_of_two(-118));
    EXPECT_LE(width_of(quotient * root), abs(rational((quotient * root).dyadic())) * power_of_two(-117));
    EXPECT_LE(width_of(quotient + root),
              (abs(rational(quotient.dyadic())) + rational(root.dyadic())) * power_of_two(-117));
  }
}

TEST(Midrad128, HullHoldsBothAndIsHardlyWider) {
  Inputs inputs(8);
  for (int i = 0; i < cases(1000); ++i) {
    Dyadic lowest = Dyadic(std::abs(inputs.number(-90, 90))),
           highest = lowest + Dyadic(std::abs(inputs.number(-90, 90)));
    if (inputs.one_in(10)) lowest = Dyadic();
    const Midrad128 hull = Midrad128::hull(Midrad128(lowest), Midrad128(highest));
    EXPECT_TRUE(holds(hull, rational(lowest)));
    EXPECT_TRUE(holds(hull, rational(highest)));
    EXPECT_LE(width_of(hull),
              rational(highest - lowest) * (1 + power_of_two(-40)) + rational(highest) * power_of_two(-120));
    EXPECT_TRUE(same(Midrad128::hull(Midrad128(1.5), Midrad128(1.5)), Midrad128(1.5)));
  }
}

/// Ties, subnormal results and overflow, also of midpoints that have an error.
TEST(Midrad128, MidpointsRoundToTheNearestDouble) {
  Inputs inputs(9);
  for (int i = 0; i < cases(1000); ++i) {
    const int top = inputs.between(-1100, 1030);
    Midrad128 ball(inputs.dyadic(top - 120, top));
    if (inputs.one_in(2)) ball = ball + Midrad128(std::ldexp(1, -53)) * ball.middle();
    EXPECT_EQ(ball.rounded(), nearest_double(rational(ball.dyadic())));
  }
  const auto rounded = [](double x, double part) { return (Midrad128(x) + Midrad128(part)).rounded(); };
  EXPECT_EQ(rounded(1, 0x1p-53), 1);
  EXPECT_EQ(rounded(1 + 0x1p-52, 0x1p-53), 1 + 0x1p-51);
  EXPECT_EQ(rounded(1, 0x1.8p-53), 1 + 0x1p-52);
  EXPECT_EQ(Midrad128(0x1.8p-1074).scaled(-1).rounded(), 5e-324);
  EXPECT_EQ(Midrad128(5e-324).scaled(-1).rounded(), 0);
  EXPECT_EQ(Midrad128(-0x1.8p-1074).scaled(-100000).rounded(), 0);
  EXPECT_EQ(Midrad128(1.0).scaled(100000).rounded(), std::numeric_limits<double>::infinity());
}

/// Of a subnormal result, beside a tie by less than a double of 53 bits could tell: rounding twice would be
/// wrong.
TEST(Midrad128, MidpointsRoundOnceToSubnormals) {
  Inputs inputs(10);
  for (int i = 0; i < cases(200); ++i) {
    const double x = std::ldexp(inputs.between(0, 1 << inputs.between(0, 30)), -1074);
    const Midrad128 tie = Midrad128(x) + Midrad128(5e-324).scaled(-1), little = Midrad128(5e-324).scaled(-90);
    for (const Midrad128& ball : {tie, tie + little, tie - little, -tie, -tie - little})
      EXPECT_EQ(ball.rounded(), nearest_double(rational(ball.dyadic())));
  }
}

/// 128 bits of ones and an error of two: the upper end needs a bit more than there are.
TEST(Midrad128, EndsAreMovedOutwardWhereTheyDoNotFit) {
  const Dyadic ones(Integer((Integer(1) << 129) - 1), 0);
  const Midrad128 ball = Midrad128(ones) + Midrad128(0x1p-200);
  const Rational middle = rational(ball.dyadic());
  EXPECT_GT(middle - low_of(ball), 0);
  EXPECT_GE(high_of(ball) - middle, middle - low_of(ball));
  EXPECT_EQ(low_of(-ball), -high_of(ball));
}

TEST(Midrad128, SameIsOfNumbersAndIdenticalOfBalls) {
  const Midrad128 two(2.0), third = Midrad128(1.0) / Midrad128(3.0);
  EXPECT_TRUE(same(two, Midrad128(1.0).scaled(1)));
  EXPECT_TRUE(same(Midrad128(0.0), -Midrad128(-0.0)));
  EXPECT_FALSE(same(two, -two));
  EXPECT_FALSE(same(third, third));
  EXPECT_TRUE(identical(third, third));
  EXPECT_FALSE(identical(third, third.middle()));
  EXPECT_FALSE(identical(third, third.scaled(1)));
  EXPECT_EQ((third - third).sign(), unknown_sign);
}

}  // namespace
}  // namespace foresee
