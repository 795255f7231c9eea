#include "geography/globe.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/number_text.h"
#include "geography/ellipsoid.h"

namespace foresee {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The directions east, north and up at a place, and the Earth's curvature there.
struct Horizontal {
  Vector east, north, up;
  double across, along;  ///< radii of curvature, across the meridian and along it

  Horizontal(const Direction& lat, const Direction& lon)
      : east{-lon.sine, lon.cosine, 0},
        north{-lat.sine * lon.cosine, -lat.sine * lon.sine, lat.cosine},
        up{lat.cosine * lon.cosine, lat.cosine * lon.sine, lat.sine} {
    const double flat = 1 - eccentricity_squared * lat.sine * lat.sine;
    across = semi_major / std::sqrt(flat);
    along = across * (1 - eccentricity_squared) / flat;
  }
};

constexpr double min_radius = 1e5;  // metres

bool all_finite(const Vector& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

OnGlobe::Motion motion_of(const Flight& flight, const Horizontal& here) {
  const Course& given = *flight.fix.course;
  const Direction course = unit_direction(given.degrees);
  const double across = here.across + flight.height, along = here.along + flight.height;
  const double curvature = course.sine * course.sine / across + course.cosine * course.cosine / along;
  // Turn of the vertical per metre of the course.
  const double turn_east = course.sine / across, turn_north = course.cosine / along;
  const int exponent = exponent_of(std::max(std::abs(given.speed), std::abs(flight.climb)));
  const int square = exponent_of(given.speed);
  const double speed = std::ldexp(given.speed, -exponent), climb = std::ldexp(flight.climb, -exponent);
  const double s = std::ldexp(given.speed, -square);
  OnGlobe::Motion motion{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double v =
        speed * (course.sine * here.east[i] + course.cosine * here.north[i]) + climb * here.up[i];
    const double of_climb = climb * speed * (turn_east * here.east[i] + turn_north * here.north[i]);
    motion.v[i] = std::ldexp(v, exponent) + 0.0;
    motion.a[i] =
        std::ldexp(-s * s * curvature * here.up[i], 2 * square) + std::ldexp(of_climb, 2 * exponent) + 0.0;
  }
  if (!all_finite(motion.v) || !all_finite(motion.a))
    throw Error("speed, climb are " + shown(given.speed) + ", " + shown(flight.climb) +
                ": velocity or acceleration is more than a double holds; write metres per second, or NULL");
  return motion;
}

}  // namespace

OnGlobe to_globe(const Flight& flight) {
  const LatLon& place = flight.fix.place;
  const Horizontal here(unit_direction(place.lat), unit_direction(std::remainder(place.lon, 360)));
  if (!(here.along + flight.height >= min_radius))
    throw Error("height is " + shown(flight.height) +
                " m: the centre of the Earth is 6.4e6 m down; write metres above the ellipsoid, or NULL");
  const double out = here.across + flight.height;
  OnGlobe point{{out * here.up[0] + 0.0, out * here.up[1] + 0.0,
                 (here.across * (1 - eccentricity_squared) + flight.height) * here.up[2] + 0.0},
                {}};
  if (flight.fix.course) point.motion = motion_of(flight, here);
  return point;
}

Flight from_globe(const OnGlobe& point) {
  // + 0.0: on the axis the longitude is 0 for every sign of the zeros x and y.
  const double x = point.x[0] + 0.0, y = point.x[1] + 0.0, z = point.x[2] + 0.0, p = std::hypot(x, y);
  if (!(std::hypot(p, z) >= min_radius))
    throw Error("x, y, z are " + shown(std::hypot(p, z)) +
                " m from the centre of the Earth, closer than 100 km: write metres, not degrees");
  // Start of the iteration: the reduced latitude, tan = z / p.
  const double squashed = semi_minor / semi_major;
  const double second = eccentricity_squared / (1 - eccentricity_squared);
  double reduced = std::atan2(z, p * squashed), lat = 0;
  for (int i = 0; i < 20; ++i) {
    const double s = std::sin(reduced), c = std::cos(reduced);
    lat = std::atan2(z + second * semi_minor * s * s * s, p - eccentricity_squared * semi_major * c * c * c);
    const double next = std::atan2(squashed * std::sin(lat), std::cos(lat));
    if (next == reduced) break;
    reduced = next;
  }
  constexpr double degree = 180 / 3.14159265358979323846;
  const double cosine = std::cos(lat), sine = std::sin(lat);
  const double across = semi_major / std::sqrt(1 - eccentricity_squared * sine * sine);
  Flight flight;
  flight.fix.place = {lat * degree, std::atan2(y, x) * degree};
  // Measured along the vertical: this form divides by zero neither at a pole nor at the equator.
  flight.height = p * cosine + z * sine - across * (1 - eccentricity_squared * sine * sine);
  if (!std::isfinite(flight.height))
    throw Error("x, y, z are " + shown(x) + ", " + shown(y) + ", " + shown(z) +
                ": their height is more than a double holds; write metres");
  if (!point.motion) return flight;
  const int near_axis = exponent_of(p);
  const double xn = std::ldexp(x, -near_axis), yn = std::ldexp(y, -near_axis), pn = std::hypot(xn, yn);
  const Direction lon = p > 0 ? Direction{yn / pn, xn / pn} : Direction{0, 1};
  const Horizontal here({sine, cosine}, lon);
  Vector v = point.motion->v;
  const int exponent = exponent_of(std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}));
  for (double& part : v) part = std::ldexp(part, -exponent);
  const double east = dot(v, here.east), north = dot(v, here.north), across_ground = std::hypot(east, north);
  // What the rounding of a vertical motion leaves has no direction.
  const bool moves = across_ground > 0x1p-50 * std::abs(dot(v, here.up));
  const double speed = moves ? std::ldexp(across_ground, exponent) : 0;
  flight.climb = std::ldexp(dot(v, here.up), exponent) + 0.0;
  if (!std::isfinite(speed) || !std::isfinite(flight.climb))
    throw Error("vx, vy, vz are " + shown(point.motion->v[0]) + ", " + shown(point.motion->v[1]) + ", " +
                shown(point.motion->v[2]) +
                ": their speed or climb is more than a double holds; write metres per second, or NULL");
  flight.fix.course = Course{speed, moves ? course_of(east, north) : std::nan("")};
  return flight;
}

}  // namespace foresee
