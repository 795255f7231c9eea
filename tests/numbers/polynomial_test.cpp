// Exact polynomials, and whether two have a common root: by factors that are known.
#include "numbers/polynomial.h"

#include <gtest/gtest.h>

#include "numbers/factors.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

TEST(Polynomial, DegreeIsThatOfTheLastCoefficientThatIsNotZero) {
  EXPECT_EQ(Polynomial().degree, -1);
  EXPECT_EQ(polynomial({}).degree, -1);
  EXPECT_EQ(polynomial({0, -0.0, 0}).degree, -1);
  EXPECT_EQ(polynomial({5e-324}).degree, 0);
  EXPECT_EQ(polynomial({0, 0, 0, 0, -5e-324}).degree, 4);
  EXPECT_EQ(polynomial({1, 2, 3, 0, 0}).degree, 2);
}

TEST(Polynomial, ValueAndDerivativeAreExact) {
  Inputs inputs(1);
  for (int i = 0; i < cases(500); ++i) {
    Polynomial p;
    for (Dyadic& c : p.c) c = inputs.dyadic();
    p = Polynomial(p.c);
    const Dyadic x = inputs.dyadic(-50, 50);
    Rational value, slope, power = 1;
    for (int k = 0; k <= p.degree; ++k, power *= rational(x)) {
      value += rational(p.c[k]) * power;
      if (k < p.degree) slope += (k + 1) * rational(p.c[k + 1]) * power;
    }
    EXPECT_EQ(rational(value_at(p, x)), value);
    EXPECT_EQ(sign_at(p, x), value.sign());
    EXPECT_EQ(rational(value_at(derivative(p), x)), slope);
    EXPECT_EQ(derivative(p).degree, std::max(p.degree - 1, -1));
    EXPECT_EQ(rational(discriminant(p)),
              rational(p.c[1]) * rational(p.c[1]) - 4 * rational(p.c[0]) * rational(p.c[2]));
  }
}

/// Is a = constant b, not 0?
bool is_multiple(const Polynomial& a, const Polynomial& b) {
  if (a.degree < 0 || a.degree != b.degree) return false;
  for (int k = 0; k <= a.degree; ++k)
    if (!(a.c[k] * b.c[b.degree] == b.c[k] * a.c[a.degree])) return false;
  return true;
}

/// Linear and quadratic factors, none of which divides another.
std::vector<Polynomial> all_factors() {
  std::vector<Polynomial> all;
  for (int root = -3; root <= 3; ++root) all.push_back(polynomial({-1.0 * root, 1}));
  all.insert(all.end(),
             {polynomial({-1, 3}), polynomial({1, 0x1p-40}), polynomial({-2, 0, 1}), polynomial({1, 0, 1}),
              polynomial({-3, 0, 1}), polynomial({1, 1, 3}), polynomial({-0x1p60, 1})});
  return all;
}

/// A constant times factors drawn from what is left, up to a degree.
Polynomial drawn_product(Inputs& inputs, std::vector<Polynomial>& left, int max_degree) {
  Polynomial product = polynomial({inputs.number(-3, 3)});
  for (int tries = 0; tries < 4; ++tries) {
    const int place = inputs.below(static_cast<int>(left.size()));
    if (product.degree + left[place].degree > max_degree) continue;
    product = multiplied(product, left[place]);
    left.erase(left.begin() + place);
  }
  return product;
}

TEST(CommonDivisor, IsTheProductOfTheCommonFactors) {
  Inputs inputs(2);
  int nontrivial = 0;
  for (int i = 0; i < cases(1000); ++i) {
    std::vector<Polynomial> left = all_factors();
    const Polynomial common = drawn_product(inputs, left, inputs.between(0, 3)),
                     a = multiplied(common,
                                    drawn_product(inputs, left, Polynomial::max_degree - common.degree)),
                     b = multiplied(common,
                                    drawn_product(inputs, left, Polynomial::max_degree - common.degree));
    EXPECT_TRUE(is_multiple(common_divisor(a, b), common));
    EXPECT_TRUE(is_multiple(common_divisor(b, a), common));
    // Quick, and here no chance makes it miss the proof.
    EXPECT_EQ(surely_coprime(a, b), common.degree == 0);
    EXPECT_EQ(surely_coprime(b, a), common.degree == 0);
    nontrivial += common.degree > 0;
  }
  EXPECT_GT(nontrivial, cases(1000) / 4);
}

TEST(Polynomial, CommonRootsAreFound) {
  const Polynomial p = polynomial({-2, 0, 1}), same = polynomial({6, 0, -3}), apart = polynomial({-3, 0, 1});
  EXPECT_TRUE(surely_coprime(p, apart));
  EXPECT_FALSE(surely_coprime(p, same));
  EXPECT_EQ(common_divisor(p, same).degree, 2);
  EXPECT_EQ(common_divisor(polynomial({2, -3, 1}), polynomial({-2, 1, 1})).degree, 1);  // both are 0 at 1
  EXPECT_EQ(common_divisor(p, apart).degree, 0);
}

TEST(CommonDivisor, OfRepeatedFactorsHasTheLesserMultiplicity) {
  const Polynomial once = polynomial({-5, 1}), twice = multiplied(once, once),
                   thrice = multiplied(twice, once);
  EXPECT_TRUE(is_multiple(common_divisor(thrice, twice), twice));
  EXPECT_TRUE(is_multiple(common_divisor(thrice, derivative(thrice)), twice));
  EXPECT_TRUE(is_multiple(common_divisor(once, multiplied(twice, twice)), once));
}

TEST(CommonDivisor, OfZeroIsTheOther) {
  const Polynomial p = polynomial({-2, 0, 1});
  EXPECT_TRUE(is_multiple(common_divisor(p, Polynomial()), p));
  EXPECT_TRUE(is_multiple(common_divisor(Polynomial(), p), p));
  EXPECT_FALSE(surely_coprime(p, Polynomial()));
  EXPECT_EQ(common_divisor(p, polynomial({7})).degree, 0);
  EXPECT_TRUE(surely_coprime(p, polynomial({7})));
}

/// Roots 2^-900 apart are different roots.
TEST(SurelyCoprime, SeparatesRootsThatAreAlmostEqual) {
  const Dyadic two(2.0), almost = two + Dyadic::power_of_two(-900);
  EXPECT_TRUE(surely_coprime(with_root(two), with_root(almost)));
  EXPECT_EQ(common_divisor(with_root(two), with_root(almost)).degree, 0);
}

/// Modulo the prime P both lose their leading coefficient, and with it the common root 1/P.
TEST(SurelyCoprime, ProvesNothingWhereLeadingCoefficientsVanish) {
  const Dyadic prime(Integer((Integer(1) << 61) - 1), 0);
  const Polynomial common({Dyadic(-1.0), prime, Dyadic(), Dyadic(), Dyadic()});
  const Polynomial a = multiplied(common, polynomial({-2, 1})), b = multiplied(common, polynomial({-3, 1}));
  EXPECT_FALSE(surely_coprime(a, b));
  EXPECT_TRUE(is_multiple(common_divisor(a, b), common));
}

}  // namespace
}  // namespace foresee
