// The sign of a polynomial at a root of a linear or quadratic one, beside the root to 1,500 bits.
#include "numbers/quadratic_root.h"

#include <gtest/gtest.h>

#include "numbers/factors.h"
#include "numbers/wide_numbers.h"

namespace foresee {
namespace {

using namespace judge;

Polynomial small_polynomial(Inputs& inputs, int degree, int bound) {
  Polynomial p;
  for (int k = 0; k <= degree; ++k) p.c[static_cast<std::size_t>(k)] = Dyadic(inputs.between(-bound, bound));
  return Polynomial(p.c);
}

/// The roots that p has: 0 the only one, or -1 and 1.
std::vector<int> roots_of(const Polynomial& p) {
  if (p.degree == 1) return {0};
  const int sign = discriminant(p).sign();
  if (sign < 0) return {};
  return sign == 0 ? std::vector<int>{0} : std::vector<int>{-1, 1};
}

void expect_signs(const Polynomial& q, const Polynomial& p) {
  for (const int which : roots_of(p))
    EXPECT_EQ(sign_at_root(q, p, which), sign_of(value_at(q, root_of(p, which))));
}

/// Coefficients so small that the two often have a root in common.
TEST(SignAtRoot, IsTheSignOfTheValue) {
  Inputs inputs(1);
  for (const int bound : {2, 5, 100000})
    for (int i = 0; i < cases(1000); ++i) {
      const Polynomial p = small_polynomial(inputs, inputs.between(1, 2), bound);
      if (p.degree < 1) continue;
      expect_signs(small_polynomial(inputs, inputs.between(0, 4), bound), p);
    }
}

TEST(SignAtRoot, OfAMultipleIsZero) {
  Inputs inputs(2);
  int double_roots = 0;
  for (int i = 0; i < cases(1000); ++i) {
    Polynomial p = small_polynomial(inputs, 2, 5);
    if (inputs.one_in(3)) p = multiplied(with_root(inputs.dyadic()), polynomial({inputs.number(-3, 3)}));
    if (inputs.one_in(3) && p.degree == 1) p = multiplied(p, p);
    if (p.degree < 1) continue;
    const Polynomial q = multiplied(p, small_polynomial(inputs, 4 - p.degree, 100));
    for (const int which : roots_of(p)) {
      EXPECT_EQ(sign_at_root(q, p, which), 0);
      double_roots += p.degree == 2 && which == 0;
    }
  }
  EXPECT_GT(double_roots, cases(1000) / 20);
  EXPECT_EQ(sign_at_root(Polynomial(), polynomial({-2, 0, 1}), 1), 0);
}

/// One root of p is a root of q, the other is not.
TEST(SignAtRoot, SeparatesTheTwoRoots) {
  const Polynomial p = multiplied(polynomial({-1, 1}), polynomial({-2, 1})), q = polynomial({-2, 1});
  for (const Polynomial& same : {p, negated(p)}) {
    EXPECT_EQ(sign_at_root(q, same, -1), -1);
    EXPECT_EQ(sign_at_root(q, same, 1), 0);
    EXPECT_EQ(sign_at_root(negated(q), same, -1), 1);
  }
}

/// x^2 - 2 - 2^-900 at the root of 2, and the root of (x - 1)^2 - 2^-900 beside 1.
TEST(SignAtRoot, SeesDifferencesFarBelowAnyDouble) {
  const Dyadic little = Dyadic::power_of_two(-900);
  const auto with_constant = [](const Dyadic& c, double b) {
    return Polynomial({c, Dyadic(b), Dyadic(1.0), Dyadic(), Dyadic()});
  };
  const Polynomial two = polynomial({-2, 0, 1});
  for (const int which : {-1, 1}) {
    EXPECT_EQ(sign_at_root(with_constant(Dyadic(-2.0) - little, 0), two, which), -1);
    EXPECT_EQ(sign_at_root(with_constant(Dyadic(-2.0) + little, 0), two, which), 1);
    EXPECT_EQ(sign_at_root(polynomial({-1, 1}), with_constant(Dyadic(1.0) - little, -2), which), which);
  }
}

TEST(SignAtRoot, ScalingByPositiveNumbersChangesNothing) {
  Inputs inputs(3);
  for (int i = 0; i < cases(500); ++i) {
    const Polynomial p = small_polynomial(inputs, 2, 4), q = small_polynomial(inputs, 4, 4);
    if (p.degree < 1) continue;
    const Polynomial by = polynomial({std::abs(inputs.number(-300, 300))});
    for (const int which : roots_of(p)) {
      EXPECT_EQ(sign_at_root(multiplied(q, by), p, which), sign_at_root(q, p, which));
      EXPECT_EQ(sign_at_root(q, multiplied(p, by), which), sign_at_root(q, p, which));
      EXPECT_EQ(sign_at_root(q, negated(p), which), sign_at_root(q, p, which));
      EXPECT_EQ(sign_at_root(negated(q), p, which), -sign_at_root(q, p, which));
    }
  }
}

}  // namespace
}  // namespace foresee
