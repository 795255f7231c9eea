// Azimuthal equidistant projection of ship reports to a plane and back, for up to some hundred kilometres.
//
//   const OnPlane ship = to_plane({{30.2, -90.1}, {{6.2, 30}}}, {30, -90.5});
//   const Fix again = from_plane(ship, {30, -90.5});
//
// Every place keeps its distance and bearing from the origin; x points east, y north, in metres. A distance
// of 1 km within 10, 100, 300 km of the origin has a relative error of at most 4e-7, 4e-5, 4e-4. At 100 km
// from the origin, a ship on a straight course leaves its straight line on the plane by 0.03 m after 6 km,
// 1.1 m after 36 km.
//
// The velocity is that of the projected place: its component away from the origin keeps its speed, the one
// across is stretched by distance / reduced length (Karney 2013, section 3, equation 22 ff.).
#pragma once

#include <array>
#include <optional>

#include "geography/ellipsoid.h"

namespace foresee {

/// The greatest distance of a position from the origin of its table, in metres.
inline constexpr double max_distance_from_origin = 1500e3;

struct OnPlane {
  double x, y;                             ///< metres east and north of the origin
  std::optional<std::array<double, 2>> v;  ///< metres per second; empty where the course is not known
};

/// Throws Error for a velocity at the antipode of the origin, where the projection has none, and for one
/// beyond a double's range.
OnPlane to_plane(const Fix& fix, const LatLon& origin);

/// Throws Error for a point beyond the antipode of the origin, and for a speed beyond a double's range. An
/// object at rest has no course: its speed is 0, degrees NaN.
Fix from_plane(const OnPlane& point, const LatLon& origin);

}  // namespace foresee
