// What loops of kernels compute with (base/simd.h), and code that is written once for one number and for
// several at once (base/doubles.h): of built-in types, without branches or library functions.
//
// All is inlined wherever it is called: a kernel must not share a function with code for older CPUs.
#pragma once

namespace foresee {

[[gnu::always_inline]] inline double absolute(double x) {
  return __builtin_fabs(x);
}

[[gnu::always_inline]] inline double select(bool chosen, double a, double b) {
  return chosen ? a : b;
}

// These pass on a second argument where one is NaN.
[[gnu::always_inline]] inline double lesser(double a, double b) {
  return a < b ? a : b;
}
[[gnu::always_inline]] inline double greater(double a, double b) {
  return a > b ? a : b;
}
[[gnu::always_inline]] inline float lesser(float a, float b) {
  return a < b ? a : b;
}
[[gnu::always_inline]] inline float greater(float a, float b) {
  return a > b ? a : b;
}

}  // namespace foresee
