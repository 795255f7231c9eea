// The judge of meshes in uniform motion: triangle by triangle in whole numbers, rays between.
//
// It knows nothing of trees, parts or sums of shapes: for every two triangles, the moments at which a corner
// of one crosses the other and at which two of their edges cross, from parameters along both (Cramer's rule).
// As both are convex they meet from the first such moment to the last, and at an end of what is asked if they
// do so at rest. In the gaps that are left no surfaces meet, so one corner of each triangle says whether
// something lies within the other solid: a ray in some direction, another if it meets an edge, leaves the
// solid through an odd number of triangles. All together, in order of time, are the contacts.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/rational_judge.h"
#include "shape/mesh/mesh.h"

namespace foresee::oracle {

/// A place in space, exactly.
using SpacePlace = std::array<Rational, 3>;

/// A surface; or a solid: what an odd number of its triangles lie around, with them.
struct Body {
  std::vector<std::array<SpaceCorner, 3>> triangles;
  bool is_solid = false;
};

Body body_of(const Mesh& mesh);
/// Where halves are 0 a rectangle, an edge or a point.
Body box_body(double half_x, double half_y, double half_z);

/// The first stretch of contact within `queried` of `a` at rest and `b`, which is at place + s velocity.
std::optional<RationalInterval> first_contact(const Body& a, const Body& b, const SpacePlace& place,
                                       const SpacePlace& velocity, const RationalInterval& queried);

/// Does b, moved by `place`, come within `radius` of a, or lie in it? At one moment, whatever the motion.
bool touch_at(const Body& a, const Body& b, const SpacePlace& place, const Rational& radius);

}  // namespace foresee::oracle
