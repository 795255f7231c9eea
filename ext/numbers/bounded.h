// Doubles that know how wrong they may be: a value, and a bound on how far the exact number is from it.
//
//   Bounded square = gap * gap;            // the value as doubles give it; what went in and the rounding
//   count
//
// Every operation adds the errors of its arguments and half an ulp of its result. Two things are left to
// whoever reads the bound in the end (settled()), as once is enough: the bound's own roundings, and what
// underflow loses.
#pragma once

#include <cmath>

#include "numbers/double_double.h"

namespace foresee {

struct Bounded {
  double value = 0;
  double error = 0;

  /// The bound, raised by more than some dozens of roundings can have taken from it, and by `lost`.
  double settled(double lost) const { return error * (1 + 0x1p-40) + lost; }
};

inline Bounded operator-(const Bounded& a) {
  return {-a.value, a.error};
}

inline Bounded operator+(const Bounded& a, const Bounded& b) {
  const double value = a.value + b.value;
  return {value, a.error + b.error + unit_roundoff * std::abs(value)};
}

inline Bounded operator-(const Bounded& a, const Bounded& b) {
  return a + -b;
}

inline Bounded operator*(const Bounded& a, const Bounded& b) {
  const double value = a.value * b.value;
  return {value, std::abs(a.value) * b.error + a.error * (std::abs(b.value) + b.error) +
                     unit_roundoff * std::abs(value)};
}

}  // namespace foresee
