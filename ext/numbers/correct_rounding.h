// Correctly rounded quotients, square roots and rotated vectors, and sine and cosine with an error bound.
//
//   const Turned east = turned_clockwise(0, 5, 90);           // {5, 0}: north turned to starboard
//   rounded_quotient(Dyadic(1.0), Dyadic(3.0)) == 1.0 / 3.0
//
// All are the same on every machine: no libm, whose last bit differs between machines. Degrees are clockwise
// with x east and y north; multiples of 90 are exact. Cost: microseconds for a correctly rounded result, some
// 20 ns for quick_sine_cosine().
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

/// The square root to the nearest double, ties to even; 0 for a negative number.
double rounded_root(const Dyadic& square);

/// Error bound of quick_sine_cosine().
inline constexpr double quick_sine_error = 0x1p-49;

/// By Taylor's series in doubles: its rounding and that of the angle are below a dozen units of 2^-53
/// together. Requires: |degrees| <= 720.
SineCosine<double> quick_sine_cosine(double degrees);

}  // namespace foresee
