// Polynomials of degree at most four with integer coefficients: exact signs, and how many roots an interval
// can hold.
//
// A polynomial of exact numbers is scaled to integers; the scale is positive, so signs and roots stay.
#pragma once

#include <array>

#include "contact/dyadic.h"

namespace foresee {

struct Polynomial {
  static constexpr int most = 4;
  std::array<Integer, most + 1> c;
  int degree = -1;  ///< -1: zero everywhere

  Polynomial() = default;
  /// coefficients[k] belongs to the k-th power; at most five.
  explicit Polynomial(const std::array<Dyadic, most + 1>& coefficients);

  void trim();
};

/// Exact value up to the positive scale.
Dyadic value_at(const Polynomial& p, const Dyadic& x);
inline int sign_at(const Polynomial& p, const Dyadic& x) {
  return value_at(p, x).sign();
}

Polynomial derivative(const Polynomial& p);

/// The greatest common divisor, up to a constant. Requires: not both zero.
Polynomial common_divisor(Polynomial a, Polynomial b);

/// Without repeated roots, the same roots, up to a constant. Requires: degree >= 1.
Polynomial square_free(const Polynomial& p);

/// 12 C(i, k) / C(n, k): from the powers of y on [0, 1] to Bernstein's form, times 12.
constexpr int bernstein_weight(int n, int i, int k) {
  constexpr int choose[5][5] = {
      {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
  return 12 * choose[i][k] / choose[n][k];
}

/// Descartes' rule on the open interval (low, high): it holds at most `variations` roots, and fewer by an
/// even number, so that 0 and 1 are exact. `first`: sign just after low, `0` for the zero polynomial.
struct Descartes {
  int variations;
  int first;
};
Descartes descartes(const Polynomial& p, const Dyadic& low, const Dyadic& high);

}  // namespace foresee
