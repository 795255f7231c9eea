// Exact conversion of doubles, and of differences of doubles, to DoubleDouble, Bounded or Dyadic.
#pragma once

#include "numbers/double_double.h"

namespace foresee {

template <class T>
struct Exactly {
  static T number(double value) { return T{value}; }
  static T difference_of(double a, double b) { return T{a} - T{b}; }
};
template <>
struct Exactly<DoubleDouble> {
  static DoubleDouble number(double value) { return {value, 0}; }
  static DoubleDouble difference_of(double a, double b) { return difference(a, b); }
};

}  // namespace foresee
