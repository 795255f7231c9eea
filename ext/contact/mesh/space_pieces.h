// Convex pieces of one object in space, under a tree of boxes: the triangles of its mesh, or one box.
//
//   SpacePieces pieces;
//   pieces.take(*meshes.pieces(row, pieces.own()));  // or take_box(box), take_point()
//   if (pieces.is_leaf(node)) test(pieces.piece(pieces.item(node)));
//
// The box is made of the row's half extents; a point is a box of size 0.
#pragma once

#include <array>

#include "shape/form_rows.h"
#include "shape/mesh/triangle_tree.h"

namespace foresee {

/// The vector from one corner to another, not 0.
struct EdgeVector {
  const SpaceCorner *from, *to;
};

/// A triangle, or a box along the axes.
class SpacePiece {
 public:
  SpacePiece(const TriangleTree& triangles, std::size_t triangle);
  /// `corners`: all eight; corner i has the upper coordinate on each axis whose bit in i is set.
  explicit SpacePiece(const SpaceCorner* corners);

  bool is_box() const { return !triangles_; }
  int corner_count() const { return is_box() ? 8 : 3; }
  int edge_count() const { return is_box() ? 12 : 3; }
  const SpaceCorner& corner(int i) const { return is_box() ? box_[i] : triangles_->corner(triangle_, i); }
  /// The numbers of the corners at both ends of an edge.
  std::array<int, 2> edge(int i) const;
  /// The direction of edge i, also in a box without width.
  const EdgeVector& vector_of_edge(int i) const { return edge_vectors_[is_box() ? i / 4 : i]; }
  /// All directions of edges.
  const std::array<EdgeVector, 3>& edge_vectors() const { return edge_vectors_; }
  /// A corner or edge that several triangles share belongs to one of them. Of those that coincide in a box
  /// without width, one belongs to it.
  bool owns_corner(int i) const {
    return is_box() ? (i & flat_) == 0 : triangles_->owns_corner(triangle_, i);
  }
  bool owns_edge(int i) const {
    return is_box() ? ((edge(i)[0] | 1 << i / 4) & flat_) == 0 : triangles_->owns_edge(triangle_, i);
  }
  /// For a box, a bit for each axis along which it has no width.
  int flat() const { return flat_; }
  bool is_point() const { return flat_ == 7; }

 private:
  const TriangleTree* triangles_ = nullptr;
  std::size_t triangle_ = 0;
  const SpaceCorner* box_ = nullptr;
  int flat_ = 0;
  std::array<EdgeVector, 3> edge_vectors_;
};

/// Holds one object at a time, which must outlive its use here.
class SpacePieces {
 public:
  static constexpr int axes = 3;
  using Node = BoxTree<3>::Node;
  static constexpr Node root = BoxTree<3>::root;

  void take(const TriangleTree& triangles) { triangles_ = &triangles; }
  /// Memory for triangles that are made for one use.
  ScratchPieces<TriangleTree>& own() { return own_; }
  void take_box(const Box<3>& box);
  void take_point() { take_box({Vec<3>::Zero(), Vec<3>::Zero()}); }

  std::size_t count() const { return triangles_ ? triangles_->count() : 1; }
  /// About as many: a triangle takes as long as a box.
  static std::size_t corner_count(std::size_t) { return 4; }
  SpacePiece piece(std::size_t i) const {
    return triangles_ ? SpacePiece(*triangles_, i) : SpacePiece(corners_.data());
  }
  const Box<3>& box(Node node) const { return triangles_ ? triangles_->tree().box(node) : box_; }
  bool is_leaf(Node node) const { return !triangles_ || triangles_->tree().is_leaf(node); }
  std::size_t item(Node leaf) const { return triangles_ ? triangles_->tree().item(leaf) : 0; }
  static Node left(Node node) { return 2 * node + 1; }
  static Node right(Node node) { return 2 * node + 2; }

  /// Null if the object is a box.
  const TriangleTree* triangles() const { return triangles_; }
  bool is_mesh() const { return triangles_ != nullptr; }
  /// The triangles if they enclose a solid, whose inside has no pieces; else null.
  const TriangleTree* solid() const { return triangles_ && triangles_->is_solid() ? triangles_ : nullptr; }
  /// Connected components of the surface, each represented by one corner.
  std::size_t parts() const { return triangles_ ? triangles_->parts() : 1; }
  const SpaceCorner& part_corner(std::size_t part) const {
    return triangles_ ? triangles_->part_corner(part) : corners_[0];
  }

 private:
  const TriangleTree* triangles_ = nullptr;  ///< null: the box
  std::array<SpaceCorner, 8> corners_;
  Box<3> box_;
  ScratchPieces<TriangleTree> own_;
};

}  // namespace foresee
