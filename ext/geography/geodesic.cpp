#include "geography/geodesic.h"

// GCC takes a number of the inverse for one that nobody may have set; it is, wherever it is read.
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

namespace foresee::geography {
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

GeodesicEnd geodesic_from(const LatLon& from, double azimuth, double distance) {
  const auto found = formula::karney_direct<double, true, true, true>::apply(
      within_half_turn(from.lon), from.lat, distance, within_half_turn(azimuth), earth);
  return {{found.lat2, within_half_turn(found.lon2)}, found.reverse_azimuth, found.reduced_length};
}

}  // namespace foresee::geography
