// Roots of quadratics by the formula without cancellation, in 128 bits and in more: enclosed, and narrowly.
#include <gtest/gtest.h>

#include "numbers/factors.h"
#include "numbers/quadratic_root.h"
#include "numbers/wide_numbers.h"

namespace foresee {
namespace {

using namespace judge;

/// Both roots; `lost` bits of the length may be missing.
template <class Ball>
void expect_roots(const Polynomial& p, const std::array<Ball, 3>& c, int bits, int lost) {
  const Ball d = c[1] * c[1] - (c[0] * c[2]).scaled(2), product = product_of_root(c, d);
  for (const int which : {-1, 1}) {
    const Ball root = root_of_quadratic(c, product, which);
    const Wide low(low_of(root)), high(high_of(root)), right = root_of(p, which);
    const Wide rounding = ldexp(abs(right), -1400);
    EXPECT_LE(low - rounding, right);
    EXPECT_LE(right, high + rounding);
    EXPECT_LE(high - low, ldexp(abs(right), lost - bits));
  }
}

void expect_roots(const Polynomial& p) {
  expect_roots(p, std::array{Midrad128(p.c[0]), Midrad128(p.c[1]), Midrad128(p.c[2])}, 128, 12);
  expect_roots(p, std::array{Midrad(p.c[0], 600), Midrad(p.c[1], 600), Midrad(p.c[2], 600)}, 600, 12);
}

/// The greater root is up to 2^80 times the lesser, where -b and the root of D would cancel.
TEST(QuadraticFormula, EnclosesBothRootsWithoutCancellation) {
  Inputs inputs(1);
  for (int i = 0; i < cases(300); ++i) {
    const Dyadic one(inputs.number(-40, 40)), other(inputs.number(-40, 40));
    const Polynomial p =
        multiplied(multiplied(with_root(one), with_root(other)), polynomial({inputs.number(-9, 9)}));
    const int distance = (one - other).sign() == 0 ? -1000 : (one - other).magnitude();
    if (distance > std::max(one.magnitude(), other.magnitude()) - 3) expect_roots(p);
  }
}

TEST(QuadraticFormula, EnclosesIrrationalRoots) {
  Inputs inputs(2);
  int used = 0;
  for (int i = 0; i < cases(300); ++i) {
    const Polynomial p = polynomial({inputs.number(-9, 9), inputs.number(-30, 9), inputs.number(-9, 9)});
    if (p.c[0].sign() * p.c[2].sign() > 0) continue;
    expect_roots(p), ++used;
  }
  EXPECT_GT(used, cases(300) / 4);
}

TEST(QuadraticFormula, NamesTheRootsInOrder) {
  for (const double lead : {-1.0, 1.0})
    for (const auto& [r, s] :
         {std::pair{1.0, 3.0}, {-3.0, -1.0}, {-3.0, 1.0}, {-1.0, 3.0}, {-2.0, 2.0}, {0.0, 2.0}}) {
      const std::array c{Midrad128(lead * r * s), Midrad128(-lead * (r + s)), Midrad128(lead)};
      const Midrad128 d = c[1] * c[1] - (c[0] * c[2]).scaled(2), product = product_of_root(c, d);
      EXPECT_TRUE(holds(root_of_quadratic(c, product, -1), rational(r))) << lead << ' ' << r << ' ' << s;
      EXPECT_TRUE(holds(root_of_quadratic(c, product, 1), rational(s))) << lead << ' ' << r << ' ' << s;
    }
}

}  // namespace
}  // namespace foresee
