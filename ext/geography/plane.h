// Where on a plane is a ship, and how does it move there? For a port, a coast, up to some hundred kilometres.
//
//   const OnPlane ship = to_plane({{30.2, -90.1}, {{6.2, 30}}}, {30, -90.5});
//   const Fix again = from_plane(ship, {30, -90.5});
//
// The azimuthal equidistant projection about an origin: every place keeps its distance and bearing from
// there; x to the east, y to the north, metres. A distance of 1 km anywhere within 10, 100, 300 km of the
// origin is wrong by 4e-7, 4e-5, 4e-4 of itself at most, and a ship that goes straight on over the Earth is
// beside its straight line on the plane, 100 km away, by 0.03 m after 6 km, 1.1 m after 36 km.
//
// The velocity is that of the place on the plane: what points away from the origin keeps its speed, what is
// across it is stretched by distance / reduced length (Karney 2013, section 3, equation 22 ff.).
#pragma once

#include <array>
#include <optional>

#include "geography/ellipsoid.h"

namespace foresee {

struct OnPlane {
  double x, y;                             ///< metres east and north of the origin
  std::optional<std::array<double, 2>> v;  ///< metres per second; none where the course is not known
};

/// Throws Error for a velocity opposite the origin, which no plane holds, and for one beyond a double's
/// range.
OnPlane to_plane(const Fix& fix, const LatLon& origin);

/// Throws Error beyond the Earth's other side, and for a speed beyond a double's range. What does not move
/// has no course: its speed is 0, degrees NaN.
Fix from_plane(const OnPlane& point, const LatLon& origin);

}  // namespace foresee
