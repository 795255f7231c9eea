// Converts ship and aircraft reports to geocentric coordinates (ECEF) and back, for scenes of the whole
// Earth.
//
//   const OnGlobe ship = to_globe({.fix = {{30.2, -90.1}, {{6.2, 30}}}, .height = 9000});
//   const Flight again = from_globe(ship);
//
// Geocentric coordinates are metres; x points to latitude 0, longitude 0, z to the north pole. The Earth's
// curvature becomes an acceleration towards its inside: speed squared times the curvature in the direction of
// the course. That is sin^2 / (N + h) + cos^2 / (M + h), with the radii of curvature N across the meridian
// and M along it (Euler's theorem). What climbs needs an acceleration along its course too: climb times speed
// times that curvature, because its velocity upward turns with the vertical. A ship on a straight course then
// leaves its geodesic by 0.001 m after 6 km, 0.19 m after 36 km, 7 m after 120 km. Distances are chords: 6 km
// are too short by a relative 4e-8. Because no axis points up, only points and balls can be used.
#pragma once

#include <array>
#include <optional>

#include "geography/ellipsoid.h"

namespace foresee {

/// A report with a height above the ellipsoid in metres, and the rate at which the height grows.
struct Flight {
  Fix fix;
  double height = 0;
  double climb = 0;
};

struct OnGlobe {
  struct Motion {
    std::array<double, 3> v, a;
  };
  std::array<double, 3> x;
  std::optional<Motion> motion;  ///< empty where the course is not known
};

/// Throws Error for heights near the centre of the Earth, and for a velocity or acceleration beyond a
/// double's range.
OnGlobe to_globe(const Flight& flight);

/// By Bowring's formula (Survey Review 23, 1976), iterated until the result is stable: errors of some
/// nanometres up to heights of a satellite. Throws Error within 100 km of the centre, where a height makes no
/// sense. An object at rest over the ground has no course: its speed is 0, degrees NaN.
Flight from_globe(const OnGlobe& point);

}  // namespace foresee
