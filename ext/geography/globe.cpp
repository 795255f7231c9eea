#include "geography/globe.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/shown.h"
#include "geography/ellipsoid.h"

namespace foresee::geography {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// What is east, north and up at a place, and how the Earth is curved there.
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

constexpr double least_radius = 1e5;  // metres

}  // namespace

OnGlobe to_globe(const Flight& flight) {
  const LatLon& place = flight.fix.place;
  const Horizontal here(direction_of(place.lat), direction_of(std::remainder(place.lon, 360)));
  const double out = here.across + flight.height;
  OnGlobe point{{out * here.up[0], out * here.up[1],
                 (here.across * (1 - eccentricity_squared) + flight.height) * here.up[2]},
                {}};
  if (!flight.fix.course) return point;
  const double speed = flight.fix.course->speed;
  const Direction course = direction_of(flight.fix.course->degrees);
  const double curvature = course.sine * course.sine / (here.across + flight.height) +
                           course.cosine * course.cosine / (here.along + flight.height);
  OnGlobe::Motion motion{};
  for (std::size_t i = 0; i < 3; ++i) {
    motion.v[i] =
        speed * (course.sine * here.east[i] + course.cosine * here.north[i]) + flight.climb * here.up[i];
    motion.a[i] = -speed * speed * curvature * here.up[i];
  }
  point.motion = motion;
  return point;
}

Flight from_globe(const OnGlobe& point) {
  const auto [x, y, z] = point.x;
  const double p = std::hypot(x, y);
  if (!(std::hypot(p, z) >= least_radius))
    throw Error("x, y, z are " + shown(std::hypot(p, z)) +
                " m from the centre of the Earth: heights are meant from 100 km on");
  // Of the reduced latitude: tan = z / p, and so on.
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
  // Along the vertical, which neither the pole nor the equator makes a division by nothing.
  flight.height = p * cosine + z * sine - across * (1 - eccentricity_squared * sine * sine);
  if (!point.motion) return flight;
  const Direction lon = p > 0 ? Direction{y / p, x / p} : Direction{0, 1};
  const Horizontal here({sine, cosine}, lon);
  const double east = dot(point.motion->v, here.east), north = dot(point.motion->v, here.north);
  const double speed = std::hypot(east, north);
  flight.fix.course = Course{speed, speed > 0 ? course_of(east, north) : std::nan("")};
  flight.climb = dot(point.motion->v, here.up);
  return flight;
}

}  // namespace foresee::geography
