// When could the triangles below two nodes touch, as the boxes and the plates around them tell
// (shape/mesh/bounding_discs.h)? What TreeWalk asks about meshes.
//
//   const DiscTests tests(a, b, chord, relative, sizes, end);
//   const Interval<double> near = tests.near(node_a, node_b, {0, end});             // empty: never
//
// Across each of the two normals d lies within as much as both plates reach that way while they touch. Along
// the normal of the other a plate reaches as far as its thickness and its disc do. The slack is that of
// space_tests.h, and far less than what the plates have of their own. Where one has no plates boxes alone
// are asked. Cost: some ten nanoseconds, and a cache line a node.
#pragma once

#include "contact/mesh/space_condition.h"
#include "contact/pieces/tree_walk.h"

namespace foresee {

class DiscTests {
 public:
  using Node = SpacePieces::Node;

  /// What is given must outlive this, but the motion and the sizes.
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
  const BoundingDiscs *a_ = nullptr, *b_ = nullptr;  ///< if both have some
  Triple place_, speed_, swing_;                     ///< as space_tests.cpp has them
  double radius_, end_, slack_;
};

}  // namespace foresee
