// Bounding discs of the nodes of a triangle tree: thin round slabs around surfaces, oriented along their
// normal.
//
// Boxes along the axes are thick around a surface that is not parallel to an axis; discs are thin there too.
//
//   const BoundingDiscs discs(tree, triangles, corners);            // once per mesh
//   const BoundingDiscs rotated(discs, corners, tree_of_turned, turned_corners);        // about the z axis
//   if (discs.are_there()) discs.of(node).half              // half the thickness of the disc
//
// Every corner below a node is at most `half` from the plane through `middle` perpendicular to `normal`. It
// is at most `radius` from the line along `normal`. Both bounds include rounding; the length of the normal is
// 1 up to 2^-22. A mesh that is too large or too small for floats has no discs. Cost: some hundred
// nanoseconds per triangle; some ten after a rotation.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"
#include "shape/outline/box_tree.h"

namespace foresee {

/// A cache line.
struct alignas(64) BoundingDisc {
  std::array<float, 3> lower, upper;  ///< the bounding box, rounded outward
  std::array<float, 3> middle, normal;
  float half, radius;
  float size;  ///< of the box, approximately: the sum of its sides
};

class BoundingDiscs {
 public:
  BoundingDiscs() = default;
  /// Requires: item i of the tree is triangle i.
  BoundingDiscs(const BoxTree<3>& tree, std::span<const Triangle> triangles,
                std::span<const SpaceCorner> corners);
  /// The discs of a rotated mesh. Requires: its corners are those of `known`, rotated, each rounded once.
  BoundingDiscs(const BoundingDiscs& known, std::span<const SpaceCorner> corners, const BoxTree<3>& tree,
                std::span<const SpaceCorner> turned);

  bool are_there() const { return !discs_.empty(); }
  const BoundingDisc& of(BoxTree<3>::Node node) const { return discs_[node]; }
  std::size_t memory() const { return discs_.size() * sizeof(BoundingDisc); }

 private:
  void take_boxes(const BoxTree<3>& tree);

  std::vector<BoundingDisc> discs_;
  double slack_ = 0;  ///< upper bound of what rounding to floats takes from a length
};

}  // namespace foresee
