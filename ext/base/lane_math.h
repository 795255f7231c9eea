// Arithmetic helpers for kernels (base/simd.h): absolute value, select, minimum and maximum.
//
// They use built-in types, no branches and no library functions. Templates over one double and over several
// (base/doubles.h) use them too. All are always inlined: a kernel must not share a function with code for
// older CPUs.
#pragma once

namespace foresee {

[[gnu::always_inline]] inline double absolute(double x) {
  return __builtin_fabs(x);
}

[[gnu::always_inline]] inline double select(bool chosen, double a, double b) {
  return chosen ? a : b;
}

// If either argument is NaN, these return the second one.
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
