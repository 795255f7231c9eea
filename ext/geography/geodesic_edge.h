// Cuts a geodesic into pieces whose chords on an azimuthal equidistant plane stay within a metre of it.
//
//   const std::vector<LatLon> between = cut_edge({54, 7}, {54, 9}, 75000);   // inner places, from a to b
//
// The bound. In polar coordinates about the origin the metric of the ground is d rho^2 + m^2 d theta^2, with
// m = R sin(rho / R) on a sphere of radius R; that of the plane is d rho^2 + rho^2 d theta^2. For a geodesic at
// the angle psi to the radius, m sin psi is constant (Clairaut). So, with u = rho / R, the second derivative of
// its image by length is (u - sin u cos u) / sin^2 u * sin^2 psi / R towards the origin, and 2 (1 - u cot u) /
// sin u * sin psi cos psi / R across. Both factors are 2 u / 3 times at most 1 + 7 u^2 / 30 + ...; within 1,500
// km the derivative is thus at most 2 rho / (3 R^2) * 1.014.
//
// A curve whose second derivative is at most c leaves the chord of a piece of length L by at most c L^2 / 8. The
// curvature 1 / R^2 of the ellipsoid is largest at the equator; its variation adds less than 0.2 %. The code
// takes 1.1 in place of 1.014. The distance from the origin is convex along a geodesic, so it is largest at an
// end. Lengths on the plane are at least those on the ground, so that the bound holds on the ground too.
#pragma once

#include <vector>

#include "geography/geodesic.h"

namespace foresee {

/// A place with one notation: the longitude is in (-180, 180], and 0 at a pole.
LatLon canonical_place(const LatLon& place);

/// Whether the edge needs no cut. `length`: at least its length, as between its ends on the plane. `from_origin`:
/// the larger distance of an end from the origin of the plane.
bool is_short_edge(double length, double from_origin);

/// The places that divide the shortest line from `a` to `b` into equal pieces, without its ends; none for a
/// short line. The same places in reverse order from `b` to `a`, so that neighbours share an edge bit for
/// bit. `from_origin`: the larger distance of an end from the origin of the plane. Requires: both are canonical
/// and from_origin <= max_distance_from_origin (plane.h). Cost: some microseconds per place.
std::vector<LatLon> cut_edge(const LatLon& a, const LatLon& b, double from_origin);

}  // namespace foresee
