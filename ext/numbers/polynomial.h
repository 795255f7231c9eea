// Polynomials of degree at most four with exact coefficients, and whether two of them have a common root.
#pragma once

#include <array>

#include "numbers/dyadic.h"

namespace foresee {

struct Polynomial {
  static constexpr int max_degree = 4;
  std::array<Dyadic, max_degree + 1> c;  ///< odd mantissas: powers of two cost nothing
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

/// No common root for certain, told quickly from the coefficients modulo a prime; a common root is very
/// likely if false. Requires: not both zero.
bool surely_coprime(const Polynomial& p, const Polynomial& q);

}  // namespace foresee
