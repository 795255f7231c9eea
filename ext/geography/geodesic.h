// How far is it from place to place on the Earth, and where does one come by going straight on?
//
//   const Geodesic line = geodesic_between({40.6, -73.8}, {51.6, -0.5});     // JFK to LHR
//   line.distance == 5551759.400  // metres, to the millimetre shown
//   const GeodesicEnd there = geodesic_from({40.6, -73.8}, line.azimuth, line.distance);
//
// The Earth is the ellipsoid of WGS84; the lines are its geodesics, the shortest ones (Karney, "Algorithms
// for geodesics", Journal of Geodesy 87, 2013, sections 2 to 6, as Boost.Geometry has them). Angles are
// degrees, azimuths clockwise from north; longitudes and azimuths of any size are taken modulo 360. Errors
// are some nanometres. Cost: about a microsecond.
#pragma once

namespace foresee {

/// Requires: finite, |lat| <= 90.
struct LatLon {
  double lat, lon;
};

struct Geodesic {
  double distance;        ///< metres
  double azimuth;         ///< in which it leaves
  double azimuth_there;   ///< in which it arrives, and would go on
  double reduced_length;  ///< how far apart, per radian between them at its beginning, its neighbours arrive
};

struct GeodesicEnd {
  LatLon place;
  double azimuth;
  double reduced_length;
};

Geodesic geodesic_between(const LatLon& from, const LatLon& to);
GeodesicEnd geodesic_from(const LatLon& from, double azimuth, double distance);

/// Half the length of a meridian, 20003931.45862545 m, rounded up: no two places are farther apart, as
/// computed neither.
inline constexpr double greatest_distance = 20003931.458626;

}  // namespace foresee
