// Node tests of TreeWalk for meshes: boxes and bounding discs of two nodes cut the time at which triangles
// below them could touch (shape/mesh/triangle_tree.h).
//
//   const DiscTests tests(a, b, chord, relative, sizes, end);
//   const Interval<double> near = tests.near(node_a, node_b, {0, end});             // empty: never
//
// While two discs touch, the component of d along the normal of each is at most the sum of their extents in
// that direction. Along the normal of the other, a disc's extent comes from its thickness and its radius. The
// slack is that of triangle_filter.h, and far smaller than the margins of the discs themselves. If one object
// has no discs, boxes alone decide. Cost: some ten nanoseconds, and one cache line per node.
#pragma once

#include "contact/certified/tree_walk.h"
#include "contact/mesh/space_constraint.h"

namespace foresee {

class DiscTests {
 public:
  using Node = SpacePieces::Node;

  /// Pieces and chord must outlive this.
  DiscTests(const SpacePieces& a, const SpacePieces& b, const Chord<3>& chord,
            const CertainMotion<3>& relative, const SpaceSizes<Bounded>& sizes, double end);

  Interval<double> near(Node a, Node b, const Interval<double>& queried) const {
    if (!a_) return boxes_.near(a, b, queried);
    const BoundingDisc &one = a_->of(a), &other = b_->of(b);
    const Interval<double> near = boxes_.boxes().quickly_between(one, other, queried);
    return near.begin <= near.end ? cut(one, other, near) : near;
  }
  bool is_larger(Node a, Node b) const {
    return a_ ? a_->of(a).size >= b_->of(b).size : boxes_.is_larger(a, b);
  }

 private:
  using Triple = std::array<double, 3>;

  Interval<double> cut(const BoundingDisc& a, const BoundingDisc& b, Interval<double> near) const;

  const BoxTests<3, SpacePieces> boxes_;
  const BoundingDiscs *a_ = nullptr, *b_ = nullptr;  ///< null unless both objects have discs
  Triple place_, speed_, swing_;                     ///< as in triangle_filter.cpp
  double radius_, end_, slack_;
};

}  // namespace foresee
