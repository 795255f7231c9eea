#include "contact/polynomial.h"

#include <limits>

namespace foresee {
namespace {

/// Multiplies by the divisor's leading coefficient as often as needed; returns the quotient, leaves the
/// remainder.
Polynomial pseudo_divide(Polynomial& a, const Polynomial& b) {
  Polynomial quotient;
  quotient.degree = a.degree - b.degree;
  const Integer lead = b.c[b.degree];
  for (int k = a.degree - b.degree; k >= 0; --k) {
    const Integer top = a.c[k + b.degree];
    for (int i = 0; i <= a.degree; ++i) a.c[i] *= lead;
    for (int i = 0; i <= quotient.degree; ++i) quotient.c[i] *= lead;
    for (int i = 0; i <= b.degree; ++i) a.c[k + i] -= top * b.c[i];
    quotient.c[k] = top;
  }
  a.trim();
  quotient.trim();
  return quotient;
}

Integer power(const Integer& base, int exponent) {
  Integer result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

}  // namespace

Polynomial::Polynomial(const std::array<Dyadic, most + 1>& coefficients) {
  int least = std::numeric_limits<int>::max();
  for (const Dyadic& d : coefficients)
    if (d.sign() != 0) least = std::min(least, d.exponent());
  for (int k = 0; k <= most; ++k)
    if (coefficients[k].sign() != 0)
      c[k] = coefficients[k].mantissa() << (coefficients[k].exponent() - least);
  degree = most;
  trim();
}

void Polynomial::trim() {
  while (degree >= 0 && c[degree].is_zero()) --degree;
}

Dyadic value_at(const Polynomial& p, const Dyadic& x) {
  Dyadic value;
  for (int k = p.degree; k >= 0; --k) value = value * x + Dyadic(p.c[k], 0);
  return value;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d;
  d.degree = p.degree < 1 ? -1 : p.degree - 1;
  for (int k = 1; k <= p.degree; ++k) d.c[k - 1] = p.c[k] * k;
  return d;
}

Polynomial common_divisor(Polynomial a, Polynomial b) {
  // Subresultant remainders: coefficients grow in proportion, and no integer divisors have to be searched.
  if (a.degree < b.degree) std::swap(a, b);
  Integer g = 1, h = 1;
  while (b.degree > 0) {
    const int drop = a.degree - b.degree;
    const Integer divisor = g * power(h, drop);
    pseudo_divide(a, b);
    std::swap(a, b);
    if (b.degree < 0) return a;
    for (int k = 0; k <= b.degree; ++k) b.c[k] /= divisor;
    g = a.c[a.degree];
    h = drop == 0 ? h : power(g, drop) / power(h, drop - 1);
  }
  if (b.degree < 0) return a;
  Polynomial one;
  one.degree = 0;
  one.c[0] = 1;
  return one;
}

Polynomial square_free(const Polynomial& p) {
  const Polynomial repeated = common_divisor(p, derivative(p));
  if (repeated.degree == 0) return p;
  Polynomial rest = p;
  return pseudo_divide(rest, repeated);
}

Descartes descartes(const Polynomial& p, const Dyadic& low, const Dyadic& high) {
  Descartes answer{0, 0};
  if (p.degree < 0) return answer;
  // p(low + width y) by repeated synthetic division, then powers of the width.
  std::array<Dyadic, Polynomial::most + 1> d;
  for (int k = 0; k <= p.degree; ++k) d[k] = Dyadic(p.c[k], 0);
  for (int k = 0; k < p.degree; ++k)
    for (int i = p.degree - 1; i >= k; --i) d[i] = d[i] + low * d[i + 1];
  const Dyadic width = high - low;
  Dyadic scale = width;
  for (int k = 1; k <= p.degree; ++k, scale = scale * width) d[k] = d[k] * scale;
  int last = 0;
  for (int i = 0; i <= p.degree; ++i) {
    Dyadic b;
    for (int k = 0; k <= i; ++k) b = b + d[k] * Dyadic(Integer(bernstein_weight(p.degree, i, k)), 0);
    const int sign = b.sign();
    if (sign == 0) continue;
    if (answer.first == 0) answer.first = sign;
    if (last != 0 && sign != last) ++answer.variations;
    last = sign;
  }
  return answer;
}

}  // namespace foresee
