// Polynomials of degree at most four with exact coefficients, and the greatest common divisor of two of them.
#pragma once

#include <array>

#include "numbers/dyadic.h"

namespace foresee {

struct Polynomial {
  static constexpr int max_degree = 4;
  std::array<Dyadic, max_degree + 1> c;  ///< reduced: mantissas are odd
  int degree = -1;                       ///< -1: zero everywhere

  Polynomial() = default;
  /// coefficients[k] belongs to the k-th power.
  explicit Polynomial(const std::array<Dyadic, max_degree + 1>& coefficients);

  void trim();
};

Dyadic value_at(const Polynomial& p, const Dyadic& x);
inline int sign_at(const Polynomial& p, const Dyadic& x) {
  return value_at(p, x).sign();
}

Polynomial derivative(const Polynomial& p);

/// c1^2 - 4 c0 c2
Dyadic discriminant(const Polynomial& p);

/// The greatest common divisor, up to a constant. Requires: not both zero.
Polynomial common_divisor(Polynomial a, Polynomial b);

/// True: the two certainly have no common root; false: very likely they have one. A fast test of the
/// coefficients modulo a prime. Requires: not both zero.
bool surely_coprime(const Polynomial& p, const Polynomial& q);

}  // namespace foresee
