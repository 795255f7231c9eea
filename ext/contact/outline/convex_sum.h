// Where is d when two convex pieces touch, one of them moved by d? In their Minkowski sum: A touches B + d
// just if d lies in A + (-B), which is convex too. This walks around it, edge by edge.
//
//   SumEdge edge;
//   for (ConvexSum sum(a, b); sum.next(edge);) use(edge);       // counterclockwise, from the lowest corner
//
// Every edge of the sum is one of A, from a corner of A minus the extreme corner of B, or one of B turned
// round: the edges of both are merged by their directions, by exact signs (M. de Berg et al., "Computational
// Geometry", 3rd edition, section 13.3). Parallel edges come one after the other. Cost: some five
// nanoseconds an edge.
#pragma once

#include <span>

#include "contact/set/primitive.h"
#include "shape/outline/outline.h"

namespace foresee {

/// A ring, counterclockwise, which turns left or goes straight on at each corner; or one point.
struct ConvexPiece {
  std::span<const Corner> corners;
  /// Edge i runs as from corner i to corner i + 1 of these: the corners, but for boxes of no width, whose
  /// edges have directions too.
  const Corner* along;
  const std::uint8_t* inner;  ///< 1 for each edge that is a cut of its outline; null: none is

  int edges() const { return corners.size() < 3 ? 0 : static_cast<int>(corners.size()); }
};

/// One edge: from p - q as far as from p_end - q_end, in the direction from `from` to `to`.
struct SumEdge {
  const Corner *from, *to;
  const Corner *p, *q, *p_end, *q_end;
  bool inner;
};

class ConvexSum {
 public:
  /// The pieces must outlive the walk. Requires: one of them has edges.
  ConvexSum(const ConvexPiece& a, const ConvexPiece& b);

  bool next(SumEdge& edge);

 private:
  /// How far the walk has come around one of the two.
  struct Walk {
    const ConvexPiece& piece;
    int corner, left;  ///< the corner reached, and how many edges are left

    int next() const { return corner + 1 == static_cast<int>(piece.corners.size()) ? 0 : corner + 1; }
    const Corner* at(int i) const { return &piece.corners[static_cast<std::size_t>(i)]; }
    const Corner* along(int i) const { return piece.along + i; }
    void step() { corner = next(), --left; }
  };

  bool a_turns_first() const;

  Walk a_, b_;
};

/// Where it begins, on an axis.
template <class T>
T start_of(const SumEdge& edge, int axis) {
  return axis == 0 ? Exactly<T>::difference_of(edge.p->x, edge.q->x)
                   : Exactly<T>::difference_of(edge.p->y, edge.q->y);
}
/// Where it ends.
template <class T>
T end_of(const SumEdge& edge, int axis) {
  return axis == 0 ? Exactly<T>::difference_of(edge.p_end->x, edge.q_end->x)
                   : Exactly<T>::difference_of(edge.p_end->y, edge.q_end->y);
}
/// How far it runs along an axis: its direction, which may be longer than the edge.
template <class T>
T run_of(const SumEdge& edge, int axis) {
  return axis == 0 ? Exactly<T>::difference_of(edge.to->x, edge.from->x)
                   : Exactly<T>::difference_of(edge.to->y, edge.from->y);
}
template <class T>
T squared_length(const SumEdge& edge) {
  return square(run_of<T>(edge, 0)) + square(run_of<T>(edge, 1));
}

/// How far d is beyond an edge, to its right, in lengths of its direction: at most 0 inside. `x`: d by powers
/// of time.
template <int K, class T>
Coefficients<T, K> beyond(const SumEdge& edge, const Coefficients<T, K>* x) {
  const T ex = run_of<T>(edge, 0), ey = run_of<T>(edge, 1);
  Coefficients<T, K> p{};
  p[0] = ey * (x[0][0] - start_of<T>(edge, 0)) - ex * (x[1][0] - start_of<T>(edge, 1));
  for (int k = 1; k <= K; ++k) p[k] = ey * x[0][k] - ex * x[1][k];
  return p;
}

/// How far d is past the end of an edge (sign 1), or before its begin (-1), likewise.
template <int K, class T>
Coefficients<T, K> past(const SumEdge& edge, int sign, const Coefficients<T, K>* x) {
  using E = Exactly<T>;
  const T ex = run_of<T>(edge, 0), ey = run_of<T>(edge, 1);
  const Corner &p_at = sign > 0 ? *edge.p_end : *edge.p, &q_at = sign > 0 ? *edge.q_end : *edge.q;
  Coefficients<T, K> p{};
  p[0] =
      ex * (x[0][0] - E::difference_of(p_at.x, q_at.x)) + ey * (x[1][0] - E::difference_of(p_at.y, q_at.y));
  for (int k = 1; k <= K; ++k) p[k] = ex * x[0][k] + ey * x[1][k];
  if (sign < 0)
    for (T& c : p) c = -c;
  return p;
}

}  // namespace foresee
