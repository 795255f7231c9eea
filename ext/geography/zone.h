// Reads a zone, a polygon in longitude and latitude, and projects it to an outline on a plane.
//
//   const Zone shoal = read_zone("POLYGON((7.8 53.9, 8 53.9, 7.9 54, 7.8 53.9))", {53.9, 7.9}, interrupt);
//   shoal.plane.corners()[0].x < 0       // metres east of the origin
//   write_outline(shoal.degrees)         // the corners as they were written
//
// The text is well-known text as wkt.h reads it: POLYGON or MULTIPOLYGON, with holes, longitude first.
// "SRID=4326;" is accepted. Corners are those of to_plane(); edges are geodesics, the shortest lines on the
// ellipsoid, and stay within a metre of them (geodesic_edge.h). An edge may cross the date line, from 179 to
// -179, and a zone may contain a pole. Shapes of the plane are checked by validity.h.
//
// Throws Error for a text that is not an outline, a latitude beyond 90, a longitude beyond 180 and a corner
// farther than 1,500 km from the origin. Also for an edge from -180 to 180 along a parallel, and for parts that
// meet along the date line.
// Cost: some 2 microseconds per corner, 5 per corner of a cut edge.
#pragma once

#include <string_view>

#include "base/error.h"
#include "geography/geodesic.h"
#include "shape/outline/outline.h"

namespace foresee {

struct Zone {
  Outline degrees;  ///< x: longitude, y: latitude
  Outline plane;    ///< metres
};

Zone read_zone(std::string_view text, const LatLon& origin, Interrupt& interrupt);

/// The region that the corners in degrees enclose, on the plane about `origin`.
Outline zone_on_plane(const Outline& degrees, const LatLon& origin, Interrupt& interrupt);

}  // namespace foresee
