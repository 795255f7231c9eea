// Coefficients of a polynomial in time over any number type: index k belongs to the k-th power.
#pragma once

#include <array>

#include "numbers/bounded.h"
#include "numbers/double_double.h"

namespace foresee {

template <class T, int K = 4>
using Coefficients = std::array<T, K + 1>;

template <class T>
T twice(const T& a) {
  return a.scaled(1);
}
inline DoubleDouble twice(const DoubleDouble& a) {
  return {2 * a.high, 2 * a.low};
}
template <class Real>
BoundedOf<Real> twice(const BoundedOf<Real>& a) {
  return {2 * a.value, 2 * a.error};
}

template <class T>
T square(const T& a) {
  return a * a;
}
template <class Real>
BoundedOf<Real> square(const BoundedOf<Real>& a) {
  using std::abs;
  const Real value = a.value * a.value;
  return {value, a.error * (2 * abs(a.value) + a.error) + unit_roundoff * value};
}

}  // namespace foresee
