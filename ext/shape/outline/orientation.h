// On which side of a line does a corner lie? The exact sign, at the cost of doubles.
//
//   orientation({0, 0}, {1, 0}, {0, 1}) == 1          // left; -1: right; 0: on the line
//
// A staircase, as in J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates" (Discrete & Computational Geometry 18, 1997): doubles with an error bound tell nearly always;
// where the differences are exact, as between whole numbers, so are two products in twice the precision; what
// is left goes to exact numbers. Cost: 2 ns, 10 ns, half a microsecond.
#pragma once

#include <cmath>
#include <span>

#include "shape/outline/outline.h"

namespace foresee {

/// What turn_sign() says where doubles with an error bound do not tell.
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

/// Whether the ring runs counterclockwise: as it does at its first corner from the left. Requires: two
/// corners or more.
bool is_counterclockwise(std::span<const Corner> ring);

/// Whether the ring is convex, encloses more than a line, and runs so round: 1 counterclockwise, -1
/// clockwise; 0 if it is no such ring. Corners may lie on the line between their neighbours.
int convex_direction(std::span<const Corner> ring);

}  // namespace foresee
