// Convex pieces of one object in the plane, under a tree of boxes: those of its outline, or one box.
//
//   ObjectPieces pieces;
//   pieces.take_row(ships, ships.outlines, 7);        // or take(pieces), take_box(8, 90), take_point()
//   if (pieces.is_leaf(node)) test(pieces.piece(pieces.item(node)));
#pragma once

#include <array>
#include <span>

#include "contact/certified/form_pieces.h"
#include "numbers/exact_conversion.h"
#include "shape/outline/convex_pieces.h"

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

/// See certified/form_pieces.h.
class ObjectPieces : public FormPieces<ObjectPieces, 2, ConvexPieces> {
 public:
  void take_box(const Box<2>& box);
  void take_box(double hx, double hy) { take_box({Vec<2>(-hx, -hy), Vec<2>(hx, hy)}); }
  void take_point() {
    take_box(0, 0);
    is_point_ = true;
  }

  ConvexPiece piece(std::size_t i) const;
  std::size_t corner_count(std::size_t i) const { return form_ ? form_->corners(i).size() : 4; }
  bool is_point() const { return !form_ && is_point_; }

 private:
  std::array<Corner, 4> corners_;
  bool is_point_ = false;
};

// Minkowski sum A + (-B) of two convex polygons, edge by edge: A touches B + d exactly if d lies in it.
//
//   SumEdge edge;
//   for (ConvexSum sum(a, b); sum.next(edge);) use(edge);       // counterclockwise, from the lowest corner
//
// The sum is convex. Each of its edges is an edge of A, moved by minus the extreme corner of B, or an edge
// of B rotated by 180 degrees. The edges of both are merged by their directions, with exact signs (M. de
// Berg et al., "Computational Geometry", 3rd edition, section 13.3). Parallel edges follow each other.
// Cost: some five nanoseconds per edge.

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
    void step() {
      corner = next();
      --left;
    }
  };

  bool a_turns_first() const;

  Walk a_, b_;
};

/// a - b
template <class T>
std::array<T, 2> gap_between(const Corner& a, const Corner& b) {
  return {Exactly<T>::difference_of(a.x, b.x), Exactly<T>::difference_of(a.y, b.y)};
}

}  // namespace foresee
