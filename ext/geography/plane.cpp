#include "geography/plane.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/shown.h"
#include "geography/ellipsoid.h"

namespace foresee::geography {
namespace {

/// How much longer across than on the Earth a way is on the plane. The reduced length has lost its last
/// digits where it is short; there distance (1 - K distance^2 / 6) is closer, with the curvature K at the
/// origin.
double stretch(double distance, double reduced_length, const LatLon& origin) {
  if (distance > 3000) return distance / reduced_length;
  const double sine = direction_of(origin.lat).sine, flat = 1 - eccentricity_squared * sine * sine;
  const double curvature = flat * flat / (semi_minor * semi_minor);
  return 1 + curvature * distance * distance / 6;
}

/// By how much a geodesic turns against the meridians. Within a millimetre its azimuths are mostly rounding.
double convergence(const Geodesic& way, const LatLon& from, const LatLon& to) {
  if (way.distance >= 1e-3) return way.azimuth_there - way.azimuth;
  return std::remainder(to.lon - from.lon, 360) * direction_of((from.lat + to.lat) / 2).sine;
}

}  // namespace

OnPlane to_plane(const Fix& fix, const LatLon& origin) {
  const Geodesic way = geodesic_between(origin, fix.place);
  const Direction bearing = direction_of(way.azimuth);
  // + 0.0: the origin itself is at 0, not at -0.
  OnPlane point{way.distance * bearing.sine + 0.0, way.distance * bearing.cosine + 0.0, {}};
  if (!fix.course) return point;
  // Near the opposite place neighbouring lines meet again.
  if (way.distance > 0.999 * greatest_distance)
    throw Error("lat, lon are opposite the origin: no plane about it holds a velocity there");
  const Direction off = direction_of(std::remainder(fix.course->degrees, 360) - way.azimuth -
                                     convergence(way, origin, fix.place));
  const double outward = fix.course->speed * off.cosine;
  const double across = fix.course->speed * off.sine * stretch(way.distance, way.reduced_length, origin);
  point.v = {outward * bearing.sine + across * bearing.cosine,
             outward * bearing.cosine - across * bearing.sine};
  return point;
}

Fix from_plane(const OnPlane& point, const LatLon& origin) {
  const double distance = std::hypot(point.x, point.y);
  if (!(distance <= greatest_distance))
    throw Error("x, y are " + shown(distance) + " m from the origin: the farthest place is at 20003931 m");
  const double azimuth = course_of(point.x, point.y);
  const GeodesicEnd end = geodesic_from(origin, azimuth, distance);
  Fix fix{end.place, {}};
  if (!point.v) return fix;
  const auto [vx, vy] = *point.v;
  const Direction bearing = direction_of(azimuth);
  const double outward = vx * bearing.sine + vy * bearing.cosine;
  const double across =
      (vx * bearing.cosine - vy * bearing.sine) / stretch(distance, end.reduced_length, origin);
  const double speed = std::hypot(outward, across);
  const double turned = std::remainder(end.azimuth + course_of(across, outward), 360);
  fix.course = Course{speed, speed > 0 ? (turned < 0 ? turned + 360 : turned) : std::nan("")};
  return fix;
}

}  // namespace foresee::geography
