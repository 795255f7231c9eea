// How flat is what lies below a node of a tree of triangles? Round plates around them: surfaces are thin
// where they do not lie along the axes, too, as boxes do not tell.
//
//   const BoundingDiscs discs(tree, triangles, corners);            // once a mesh
//   const BoundingDiscs rotated(discs, corners, tree_of_turned, turned_corners);        // about the z axis
//   if (discs.are_there()) discs.of(node).half              // half as thick as the plate
//
// All corners below a node lie at most `half` from the plane through `middle` that `normal` is square to, and
// at most `radius` from the line along it, whatever roundings took: the normal is as long as 1 up to 2^-22.
// There are none of meshes so large or so small that floats do not hold them. Cost: some hundred nanoseconds
// a triangle; turned, some ten.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"
#include "shape/outline/box_tree.h"

namespace foresee {

/// A cache line.
struct alignas(64) BoundingDisc {
  std::array<float, 3> lower, upper;  ///< the box around it, rounded outward
  std::array<float, 3> middle, normal;
  float half, radius;
  float size;  ///< of the box, roughly: the sum of its sides
};

class BoundingDiscs {
 public:
  BoundingDiscs() = default;
  /// `triangles`: item i of the tree is triangle i.
  BoundingDiscs(const BoxTree<3>& tree, std::span<const Triangle> triangles,
                std::span<const SpaceCorner> corners);
  /// Of the tree of a mesh turned. Requires: its corners are those of `known`, turned, each rounded once.
  BoundingDiscs(const BoundingDiscs& known, std::span<const SpaceCorner> corners, const BoxTree<3>& tree,
                std::span<const SpaceCorner> turned);

  bool are_there() const { return !discs_.empty(); }
  const BoundingDisc& of(BoxTree<3>::Node node) const { return discs_[node]; }
  std::size_t memory() const { return discs_.size() * sizeof(BoundingDisc); }

 private:
  void take_boxes(const BoxTree<3>& tree);

  std::vector<BoundingDisc> discs_;
  double slack_ = 0;  ///< more than roundings to floats can take from a length
};

}  // namespace foresee
