// The interval Newton method: the root is never lost, and the bracket ends as narrow as the length allows.
#include "numbers/interval_newton.h"

#include <gtest/gtest.h>

#include "numbers/factors.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

/// A polynomial that changes its sign once between low and high.
struct Bracketed {
  Polynomial p;
  Dyadic low, high;
};

struct Narrowed {
  Dyadic low, high;
};

/// In 128 bits, or in as many as wanted.
Narrowed narrowed(const Bracketed& b, int bits) {
  const int sign_low = sign_at(b.p, b.low);
  if (bits == 128) {
    Coefficients<Midrad128> c;
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = Midrad128(b.p.c[k]);
    const Midrad128 low(b.low), high(b.high);
    const IntervalNewton<Midrad128> n(c, b.p.degree, low, high, sign_low, bits);
    return {n.low.dyadic(), n.high.dyadic()};
  }
  Coefficients<Midrad> c;
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = Midrad(b.p.c[k], bits);
  const IntervalNewton<Midrad> n(c, b.p.degree, b.low, b.high, sign_low, bits);
  return {n.low, n.high};
}

/// The ends have the signs that the root leaves and enters with, or are the root.
void expect_root(const Bracketed& b, int bits, int lost) {
  const auto [low, high] = narrowed(b, bits);
  EXPECT_LE(b.low, low);
  EXPECT_LE(low, high);
  EXPECT_LE(high, b.high);
  const int before = sign_at(b.p, b.low);
  EXPECT_TRUE(sign_at(b.p, low) == before || sign_at(b.p, low) == 0);
  EXPECT_TRUE(sign_at(b.p, high) == -before || sign_at(b.p, high) == 0);
  if (low < high) {
    EXPECT_LE((high - low).magnitude(), high.magnitude() + lost - bits);
  }
}

/// Roots of other factors are negative or complex: the slope may vanish between.
Bracketed with_one_root(Inputs& inputs, const Dyadic& root) {
  Polynomial p = multiplied(with_root(root), polynomial({inputs.number(-20, 20)}));
  while (p.degree < 4 && !inputs.one_in(4)) {
    const double size = std::abs(inputs.number(-4, 4)) * std::ldexp(1, root.magnitude());
    const Polynomial other = polynomial({size, 1}),
                     none = polynomial({size * size, size * inputs.between(-1, 1), 1});
    p = multiplied(p, p.degree <= 2 && inputs.one_in(2) ? none : other);
  }
  const Dyadic low = inputs.one_in(3) ? Dyadic() : root - root.scaled(-inputs.below(60) - 1);
  return {p, low, root + root.scaled(inputs.between(-60, 6))};
}

TEST(IntervalNewton, NeverLosesTheRootAndClosesIn) {
  Inputs inputs(1);
  for (int i = 0; i < cases(500); ++i) {
    const Dyadic root(std::abs(inputs.number(-60, 60)));
    const Bracketed b = with_one_root(inputs, root);
    expect_root(b, 128, 40);
    expect_root(b, 512, 40);
    const auto [low, high] = narrowed(b, 256);
    EXPECT_TRUE(low <= root && root <= high);
  }
}

/// x^k - c, whose roots no number of finite length is.
TEST(IntervalNewton, EnclosesIrrationalRoots) {
  Inputs inputs(2);
  for (int i = 0; i < cases(300); ++i) {
    const double c = 2 + 4 * inputs.below(1000);
    const Polynomial p = inputs.one_in(2)   ? polynomial({-c, 0, 1})
                         : inputs.one_in(2) ? polynomial({-c, 0, 0, 1})
                                            : polynomial({c, 0, 0, 0, -1});
    const Bracketed b{p, Dyadic(inputs.one_in(2) ? 0.0 : 1.0), Dyadic(c)};
    expect_root(b, 128, 30);
    expect_root(b, 512, 30);
    expect_root(b, 2048, 30);
  }
}

/// Halving the bracket itself would take thousands of steps.
TEST(IntervalNewton, FindsRootsNextToZero) {
  for (const int exponent : {-100, -1000, -5000}) {
    const Dyadic root = Dyadic::power_of_two(exponent) * Dyadic(3.0);
    const Bracketed b{multiplied(with_root(root), polynomial({5, 2, 0, 1})), Dyadic(), Dyadic(7.0)};
    expect_root(b, 128, 40);
    expect_root(b, 512, 40);
  }
}

/// Two roots 2^-40 apart: only one of them is between the ends.
TEST(IntervalNewton, FindsARootBesideAnother) {
  const Dyadic root(3.0), other = root - Dyadic(0x1p-40);
  const Bracketed b{multiplied(with_root(root), with_root(other)), root - Dyadic(0x1p-41), Dyadic(8.0)};
  expect_root(b, 128, 60);
  expect_root(b, 512, 60);
}

/// Known only to some digits: the bracket keeps every root that the enclosed polynomials have.
TEST(IntervalNewton, RoughCoefficientsKeepAllRoots) {
  const Midrad128 rough = Midrad128::hull(Midrad128(2.0), Midrad128(2 + 0x1p-30));
  const Coefficients<Midrad128> c{-rough, Midrad128(), Midrad128(1.0), Midrad128(), Midrad128()};
  const IntervalNewton<Midrad128> n(c, 2, Midrad128(), Midrad128(2.0), -1, 128);
  EXPECT_LE(n.low.dyadic() * n.low.dyadic(), Dyadic(2.0));
  EXPECT_GE(n.high.dyadic() * n.high.dyadic(), Dyadic(2 + 0x1p-30));
  EXPECT_LE((n.high - n.low).dyadic(), Dyadic(0x1p-28));
}

TEST(Around, IsTheSamePolynomialSeenFromElsewhere) {
  Inputs inputs(3);
  for (int i = 0; i < cases(300); ++i) {
    Coefficients<Dyadic> p;
    for (Dyadic& c : p) c = inputs.dyadic(-20, 20);
    const int degree = inputs.between(0, 4);
    const Dyadic x = inputs.dyadic(-20, 20), distance = inputs.dyadic(-20, 20);
    const Dyadic here = value_at(around(p, degree, x), degree, distance),
                 there = value_at(p, degree, x + distance);
    EXPECT_TRUE(here == there);
  }
  EXPECT_EQ(value_at(Coefficients<Dyadic>{}, -1, Dyadic(5.0)).sign(), 0);
}

}  // namespace
}  // namespace foresee
