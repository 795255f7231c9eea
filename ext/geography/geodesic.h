// Geodesics on the WGS84 ellipsoid: distance and azimuth between two places, and the end of a straight
// course.
//
//   const Geodesic line = geodesic_between({40.6, -73.8}, {51.6, -0.5});     // JFK to LHR
//   line.distance == 5551759.400  // metres, to the millimetre shown
//   const GeodesicEnd there = geodesic_from({40.6, -73.8}, line.azimuth, line.distance);
//
// The lines are the shortest geodesics, as Boost.Geometry computes them (Karney, "Algorithms for geodesics",
// Journal of Geodesy 87, 2013, sections 2 to 6). Angles are degrees, azimuths clockwise from north;
// longitudes and azimuths of any size are taken modulo 360. Errors: some nanometres. Cost: about a
// microsecond.
#pragma once

namespace foresee {

/// Requires: finite, |lat| <= 90.
struct LatLon {
  double lat, lon;
};

struct Geodesic {
  double distance;        ///< metres
  double azimuth;         ///< at the start
  double azimuth_there;   ///< at the end, in the direction of travel
  double reduced_length;  ///< separation at the end per radian of azimuth at the start
};

struct GeodesicEnd {
  LatLon place;
  double azimuth;
  double reduced_length;
};

Geodesic geodesic_between(const LatLon& from, const LatLon& to);
GeodesicEnd geodesic_from(const LatLon& from, double azimuth, double distance);

/// Half the length of a meridian, 20003931.45862545 m, rounded up: an upper bound of every distance, also as
/// computed.
inline constexpr double greatest_distance = 20003931.458626;

}  // namespace foresee
