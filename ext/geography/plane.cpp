#include "geography/plane.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/number_text.h"
#include "geography/ellipsoid.h"

namespace foresee {
namespace {

/// The factor by which the projection stretches lengths across the direction to the origin. A short reduced
/// length has lost its last digits; distance (1 - K distance^2 / 6) is then closer, with the curvature K at
/// the origin.
double stretch(double distance, double reduced_length, const LatLon& origin) {
  if (distance > 3000) return distance / reduced_length;
  const double sine = unit_direction(origin.lat).sine, flat = 1 - eccentricity_squared * sine * sine;
  const double curvature = flat * flat / (semi_minor * semi_minor);
  return 1 + curvature * distance * distance / 6;
}

/// The meridian convergence along a geodesic. Azimuths of one under a millimetre are mostly rounding.
double convergence(const Geodesic& line, const LatLon& from, const LatLon& to) {
  if (line.distance >= 1e-3) return line.azimuth_there - line.azimuth;
  const double lon = std::remainder(to.lon, 360) - std::remainder(from.lon, 360);
  return std::remainder(lon, 360) * unit_direction((from.lat + to.lat) / 2).sine;
}

/// Neighbouring geodesics meet again opposite the origin: at the end of half a meridian, on the equator
/// somewhat earlier. Within a metre of that place the reduced length is mostly rounding.
bool is_opposite(const Geodesic& line) {
  return line.distance > 0.999 * greatest_distance || (line.distance > 3000 && !(line.reduced_length >= 1));
}

}  // namespace

OnPlane to_plane(const Fix& fix, const LatLon& origin) {
  const Geodesic line = geodesic_between(origin, fix.place);
  const Direction bearing = unit_direction(line.azimuth);
  // + 0.0: the origin itself has coordinates 0, not -0.
  OnPlane point{line.distance * bearing.sine + 0.0, line.distance * bearing.cosine + 0.0, {}};
  if (!fix.course) return point;
  if (is_opposite(line))
    throw Error("lat, lon are " + shown(fix.place.lat) + ", " + shown(fix.place.lon) +
                ": opposite the origin, where no velocity is defined; write an origin that is closer");
  const Direction off = unit_direction(std::remainder(fix.course->degrees, 360) - line.azimuth -
                                       convergence(line, origin, fix.place));
  const int exponent = exponent_of(fix.course->speed);
  const double speed = std::ldexp(fix.course->speed, -exponent), outward = speed * off.cosine;
  const double across = speed * off.sine * stretch(line.distance, line.reduced_length, origin);
  const double vx = std::ldexp(outward * bearing.sine + across * bearing.cosine, exponent) + 0.0;
  const double vy = std::ldexp(outward * bearing.cosine - across * bearing.sine, exponent) + 0.0;
  if (!std::isfinite(vx) || !std::isfinite(vy))
    throw Error("speed is " + shown(fix.course->speed) +
                ": on the plane that is more than a double holds; write metres per second, or NULL");
  point.v = {vx, vy};
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
  const int exponent = exponent_of(std::max(std::abs((*point.v)[0]), std::abs((*point.v)[1])));
  const double vx = std::ldexp((*point.v)[0], -exponent), vy = std::ldexp((*point.v)[1], -exponent);
  const Direction bearing = unit_direction(azimuth);
  const double outward = vx * bearing.sine + vy * bearing.cosine;
  const double across =
      (vx * bearing.cosine - vy * bearing.sine) / stretch(distance, end.reduced_length, origin);
  const double speed = std::ldexp(std::hypot(outward, across), exponent);
  if (!std::isfinite(speed))
    throw Error("vx, vy are " + shown((*point.v)[0]) + ", " + shown((*point.v)[1]) +
                ": their speed is more than a double holds; write metres per second, or NULL");
  fix.course = Course{speed, speed > 0 ? full_turn(end.azimuth + course_of(across, outward)) : std::nan("")};
  return fix;
}

}  // namespace foresee
