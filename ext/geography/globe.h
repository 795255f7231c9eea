// Where in space is a ship or an aircraft, and how does it move there? All the Earth at once.
//
//   const OnGlobe ship = to_globe({.fix = {{30.2, -90.1}, {{6.2, 30}}}, .height = 9000});
//   const Flight again = from_globe(ship);
//
// Geocentric coordinates (metres; x to latitude 0, longitude 0, z to the north pole). The Earth's curve is an
// acceleration towards its inside: speed squared times the curvature of the Earth in the direction of the
// course, sin^2 / (N + h) + cos^2 / (M + h) with the radii of curvature N across the meridian and M along it
// (Euler's theorem). With it a ship that goes straight on is off its geodesic by 0.001 m after 6 km, 0.19 m
// after 36 km, 7 m after 120 km. Distances are chords: 6 km are short by 4e-8 of themselves. The axes are not
// up: for points and balls only.
#pragma once

#include <array>
#include <optional>

#include "geography/ellipsoid.h"

namespace foresee {

/// A report with a height above the ellipsoid, in metres, and the speed at which that grows.
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
  std::optional<Motion> motion;  ///< none where the course is not known
};

/// Throws Error for heights near the centre of the Earth, and for a velocity or acceleration beyond a
/// double's range.
OnGlobe to_globe(const Flight& flight);

/// By Bowring's formula (Survey Review 23, 1976), repeated until it changes nothing: some nanometres up to
/// heights of a satellite. Throws Error within 100 km of the centre, where no height is meant. Who does not
/// move over the ground has no course: its speed is 0, degrees NaN.
Flight from_globe(const OnGlobe& point);

}  // namespace foresee
