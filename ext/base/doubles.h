// A SIMD vector of doubles with the operators of one double, for templates over any real number type.
//
// It has as many lanes as a register holds. For kernels (base/simd.h): all here, and every template instance
// made with it, is local to the file that includes it.
#pragma once

#include "base/lane_math.h"
#include "base/registers.h"

namespace foresee {
namespace {

struct DoublesMask {
  decltype(Register{} < Register{}) of;
};

struct Doubles {
  Register of;

  Doubles() : of{} {}
  Doubles(double everywhere) : of(everywhere - Register{}) {}
  Doubles(const Register& values) : of(values) {}
};

inline Doubles operator-(const Doubles& a) {
  return -a.of;
}
inline Doubles operator+(const Doubles& a, const Doubles& b) {
  return a.of + b.of;
}
inline Doubles operator-(const Doubles& a, const Doubles& b) {
  return a.of - b.of;
}
inline Doubles operator*(const Doubles& a, const Doubles& b) {
  return a.of * b.of;
}
inline Doubles operator/(const Doubles& a, const Doubles& b) {
  return a.of / b.of;
}

inline DoublesMask operator<(const Doubles& a, const Doubles& b) {
  return {a.of < b.of};
}
inline DoublesMask operator>(const Doubles& a, const Doubles& b) {
  return {a.of > b.of};
}
inline DoublesMask operator<=(const Doubles& a, const Doubles& b) {
  return {a.of <= b.of};
}
inline DoublesMask operator&(const DoublesMask& a, const DoublesMask& b) {
  return {a.of & b.of};
}
inline DoublesMask operator|(const DoublesMask& a, const DoublesMask& b) {
  return {a.of | b.of};
}

inline Doubles select(const DoublesMask& chosen, const Doubles& a, const Doubles& b) {
  return chosen.of ? a.of : b.of;
}
inline Doubles lesser(const Doubles& a, const Doubles& b) {
  return select(a < b, a, b);
}
inline Doubles greater(const Doubles& a, const Doubles& b) {
  return select(a > b, a, b);
}
inline Doubles abs(const Doubles& a) {
  return a.of < 0.0 ? -a.of : a.of;
}
inline bool any(const DoublesMask& mask) {
  for (int l = 0; l < register_width; ++l)
    if (mask.of[l]) return true;
  return false;
}

}  // namespace
}  // namespace foresee
