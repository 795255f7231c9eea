// Exact orientation predicate: on which side of a line a corner lies, mostly at the cost of doubles.
//
//   orientation({0, 0}, {1, 0}, {0, 1}) == 1          // left; -1: right; 0: on the line
//
// Three stages, as in J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates" (Discrete & Computational Geometry 18, 1997). Doubles with an error bound nearly always decide.
// If the differences are exact, as between integers, two products in double-double decide. Exact numbers
// decide the rest. Cost: 2 ns, 10 ns, half a microsecond.
#pragma once

#include <cmath>
#include <span>

#include "shape/outline/outline.h"

namespace foresee {

/// The slow path of turn_sign(), where doubles with an error bound do not decide.
int close_turn_sign(const Corner& a, const Corner& b, const Corner& c, const Corner& d);

/// Whether the direction from c to d turns left (1) or right (-1) of that from a to b, or neither (0): the
/// sign of their cross product. Requires: rounding to nearest.
inline int turn_sign(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  constexpr double relative = 0x3.0000000000002p-53, underflow = 0x1p-960;
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  const double cross = left - right;
  const double error = relative * (std::abs(left) + std::abs(right)) + underflow;
  if (cross > error) return 1;
  if (cross < -error) return -1;
  return close_turn_sign(a, b, c, d);
}

/// Whether c lies left (1) or right (-1) of the line from a to b, or on it (0): the sign of twice the area of
/// the triangle. Requires: rounding to nearest.
inline int orientation(const Corner& a, const Corner& b, const Corner& c) {
  return turn_sign(c, a, c, b);
}

/// The order of a sweep: by x, then by y.
inline bool before(const Corner& a, const Corner& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Whether the ring is counterclockwise, decided at its leftmost corner. Requires: at least two corners.
bool is_counterclockwise(std::span<const Corner> ring);

/// The direction of a convex ring with an area: 1 counterclockwise, -1 clockwise; 0 for any other ring.
/// Corners may lie on the line between their neighbours.
int convex_direction(std::span<const Corner> ring);

}  // namespace foresee
