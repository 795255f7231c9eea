// Polynomials of known factors for the tests: products of x - r and of what has no root, and their order by
// hand.
#pragma once

#include <initializer_list>

#include "numbers/algebraic_root.h"
#include "numbers/polynomial.h"

namespace foresee::judge {

/// By coefficients of powers 0, 1, 2, ...
inline Polynomial polynomial(std::initializer_list<double> coefficients) {
  std::array<Dyadic, Polynomial::max_degree + 1> c;
  std::size_t k = 0;
  for (const double coefficient : coefficients) c.at(k++) = Dyadic(coefficient);
  return Polynomial(c);
}

inline Polynomial multiplied(const Polynomial& p, const Polynomial& q) {
  std::array<Dyadic, Polynomial::max_degree + 1> c;
  for (int i = 0; i <= p.degree; ++i)
    for (int j = 0; j <= q.degree; ++j) c.at(i + j) = c.at(i + j) + p.c[i] * q.c[j];
  return Polynomial(c);
}

/// x - root
inline Polynomial with_root(const Dyadic& root) {
  return Polynomial({-root, Dyadic(1.0), Dyadic(), Dyadic(), Dyadic()});
}

inline Polynomial negated(const Polynomial& p) {
  return multiplied(p, polynomial({-1}));
}

/// Exact polynomials behind lazy ones, whose enclosures are as rough as a test wants.
class ExactSource : public PolynomialSource {
 public:
  /// Off by up to 2^-`digits` of each coefficient; 0: not at all.
  explicit ExactSource(Polynomial p, int digits = 0) : polynomial_(std::move(p)) {
    LazyPolynomial::RoughCoefficients rough;
    for (int k = 0; k <= polynomial_.degree; ++k) {
      const Midrad128 c(polynomial_.c[k]);
      if (digits > 0 && c.sign() != 0) {
        const Midrad128 off = Midrad128(1.0).scaled(c.magnitude() - digits);
        rough[k] = c + Midrad128::hull(Midrad128(), off + off) - off;
      } else {
        rough[k] = c;
      }
    }
    lazy_ = std::make_unique<LazyPolynomial>(rough, *this, 0);
  }

  LazyPolynomial& lazy() { return *lazy_; }
  const Polynomial& polynomial() const { return polynomial_; }
  Polynomial exact_polynomial(int /*number*/) const override { return polynomial_; }

 private:
  Polynomial polynomial_;
  std::unique_ptr<LazyPolynomial> lazy_;
};

}  // namespace foresee::judge
