// Reference geodesics by numerical integration: a path in space whose acceleration is normal to the
// ellipsoid. The Runge-Kutta method of fourth order in long doubles; no angles, no series.
#pragma once

#include <array>
#include <cmath>

#include "geography/geodesic.h"

namespace foresee {

using Real = long double;
using Point = std::array<Real, 3>;

inline constexpr Real radian = 57.295779513082320876798154814105L;
inline constexpr Real axis_a = 6378137, axis_b = axis_a * (1 - 1 / 298.257223563L);

inline Point sum(const Point& a, Real scale, const Point& b) {
  return {a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]};
}
inline Real product(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The point of the ellipsoid at a place.
inline Point on_ellipsoid(const LatLon& place) {
  const Real lat = place.lat / radian, lon = place.lon / radian, e2 = 1 - axis_b * axis_b / (axis_a * axis_a);
  const Real n = axis_a / std::sqrt(1 - e2 * std::sin(lat) * std::sin(lat));
  return {n * std::cos(lat) * std::cos(lon), n * std::cos(lat) * std::sin(lon), n * (1 - e2) * std::sin(lat)};
}

/// The length of the chord between two places, which is close to their distance if they are near.
inline double metres_between(const LatLon& a, const LatLon& b) {
  const Point chord = sum(on_ellipsoid(a), -1, on_ellipsoid(b));
  return static_cast<double>(std::sqrt(product(chord, chord)));
}

struct Step {
  Point x, v;
  Real reduced, slope;  ///< the reduced length and its derivative
};

/// Derivatives by length. The reduced length obeys m'' + K m = 0 with the curvature K (Gauss).
inline Step slope_of(const Step& at) {
  const Point gradient{at.x[0] / (axis_a * axis_a), at.x[1] / (axis_a * axis_a), at.x[2] / (axis_b * axis_b)};
  const Point bent{at.v[0] / (axis_a * axis_a), at.v[1] / (axis_a * axis_a), at.v[2] / (axis_b * axis_b)};
  const Real square = product(gradient, gradient);
  const Real curvature = 1 / (axis_a * axis_a * axis_a * axis_a * axis_b * axis_b * square * square);
  const Real push = -product(bent, at.v) / square;
  return {
      at.v, {push * gradient[0], push * gradient[1], push * gradient[2]}, at.slope, -curvature * at.reduced};
}

struct Walked {
  LatLon place;
  double azimuth, reduced_length;
};

inline Walked walked(const LatLon& from, double azimuth, double distance) {
  const Real lat = from.lat / radian, lon = from.lon / radian, course = azimuth / radian;
  const Point east{-std::sin(lon), std::cos(lon), 0},
      north{-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon), std::cos(lat)};
  Step at{on_ellipsoid(from), sum({0, 0, 0}, std::cos(course), north), 0, 1};
  at.v = sum(at.v, std::sin(course), east);
  constexpr int steps = 2000;
  const Real h = static_cast<Real>(distance) / steps;
  const auto moved = [](const Step& s, Real by, const Step& d) {
    return Step{sum(s.x, by, d.x), sum(s.v, by, d.v), s.reduced + by * d.reduced, s.slope + by * d.slope};
  };
  for (int i = 0; i < steps; ++i) {
    const Step a = slope_of(at), b = slope_of(moved(at, h / 2, a)), c = slope_of(moved(at, h / 2, b)),
               d = slope_of(moved(at, h, c));
    at = moved(moved(moved(moved(at, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }
  const Real there = std::atan2(at.x[2] * axis_a * axis_a / (axis_b * axis_b), std::hypot(at.x[0], at.x[1]));
  const Real turned = std::atan2(at.x[1], at.x[0]);
  const Point to_east{-std::sin(turned), std::cos(turned), 0},
      to_north{-std::sin(there) * std::cos(turned), -std::sin(there) * std::sin(turned), std::cos(there)};
  const Real arrival = std::atan2(product(at.v, to_east), product(at.v, to_north));
  return {{static_cast<double>(there * radian), static_cast<double>(turned * radian)},
          static_cast<double>(arrival * radian),
          static_cast<double>(at.reduced)};
}

}  // namespace foresee
