// Does a ray along x cross the surface of a solid an odd number of times? Then it begins inside (J. O'Rourke,
// "Computational Geometry in C", 2nd edition, section 7.5).
//
//   is_enclosed(solid, corner, steps)
//
// The ray begins at the corner moved by (0, e, e^2) for an infinitesimal e, so that it meets no edge and no
// corner of the solid. Doubles with error bounds tell nearly always; where they do not, exact numbers. Cost:
// some nanoseconds outside of the solid's box; within it about a microsecond, and the logarithm of the
// triangles.
#pragma once

#include "base/steps.h"
#include "contact/mesh/displacement.h"

namespace foresee {

/// Each node looked at is a step. Requires: the corner is not on the surface; there it may say anything.
bool is_enclosed(const TriangleTree& solid, SeenCorner& corner, Steps& steps);

}  // namespace foresee
