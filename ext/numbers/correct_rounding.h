// Correctly rounded quotients, square roots and rotated vectors, and sine and cosine with an error bound.
//
//   const Turned east = turned_clockwise(0, 5, 90);           // {5, 0}: north turned to starboard
//   rounded_quotient(Dyadic(1.0), Dyadic(3.0)) == 1.0 / 3.0
//
// All are the same on every machine: no libm, whose last bit differs between machines. Degrees are clockwise
// with x east and y north; multiples of 90 are exact. Cost: microseconds for a correctly rounded result, some
// 20 ns for the quick functions.
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

/// pi / 180, to the nearest double.
inline constexpr double radians_per_degree = 0x1.1df46a2529d39p-6;

/// sin(k) / k for the angle k, within twice quick_sine_error; 1 for 0.
double quick_sinc(double degrees);

/// The angle in degrees, from -180 to 180, within some quick_sine_error.
double quick_degrees(const SineCosine<double>& angle);

/// As turned_clockwise(), but with the sine and cosine of quick_sine_cosine(), and at any finite angle.
Turned quick_turned(double x, double y, double degrees);

}  // namespace foresee
