// What the loops of kernels compute with (base/simd.h): of built-in types, without branches or library
// functions, and local to the file that includes it.
#pragma once

#include "base/rooms.h"

namespace foresee::base {
namespace {

inline double size_of(double x) {
  return __builtin_fabs(x);
}

// These pass on a second argument where one is NaN.
inline double least(double a, double b) {
  return a < b ? a : b;
}
inline double greatest(double a, double b) {
  return a > b ? a : b;
}
inline float least(float a, float b) {
  return a < b ? a : b;
}
inline float greatest(float a, float b) {
  return a > b ? a : b;
}

}  // namespace
}  // namespace foresee::base
