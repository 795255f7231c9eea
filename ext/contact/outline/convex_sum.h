// Minkowski sum A + (-B) of two convex polygons, edge by edge: A touches B + d exactly if d lies in it.
//
//   SumEdge edge;
//   for (ConvexSum sum(a, b); sum.next(edge);) use(edge);       // counterclockwise, from the lowest corner
//
// The sum is convex. Each of its edges is an edge of A, moved by minus the extreme corner of B, or an edge
// of B rotated by 180 degrees. The edges of both are merged by their directions, with exact signs (M. de
// Berg et al., "Computational Geometry", 3rd edition, section 13.3). Parallel edges follow each other.
// Cost: some five nanoseconds per edge.
#pragma once

#include <span>

#include "numbers/exact_conversion.h"
#include "shape/outline/outline.h"

namespace foresee {

/// A counterclockwise convex ring, which may be straight at a corner; or one point.
struct ConvexPiece {
  std::span<const Corner> corners;
  /// Edge i has the direction from point i to point i + 1 of these. They are the corners, except for boxes:
  /// a box without width has edge directions too.
  const Corner* along;
  const std::uint8_t* inner;  ///< 1 for each edge that is a cut of its outline; null: no cuts

  int edges() const { return corners.size() < 3 ? 0 : static_cast<int>(corners.size()); }
};

/// An edge of the sum, from p - q to p_end - q_end. Its direction is that from `from` to `to`.
struct SumEdge {
  const Corner *from, *to;
  const Corner *p, *q, *p_end, *q_end;
  bool inner;
};

class ConvexSum {
 public:
  /// Requires: one of the pieces has edges; both outlive the walk.
  ConvexSum(const ConvexPiece& a, const ConvexPiece& b);

  bool next(SumEdge& edge);

 private:
  /// The position of the walk on one of the two pieces.
  struct Walk {
    const ConvexPiece& piece;
    int corner, left;  ///< the current corner and the number of edges left

    int next() const { return corner + 1 == static_cast<int>(piece.corners.size()) ? 0 : corner + 1; }
    const Corner* at(int i) const { return &piece.corners[static_cast<std::size_t>(i)]; }
    const Corner* along(int i) const { return piece.along + i; }
    void step() { corner = next(), --left; }
  };

  bool a_turns_first() const;

  Walk a_, b_;
};

/// The coordinate of an edge's start on an axis.
template <class T>
T start_of(const SumEdge& edge, int axis) {
  return axis == 0 ? Exactly<T>::difference_of(edge.p->x, edge.q->x)
                   : Exactly<T>::difference_of(edge.p->y, edge.q->y);
}
/// The coordinate of its end.
template <class T>
T end_of(const SumEdge& edge, int axis) {
  return axis == 0 ? Exactly<T>::difference_of(edge.p_end->x, edge.q_end->x)
                   : Exactly<T>::difference_of(edge.p_end->y, edge.q_end->y);
}
/// The component of an edge's direction vector, which may be longer than the edge.
template <class T>
T run_of(const SumEdge& edge, int axis) {
  return axis == 0 ? Exactly<T>::difference_of(edge.to->x, edge.from->x)
                   : Exactly<T>::difference_of(edge.to->y, edge.from->y);
}
}  // namespace foresee
