// Triangulation of an outline by one plane sweep.
//
//   const std::vector<TriangleSide> sides = triangulation(outline);
//   sides[3 * t], sides[3 * t + 1], sides[3 * t + 2]                  // triangle t, counterclockwise
//
// Every gap between two edges that belongs to the region keeps the boundary of its uncut rest: a chain of
// corners that bulges to the right. Each new corner cuts off all triangles that it sees.
//
// As in S. Hertel, K. Mehlhorn, "Fast triangulation of the plane with respect to simple polygons"
// (Information and Control 64, 1985), extended to places where any number of rings touch, at corners and
// along edges. It adds no corner, and no triangle is flat. Cost: n log n, some 300 ns per corner.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "shape/outline/outline.h"

namespace foresee {

/// The side of a triangle from a corner to the next.
struct TriangleSide {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t corner;       ///< index in the outline, of this corner or of an equal one
  std::uint32_t twin = none;  ///< the side of the triangle beyond; none: the side lies on the outline
};

/// Requires: a valid outline (validity.h).
std::vector<TriangleSide> triangulation(const Outline& outline);

}  // namespace foresee
