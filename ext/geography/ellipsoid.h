// The WGS84 ellipsoid, position reports of ships, and directions in degrees.
#pragma once

#include <cmath>
#include <optional>

#include "geography/geodesic.h"

namespace foresee {

// Motion over the ground.
struct Course {
  double speed;    ///< metres per second
  double degrees;  ///< clockwise from north
};

/// A position report of a ship: its place, and its motion if known.
struct Fix {
  LatLon place;
  std::optional<Course> course;
};

// WGS84 (NIMA TR8350.2, table 3.1).
inline constexpr double semi_major = 6378137;
inline constexpr double flattening = 1 / 298.257223563;
inline constexpr double semi_minor = semi_major * (1 - flattening);
inline constexpr double eccentricity_squared = flattening * (2 - flattening);

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
struct Direction {
  double sine, cosine;
};

inline Direction unit_direction(double degrees) {
  int quarters = 0;
  const double rest = std::remquo(degrees, 90, &quarters) * (3.14159265358979323846 / 180);
  const double s = std::sin(rest), c = std::cos(rest);
  switch (quarters & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// The exponent of the power of two that scales numbers of this magnitude to about 1. Scaled so, a
/// computation cannot over- or underflow on its way; after std::ldexp back, the result is finite wherever a
/// double holds it.
inline int exponent_of(double magnitude) {
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return exponent;
}

/// Any angle as a course in [0, 360), never -0. (A small negative angle plus 360 rounds to 360.)
inline double full_turn(double degrees) {
  const double half_turn = std::remainder(degrees, 360);
  const double course = half_turn < 0 ? half_turn + 360 : half_turn + 0.0;
  return course < 360 ? course : 0;
}

/// The angle in degrees, clockwise from north, of a vector to the east and north: in [0, 360).
inline double course_of(double east, double north) {
  return full_turn(std::atan2(east, north) * (180 / 3.14159265358979323846));
}

}  // namespace foresee
