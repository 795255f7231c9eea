// Doubles with a running error bound: a computed value, and an upper bound of its distance from the exact
// one.
//
//   Bounded square = gap * gap;            // as doubles give it; off by what went in and the rounding
//
// Every operation propagates the errors of its arguments and adds half an ulp of its result. error_bound()
// adds once, at the end, two losses that the operations leave out: the bound's own roundings, and underflow.
// Real: double, or several at once (base/doubles.h).
#pragma once

#include <cmath>

#include "numbers/double_double.h"

namespace foresee {

template <class Real>
struct BoundedOf {
  Real value = 0.0;
  Real error = 0.0;

  /// The bound, raised by more than the loss of some dozens of roundings, and by `lost`.
  Real error_bound(const Real& lost) const { return error * (1 + 0x1p-40) + lost; }
};
using Bounded = BoundedOf<double>;

template <class Real>
BoundedOf<Real> operator-(const BoundedOf<Real>& a) {
  return {-a.value, a.error};
}

template <class Real>
BoundedOf<Real> operator+(const BoundedOf<Real>& a, const BoundedOf<Real>& b) {
  using std::abs;
  const Real value = a.value + b.value;
  return {value, a.error + b.error + unit_roundoff * abs(value)};
}

template <class Real>
BoundedOf<Real> operator-(const BoundedOf<Real>& a, const BoundedOf<Real>& b) {
  return a + -b;
}

template <class Real>
BoundedOf<Real> operator*(const BoundedOf<Real>& a, const BoundedOf<Real>& b) {
  using std::abs;
  const Real value = a.value * b.value;
  return {value, abs(a.value) * b.error + a.error * (abs(b.value) + b.error) + unit_roundoff * abs(value)};
}

/// Requires: b is certainly not 0.
template <class Real>
BoundedOf<Real> operator/(const BoundedOf<Real>& a, const BoundedOf<Real>& b) {
  using std::abs;
  const Real value = a.value / b.value;
  return {value, (a.error + abs(value) * b.error) / (abs(b.value) - b.error) + unit_roundoff * abs(value)};
}

/// Requires: a is certainly above 0.
inline Bounded sqrt(const Bounded& a) {
  const double value = std::sqrt(a.value);
  return {value, a.error / value + unit_roundoff * value};
}

}  // namespace foresee
