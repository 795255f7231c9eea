// Test oracle for contact of meshes in uniform motion, in integers: triangle against triangle, and rays.
//
// It uses no trees, components or Minkowski sums. For every two triangles it computes when a corner of one
// crosses the other and when two of their edges cross, from parameters along both (Cramer's rule). As both
// are convex, they touch from the first such time to the last. At an end of the queried time a test of two
// triangles at rest decides. In the remaining gaps no surfaces touch, so one corner of each triangle
// decides whether something is inside the other solid. A ray from it, or another ray if that meets an
// edge, leaves the solid through an odd number of triangles. All contacts together are sorted by time.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/rational_judge.h"
#include "shape/mesh/mesh.h"

namespace foresee::oracle {

/// An exact position in space.
using SpacePlace = std::array<Rational, 3>;

/// A surface, or a solid: the points from which a ray crosses an odd number of triangles, with these.
struct Body {
  std::vector<std::array<SpaceCorner, 3>> triangles;
  bool is_solid = false;
};

Body body_of(const Mesh& mesh);
/// A box; a rectangle, an edge or a point if some half extents are 0.
Body box_body(double half_x, double half_y, double half_z);

/// The first interval of contact within `queried`, of `a` at rest and `b` at place + s velocity.
std::optional<RationalInterval> first_contact(const Body& a, const Body& b, const SpacePlace& place,
                                              const SpacePlace& velocity, const RationalInterval& queried);

/// Whether b, moved by `place`, is within `radius` of a or inside of it, at one instant.
bool touch_at(const Body& a, const Body& b, const SpacePlace& place, const Rational& radius);

}  // namespace foresee::oracle
