// How is an outline cut into triangles? By one sweep: every gap between two edges that is part of the region
// keeps the boundary of what is not cut yet, a chain of corners that bulges to the right; each corner that
// comes cuts off all triangles that it sees.
//
//   const std::vector<TriangleSide> sides = triangulation(outline);
//   sides[3 * t], sides[3 * t + 1], sides[3 * t + 2]                  // triangle t, counterclockwise
//
// As in S. Hertel, K. Mehlhorn, "Fast triangulation of the plane with respect to simple polygons"
// (Information and Control 64, 1985), with places where any number of rings touch, at corners and along
// edges. No corner is new, no triangle is flat. Cost: n log n, some 300 ns a corner.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "shape/outline/outline.h"

namespace foresee {

/// From a corner of a triangle to the next.
struct TriangleSide {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t corner;       ///< by its place in the outline, or that of another corner in the same point
  std::uint32_t twin = none;  ///< the side of the triangle beyond; none: the side lies on the outline
};

/// Requires: a valid outline (validity.h).
std::vector<TriangleSide> triangulation(const Outline& outline);

}  // namespace foresee
