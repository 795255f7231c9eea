// Which triangles of a mesh, as it lies, are where? Contact is decided between these.
//
//   const TriangleTree building(mesh);                        // once a mesh
//   const TriangleTree rotated(building, turned_mesh);     // the same triangles, other corners
//   building.tree(), building.corner(t, 0), building.owns_edge(t, 1), building.parts()
//
// Triangles stand in the order of a tree of boxes, and are known by their places there. Corners and edges
// that several have in common belong to one of them, so that who looks at all triangles asks for each once. A
// part hangs together by its corners; one corner says for all of it whether it lies within another solid that
// its surface does not touch. Cost: n log n, about a microsecond a triangle; turned, a twentieth.
#pragma once

#include <memory>

#include "shape/mesh/bounding_discs.h"

namespace foresee {

class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(const Mesh& mesh);
  /// Requires: `turned` is the mesh of `known`, turned.
  TriangleTree(const TriangleTree& known, const Mesh& turned);

  std::size_t count() const { return links_ ? links_->triangles.size() : 0; }
  bool is_solid() const { return solid_; }
  /// Item t of the tree is triangle t.
  const BoxTree<3>& tree() const { return tree_; }
  /// Of the nodes of the tree.
  const BoundingDiscs& discs() const { return discs_; }
  const SpaceCorner& corner(std::size_t t, int i) const {
    return corners_[links_->triangles[t][static_cast<std::size_t>(i)]];
  }
  bool owns_corner(std::size_t t, int i) const { return (links_->owned[t] >> i & 1) != 0; }
  /// Edge i runs from corner i to the next.
  bool owns_edge(std::size_t t, int i) const { return (links_->owned[t] >> (3 + i) & 1) != 0; }
  /// A corner of each part.
  std::size_t parts() const { return links_ ? links_->part_corners.size() : 0; }
  const SpaceCorner& part_corner(std::size_t part) const { return corners_[links_->part_corners[part]]; }
  /// Bytes, without what all headings share.
  std::size_t memory() const {
    return sizeof *this + corners_.size() * sizeof(SpaceCorner) + tree_.memory() + discs_.memory();
  }

 private:
  /// The same for all headings of a mesh.
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
