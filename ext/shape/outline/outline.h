// Outline: a flat region around an object's position, of parts with an outer ring and holes (a multipolygon).
//
//   Outline hull;                                          // POLYGON((-8 -90, 8 -90, 0 90, -8 -90))
//   hull.begin_part();
//   for (const Corner& corner : {Corner{-8, -90}, Corner{8, -90}, Corner{0, 90}}) hull.add(corner);
//   hull.ring(0).size() == 3                               // the first corner does not come again at the end
//   hull.extents().lower[1] == -90
//
// The region is closed: the outer rings and what they enclose, minus the insides of holes; the rings of holes
// belong to it. Rings may run either way round. The position need not lie within, nor in the middle. An
// outline is built ring by ring and then only read: many rows and statements share one.
//
// An outline holds what was written. validity.h checks that its rings are valid and lie correctly; all else
// here may rely on it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/axis_aligned_box.h"

namespace foresee {

/// Finite, and never -0; or a vector, in rounded arithmetic.
struct Corner {
  double x, y;

  friend bool operator==(const Corner&, const Corner&) = default;
  friend Corner operator-(const Corner& a, const Corner& b) { return {a.x - b.x, a.y - b.y}; }
  friend double dot(const Corner& a, const Corner& b) { return a.x * b.x + a.y * b.y; }
  friend double cross(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }
};

/// The maximum number of corners of an outline, without closing ones.
constexpr std::size_t max_corners = 65536;

class Outline {
 public:
  /// Starts a new part and its outer ring.
  void begin_part();
  /// Starts a hole of the last part.
  void begin_hole();
  /// Adds a corner to the last ring, unless it equals the corner before it.
  void add(const Corner& corner);
  /// Drops the last corner of the last ring if it equals the first; returns whether it did.
  bool close_ring();

  /// All corners, ring after ring.
  std::span<const Corner> corners() const { return corners_; }
  std::size_t rings() const { return ring_ends_.size(); }
  std::size_t parts() const { return part_starts_.size(); }
  std::span<const Corner> ring(std::size_t r) const {
    return corners().subspan(ring_start(r), ring_ends_[r] - ring_start(r));
  }
  /// Index of the first corner of ring r among all corners.
  std::size_t ring_start(std::size_t r) const { return r == 0 ? 0 : ring_ends_[r - 1]; }
  /// Index of the first ring of part p, its outer ring; the part ends at the first ring of the next part.
  std::size_t part_start(std::size_t p) const { return p == parts() ? rings() : part_starts_[p]; }

  /// The bounding box relative to the position. Requires: at least one corner.
  Extents<2> extents() const;

  friend bool operator==(const Outline&, const Outline&) = default;

 private:
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> ring_ends_;    ///< end index of each ring's corners
  std::vector<std::uint32_t> part_starts_;  ///< index of each part's first ring
};

// Exact orientation predicate: on which side of a line a corner lies, mostly at the cost of doubles.
//
//   orientation({0, 0}, {1, 0}, {0, 1}) == 1          // left; -1: right; 0: on the line
//
// Three stages, as in J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates" (Discrete & Computational Geometry 18, 1997). Doubles with an error bound nearly always decide.
// If the differences are exact, as between integers, two products in double-double decide. Exact numbers
// decide the rest. Cost: 2 ns, 10 ns, half a microsecond.

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
