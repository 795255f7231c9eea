#include "geography/geodesic.h"

// GCC warns that a number of the inverse formula may be uninitialized; it is set wherever it is read.
#pragma GCC diagnostic push
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/geometry/formulas/karney_direct.hpp>
#include <boost/geometry/formulas/karney_inverse.hpp>
#pragma GCC diagnostic pop
#include <boost/geometry/srs/spheroid.hpp>
#include <cmath>

#include "geography/ellipsoid.h"

namespace foresee {
namespace {

namespace formula = boost::geometry::formula;

const boost::geometry::srs::spheroid<double> earth(semi_major, semi_minor);

double within_half_turn(double degrees) {
  return std::remainder(degrees, 360);
}

}  // namespace

Geodesic geodesic_between(const LatLon& from, const LatLon& to) {
  const auto found = formula::karney_inverse<double, true, true, true, true>::apply(
      within_half_turn(from.lon), from.lat, within_half_turn(to.lon), to.lat, earth);
  return {found.distance, found.azimuth, found.reverse_azimuth, found.reduced_length};
}

// At a pole Boost's direct formula loses the longitude, because it multiplies by the cosine of the latitude.
// There each azimuth is a meridian of known longitude; the formula then gives the latitude along it.
GeodesicEnd geodesic_from(const LatLon& from, double azimuth, double distance) {
  const double lon = within_half_turn(from.lon);
  if (distance == 0) return {{from.lat, lon}, within_half_turn(azimuth), 0};
  const bool north_pole = from.lat == 90, at_pole = north_pole || from.lat == -90;
  const double start = at_pole ? (north_pole ? 180 : 0) : within_half_turn(azimuth);
  const auto found =
      formula::karney_direct<double, true, true, true>::apply(lon, from.lat, distance, start, earth);
  if (!at_pole) {
    const LatLon place{found.lat2, within_half_turn(found.lon2)};
    // At an arrival in a pole the formula's azimuth is the angle of (0, 0); the inverse formula has the right
    // one.
    const bool into_pole = std::abs(place.lat) == 90;
    const double arrival = into_pole ? geodesic_between(from, place).azimuth_there : found.reverse_azimuth;
    return {place, arrival, found.reduced_length};
  }
  const double meridian = north_pole ? 180 - within_half_turn(azimuth) : within_half_turn(azimuth);
  const bool beyond_other_pole = (std::abs(found.reverse_azimuth) < 90) == north_pole;
  return {{found.lat2, within_half_turn(lon + meridian + (beyond_other_pole ? 180 : 0))},
          found.reverse_azimuth,
          found.reduced_length};
}

}  // namespace foresee
