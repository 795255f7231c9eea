// Triangles of a rotated mesh in a bounding-volume hierarchy (BVH), between which contact is decided, and the
// bounding discs of its nodes.
//
//   const TriangleTree building(mesh);                        // once per mesh
//   const TriangleTree rotated(building, turned_mesh);     // the same triangles, other corners
//   building.tree(), building.corner(t, 0), building.owns_edge(t, 1), building.parts()
//
// Triangles are stored, and numbered, in the order of a tree of boxes. A corner or edge that several
// triangles share is owned by one of them, so that a loop over all triangles reads each once. A part is a
// connected component of corners; one of its corners decides whether all of it lies within another solid, if
// its surface does not touch that solid. Cost: n log n, about a microsecond per triangle; a twentieth after a
// rotation.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"
#include "shape/outline/box_tree.h"

namespace foresee {

// Bounding discs of the nodes of a tree of triangles: thin round slabs around surfaces, oriented along their normal.
// Boxes along the axes are thick around a surface that is not parallel to an axis; discs are thin there too.
//
//   const BoundingDiscs discs(tree, triangles, corners);            // once per mesh
//   const BoundingDiscs rotated_discs(discs, corners, tree_of_turned, turned_corners);   // about the z axis
//   if (discs.are_there()) discs.of(node).half              // half the thickness of the disc
//
// Every corner below a node is at most `half` from the plane through `middle` perpendicular to `normal`. It
// is at most `radius` from the line along `normal`. Both bounds include rounding; the length of the normal is
// 1 up to 2^-22. A mesh that is too large or too small for floats has no discs. Cost: some hundred
// nanoseconds per triangle; some ten after a rotation.

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

class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(const Mesh& mesh);
  /// Requires: `turned` is the mesh of `known`, rotated.
  TriangleTree(const TriangleTree& known, const Mesh& turned);

  std::size_t count() const { return links_ ? links_->triangles.size() : 0; }
  bool is_solid() const { return solid_; }
  /// Item t of the tree is triangle t.
  const BoxTree<3>& tree() const { return tree_; }
  /// The bounding discs of the nodes of the tree.
  const BoundingDiscs& discs() const { return discs_; }
  const SpaceCorner& corner(std::size_t t, int i) const {
    return corners_[links_->triangles[t][static_cast<std::size_t>(i)]];
  }
  bool owns_corner(std::size_t t, int i) const { return (links_->owned[t] >> i & 1) != 0; }
  /// Whether triangle t owns its edge i, from corner i to the next.
  bool owns_edge(std::size_t t, int i) const { return (links_->owned[t] >> (3 + i) & 1) != 0; }
  /// The number of parts, and a corner of each.
  std::size_t parts() const { return links_ ? links_->part_corners.size() : 0; }
  const SpaceCorner& part_corner(std::size_t part) const { return corners_[links_->part_corners[part]]; }
  /// In bytes, without what all headings share.
  std::size_t memory() const {
    return sizeof *this + corners_.size() * sizeof(SpaceCorner) + tree_.memory() + discs_.memory();
  }

 private:
  /// What all headings of a mesh share.
  struct Links {
    std::vector<Triangle> triangles;
    std::vector<std::uint8_t> owned;  ///< a bit for each corner, then for each edge
    std::vector<std::uint32_t> part_corners;
  };

  std::shared_ptr<const Links> links_;
  std::vector<SpaceCorner> corners_;
  BoxTree<3> tree_;
  BoundingDiscs discs_;
  bool solid_ = false;
};

}  // namespace foresee
