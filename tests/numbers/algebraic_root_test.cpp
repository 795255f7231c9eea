// Roots as exact numbers: their order, signs of other polynomials there and the nearest double, beside the
// same roots to 1,500 bits.
#include "numbers/algebraic_root.h"

#include <gtest/gtest.h>

#include "numbers/factors.h"
#include "numbers/wide_numbers.h"

namespace foresee {
namespace {

using namespace judge;

/// A root, its polynomial, and what it is to 1,500 bits.
struct Judged {
  std::unique_ptr<ExactSource> source;
  AlgebraicRoot* root;
  Wide value;

  LazyPolynomial& lazy() { return source->lazy(); }
};

/// The root of p that is `value` >= 0, enclosed within 2^-`digits` of it or so. Requires: digits <= 50.
Judged judged(const Polynomial& p, const Wide& value, int which, int digits) {
  Judged j{std::make_unique<ExactSource>(p, digits), nullptr, value};
  const Dyadic near(value.convert_to<double>()),
      off = (near.sign() == 0 ? Dyadic(1.0) : near).scaled(-digits);
  const Dyadic low = near < off ? Dyadic() : near - off, high = near + off;
  j.root = p.degree <= 2 ? &j.lazy().add_root(which, Midrad128::hull(Midrad128(low), Midrad128(high)))
                         : &j.lazy().add_root(low, high, sign_at(p, low));
  return j;
}

/// The k-th root of m, in several ways; `which` as degree 1 and 2 want it.
std::vector<Judged> roots_of_number(double m, int k, int digits) {
  std::vector<Judged> all;
  Polynomial p;
  p.c[0] = Dyadic(-m), p.c[static_cast<std::size_t>(k)] = Dyadic(1.0);
  p = Polynomial(p.c);
  const Wide value = k == 1 ? Wide(m) : k == 2 ? sqrt(Wide(m)) : k == 3 ? cbrt(Wide(m)) : sqrt(sqrt(Wide(m)));
  all.push_back(judged(p, value, k == 2, digits));
  all.push_back(judged(negated(p), value, k == 2, digits));
  if (k == 1) all.push_back(judged(multiplied(p, p), value, 0, digits));
  if (k < 4) all.push_back(judged(multiplied(p, polynomial({1, 1})), value, 1, digits));
  if (k == 1) all.push_back(judged(multiplied(p, polynomial({-100, 1})), value, -1, digits));
  if (k < 3) all.push_back(judged(multiplied(p, polynomial({0.125, 0.5, 1})), value, 1, digits));
  return all;
}

/// Of numbers so small that many are equal, such as 16^(1/4) = 4^(1/2) = 2.
std::vector<Judged> many_roots(int digits) {
  std::vector<Judged> all;
  for (const double m : {1.0, 2.0, 4.0, 5.0, 8.0, 9.0, 16.0})
    for (int k = 1; k <= 4; ++k)
      for (Judged& root : roots_of_number(m, k, digits)) all.push_back(std::move(root));
  return all;
}

constexpr int rough_digits[] = {12, 48};

TEST(AlgebraicRoot, OrderIsThatOfTheNumbers) {
  for (const int digits : rough_digits) {
    std::vector<Judged> all = many_roots(digits);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < all.size(); ++j) {
        const int right = sign_of(all[i].value - all[j].value);
        EXPECT_EQ(compare(*all[i].root, *all[j].root), right) << all[i].value << ' ' << all[j].value;
        EXPECT_EQ(compare(*all[j].root, *all[i].root), -right) << all[i].value << ' ' << all[j].value;
      }
  }
}

/// Between numbers that are known: each double beside the root, and the root if it is one.
TEST(AlgebraicRoot, OrderAmongDoublesIsThatOfTheNumbers) {
  for (Judged& j : many_roots(20))
    for (int step = -2; step <= 2; ++step) {
      const double near = j.value.convert_to<double>() * (1 + step * 0x1p-52);
      const int right = sign_of(j.value - Wide(near));
      EXPECT_EQ(compare(*j.root, Dyadic(near)), right) << j.value;
      const Dyadic number(near);
      AlgebraicRoot known(number);
      EXPECT_EQ(compare(*j.root, known), right);
      EXPECT_EQ(compare(known, *j.root), -right);
    }
}

/// x^2 = 2 and x^2 = 2 + 2^-900, and 2^-600 beside the root.
TEST(AlgebraicRoot, OrderSeesDifferencesFarBelowAnyDouble) {
  const Wide root = sqrt(Wide(2));
  const Dyadic more = Dyadic(2.0) + Dyadic::power_of_two(-900);
  const Polynomial two = polynomial({-2, 0, 1}), above({-more, Dyadic(), Dyadic(1.0), Dyadic(), Dyadic()});
  const Dyadic cut(Integer(ldexp(root, 600).convert_to<Whole>()), -600);
  for (const int digits : rough_digits) {
    Judged x = judged(two, root, 1, digits), y = judged(above, sqrt(wide(more)), 1, digits);
    EXPECT_EQ(compare(*x.root, *y.root), -1);
    EXPECT_EQ(compare(*y.root, *x.root), 1);
    EXPECT_EQ(compare(*x.root, cut), 1);
    EXPECT_EQ(compare(*x.root, cut + Dyadic::power_of_two(-600)), -1);
    for (const Polynomial& factor :
         {polynomial({1}), polynomial({1, 1}), polynomial({1, 0, 1}), polynomial({1, 1, 1, 1})}) {
      Judged z = judged(multiplied(with_root(cut), factor), wide(cut), factor.degree == 0 ? 0 : 1, digits);
      EXPECT_EQ(compare(*x.root, *z.root), 1) << factor.degree;
      EXPECT_EQ(compare(*z.root, *y.root), -1) << factor.degree;
    }
  }
}

TEST(AlgebraicRoot, SignsOfOtherPolynomialsAreThoseOfTheValues) {
  for (const int digits : rough_digits) {
    std::vector<Judged> all = many_roots(digits), others = many_roots(30);
    for (Judged& j : all)
      for (Judged& other : others) {
        const Polynomial& q = other.source->polynomial();
        EXPECT_EQ(other.lazy().sign_at(*j.root), sign_of(value_at(q, j.value))) << j.value;
      }
    for (Judged& j : all) {
      EXPECT_EQ(j.lazy().sign_at(*j.root), 0);
      EXPECT_EQ(j.lazy().slope().sign_at(*j.root),
                sign_of(value_at(derivative(j.source->polynomial()), j.value)));
    }
  }
}

/// Two polynomials have the root 1 in common, but the sign is computed at a root 2^-40 beside it.
TEST(AlgebraicRoot, SignsBesideACommonRootAreNotZero) {
  const Dyadic one(1.0);
  for (const Polynomial& factor : {polynomial({1}), polynomial({1, 1}), polynomial({1, 0, 1})})
    for (const int side : {-1, 1}) {
      const Dyadic beside = one + Dyadic(side * 0x1p-40);
      const Polynomial p = multiplied(multiplied(with_root(one), with_root(beside)), factor);
      Judged j{std::make_unique<ExactSource>(p, 30), nullptr, wide(beside)};
      const Dyadic low = beside - Dyadic(0x1p-41), high = beside + Dyadic(0x1p-41);
      j.root = p.degree <= 2 ? &j.lazy().add_root(side, Midrad128::hull(Midrad128(one - Dyadic(0x1p-20)),
                                                                        Midrad128(one + Dyadic(0x1p-20))))
                             : &j.lazy().add_root(low, high, sign_at(p, low));
      for (const Polynomial& other : {with_root(Dyadic(3.0)), polynomial({1, 1, 1, 1})}) {
        ExactSource q(multiplied(with_root(one), other), 12);
        EXPECT_EQ(q.lazy().sign_at(*j.root), sign_of(value_at(q.polynomial(), j.value))) << p.degree;
      }
    }
}

TEST(AlgebraicRoot, RoundsToTheNearestDouble) {
  Inputs inputs(1);
  for (const int digits : rough_digits)
    for (Judged& j : many_roots(digits)) {
      const Dyadic offset(inputs.one_in(4) ? 0 : inputs.number(-60, 60));
      EXPECT_EQ(rounded(*j.root, offset), nearest_double(rational(j.value) + rational(offset)));
    }
}

/// Exactly between two doubles, by polynomials of every degree, and 2^-700 beside that.
TEST(AlgebraicRoot, RoundsTiesToEvenAndNothingElse) {
  const Polynomial factors[] = {polynomial({1}), polynomial({1, 1}), polynomial({1, 0, 1}),
                                polynomial({1, 1, 1, 1})};
  for (const double even : {1.0, 1 + 0x1p-51})
    for (const int side : {-1, 1})
      for (const Polynomial& factor : factors) {
        const double ulp = even == 1 && side < 0 ? 0x1p-53 : 0x1p-52;
        const Dyadic tie = Dyadic(even) + Dyadic(side * ulp / 2), little = Dyadic::power_of_two(-700);
        const auto nearest = [&](const Dyadic& root, const Dyadic& offset) {
          Judged j = judged(multiplied(with_root(root), factor), wide(root), factor.degree == 0 ? 0 : 1, 40);
          return rounded(*j.root, offset);
        };
        EXPECT_EQ(nearest(tie, Dyadic()), even);
        EXPECT_EQ(nearest(tie + little, Dyadic()), side < 0 ? even : even + ulp);
        EXPECT_EQ(nearest(tie - little, Dyadic()), side < 0 ? even - ulp : even);
        EXPECT_EQ(nearest(tie + Dyadic(8.0), Dyadic(-8.0)), even);
      }
}

TEST(AlgebraicRoot, EnclosuresHoldItAndNarrowWithTheirLength) {
  for (const int digits : rough_digits)
    for (Judged& j : many_roots(digits))
      for (const int bits : {512, 256, 1024}) {
        const Midrad enclosure = j.root->enclosure(bits);
        const Wide low = wide(enclosure.low()), high = wide(enclosure.high()),
                   rounding = ldexp(j.value, -1400);
        EXPECT_LE(low - rounding, j.value);
        EXPECT_LE(j.value, high + rounding);
        EXPECT_LE(high - low, ldexp(j.value, 24 - bits / 2)) << bits;
      }
}

TEST(AlgebraicRoot, RecognizesNumbersOfFewDigits) {
  const auto recognized = [](const Polynomial& p, const Wide& value, int digits = 50) {
    Judged j = judged(p, value, 0, digits);
    j.root->recognize();
    if (j.root->known) {
      EXPECT_EQ(wide(*j.root->known), value);
    }
    return j.root->known != nullptr;
  };
  EXPECT_TRUE(recognized(multiplied(with_root(Dyadic(0.375)), polynomial({1, 0, 1})), Wide(0.375)));
  EXPECT_TRUE(recognized(multiplied(with_root(Dyadic(600.0)), polynomial({1, 1, 1, 1})), Wide(600)));
  EXPECT_FALSE(recognized(polynomial({-2, 0, 0, 1}), cbrt(Wide(2))));
  // 2 is in the bracket, and is not the root.
  EXPECT_FALSE(recognized(polynomial({-8 - 0x1p-36, 0, 0, 1}), cbrt(Wide(8 + 0x1p-36)), 30));
  EXPECT_FALSE(recognized(multiplied(polynomial({-1, 3}), polynomial({1, 0, 1})), Wide(1) / 3));
}

/// 128 bits of the leading coefficient show only that it is about 0.
TEST(LazyPolynomial, DegreeIsThatOfTheExactPolynomial) {
  const ExactSource source(polynomial({-3, 2}));
  const Midrad128 about_zero = Midrad128::hull(Midrad128(), Midrad128(2.0)) - Midrad128(1.0);
  LazyPolynomial::RoughCoefficients rough{Midrad128(-3.0), Midrad128(2.0), about_zero, about_zero,
                                          about_zero};
  LazyPolynomial lazy(rough, source, 0);
  EXPECT_EQ(lazy.degree(), 1);
  EXPECT_EQ(lazy.lead(), 1);
  EXPECT_TRUE(same(lazy.rough()[2], Midrad128()));
  ExactSource zero(Polynomial{});
  EXPECT_EQ(zero.lazy().degree(), -1);
  EXPECT_EQ(zero.lazy().lead(), 0);
  EXPECT_EQ(zero.lazy().sign_at(Dyadic(7.0)), 0);
}

TEST(LazyPolynomial, SignsAtNumbersAreExact) {
  Inputs inputs(2);
  for (int i = 0; i < cases(200); ++i) {
    const Dyadic root = inputs.dyadic(), little = Dyadic::power_of_two(-800);
    ExactSource p(multiplied(with_root(root), polynomial({inputs.number(-9, 9), 0, inputs.number(-9, 9)})),
                  inputs.between(4, 90));
    for (const Dyadic& x : {root, root - little, root + little, inputs.dyadic()})
      EXPECT_EQ(p.lazy().sign_at(x), sign_at(p.polynomial(), x));
  }
}

}  // namespace
}  // namespace foresee
