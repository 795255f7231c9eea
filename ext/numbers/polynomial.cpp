#include "numbers/polynomial.h"

#include <utility>

#include "numbers/residue.h"

namespace foresee {
namespace {

/// Requires: b divides a; both are reduced, so that b's mantissa divides a's.
Dyadic exact_quotient(const Dyadic& a, const Dyadic& b) {
  return {a.mantissa() / b.mantissa(), a.exponent() - b.exponent()};
}

Dyadic power(const Dyadic& base, int exponent) {
  Dyadic result(1.0);
  for (int i = 0; i < exponent; ++i) result = result * base;
  return result;
}

/// Replaces a by its pseudo-remainder: multiplied by the divisor's leading coefficient in every step.
template <class Coefficients>
void pseudo_divide(Coefficients& a, int degree_a, const Coefficients& b, int degree_b) {
  for (int k = degree_a; k >= degree_b; --k) {
    const auto top = std::exchange(a[k], {});
    for (int i = 0; i < k; ++i) {
      a[i] = a[i] * b[degree_b];
      const int place = i - (k - degree_b);
      if (place >= 0) a[i] = a[i] - top * b[place];
    }
  }
}

struct Residues {
  std::array<Residue, Polynomial::max_degree + 1> c;
  int degree;

  explicit Residues(const Polynomial& p) : degree(p.degree) {
    for (int k = 0; k <= degree; ++k) c[k] = Residue(p.c[k]);
    trim();
  }
  void trim() {
    while (degree >= 0 && c[degree].is_zero()) --degree;
  }
};

}  // namespace

Polynomial::Polynomial(const std::array<Dyadic, max_degree + 1>& coefficients) : degree(max_degree) {
  for (int k = 0; k <= max_degree; ++k) c[k] = coefficients[k].reduced();
  trim();
}

void Polynomial::trim() {
  while (degree >= 0 && c[degree].sign() == 0) --degree;
}

Dyadic value_at(const Polynomial& p, const Dyadic& x) {
  Dyadic value;
  for (int k = p.degree; k >= 0; --k) value = value * x + p.c[k];
  return value;
}

Polynomial derivative(const Polynomial& p) {
  std::array<Dyadic, Polynomial::max_degree + 1> slope;
  for (int k = 1; k <= p.degree; ++k) slope[k - 1] = p.c[k] * Dyadic(k);
  return Polynomial(slope);
}

Dyadic discriminant(const Polynomial& p) {
  return p.c[1] * p.c[1] - (p.c[0] * p.c[2]).scaled(2);
}

Polynomial common_divisor(Polynomial a, Polynomial b) {
  // Subresultant remainder sequence: coefficients grow linearly, and no common factors have to be searched.
  if (a.degree < b.degree) std::swap(a, b);
  Dyadic g(1.0), h(1.0);
  while (b.degree > 0) {
    const int drop = a.degree - b.degree;
    const Dyadic divisor = (g * power(h, drop)).reduced();
    pseudo_divide(a.c, a.degree, b.c, b.degree);
    a.trim();
    std::swap(a, b);
    if (b.degree < 0) return a;
    for (int k = 0; k <= b.degree; ++k) b.c[k] = exact_quotient(b.c[k].reduced(), divisor);
    g = a.c[a.degree];
    h = drop == 0 ? h : exact_quotient(power(g, drop).reduced(), power(h, drop - 1).reduced());
  }
  return b.degree < 0 ? a : b;
}

bool surely_coprime(const Polynomial& p, const Polynomial& q) {
  Residues a(p), b(q);
  // The leading coefficient of a common divisor divides both; if it may vanish, there is no proof.
  if (a.degree < p.degree && b.degree < q.degree) return false;
  if (a.degree < b.degree) std::swap(a, b);
  while (b.degree > 0) {
    pseudo_divide(a.c, a.degree, b.c, b.degree);
    a.trim();
    std::swap(a, b);
  }
  return b.degree == 0;
}

}  // namespace foresee
