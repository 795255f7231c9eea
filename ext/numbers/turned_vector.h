// Quotients and turned vectors rounded once, and sine and cosine in plain doubles with a promise: the same on
// every machine.
//
//   const Turned east = turned_clockwise(0, 5, 90);           // {5, 0}: north turned to starboard
//   rounded_quotient(Dyadic(1.0), Dyadic(3.0)) == 1.0 / 3.0
//
// Degrees are clockwise as seen with x east and y north; multiples of 90 are exact. No libm: its last bit
// differs between machines. Cost: microseconds where something is rounded once, some 20 ns for
// quick_sine_cosine().
#pragma once

#include "numbers/dyadic.h"
#include "numbers/sine_cosine.h"

namespace foresee {

struct Turned {
  double x, y;
};

/// (x cos k + y sin k, y cos k - x sin k), each rounded once; 0 is never -0. Requires: x and y finite,
/// |degrees| <= 360.
Turned turned_clockwise(double x, double y, double degrees);

/// a / b to the nearest double, ties to even. Requires: b > 0.
double rounded_quotient(const Dyadic& a, const Dyadic& b);

/// The square root of a to the nearest double. Requires: a >= 0.
double rounded_root(const Dyadic& a);

/// How far quick_sine_cosine() may be off.
inline constexpr double quick_sine_error = 0x1p-49;

/// By Taylor's series in doubles: its rounding, and that of the angle, stay below a dozen units of 2^-53.
/// Requires: |degrees| <= 720.
SineCosine<double> quick_sine_cosine(double degrees);

}  // namespace foresee
