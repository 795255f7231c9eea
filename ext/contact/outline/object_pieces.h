// Convex pieces of one object in the plane, under a tree of boxes: those of its outline, or one box.
//
//   ObjectPieces pieces;
//   pieces.take_row(ships, ships.outlines, 7);        // or take(pieces), take_box(8, 90), take_point()
//   if (pieces.is_leaf(node)) test(pieces.piece(pieces.item(node)));
//
// The box is made of the row's half extents; a point is a box of size 0.
#pragma once

#include <array>

#include "contact/outline/convex_sum.h"
#include "shape/bodies.h"
#include "shape/form_rows.h"
#include "shape/outline/convex_pieces.h"

namespace foresee {

/// Holds one object at a time, which must outlive its use here.
class ObjectPieces {
 public:
  static constexpr int axes = 2;
  using Node = BoxTree<2>::Node;
  static constexpr Node root = BoxTree<2>::root;

  /// Takes the shape of row i. `outlines` may be null: then a row with an outline counts as the smallest
  /// rectangle around it.
  void take_row(const Bodies& bodies, const OutlineRows* outlines, std::size_t i);
  void take(const ConvexPieces& pieces) { pieces_ = &pieces; }
  void take_box(const Box<2>& box);
  void take_box(double hx, double hy) { take_box({Vec<2>(-hx, -hy), Vec<2>(hx, hy)}); }
  void take_point() {
    take_box(0, 0);
    is_point_ = true;
  }

  std::size_t count() const { return pieces_ ? pieces_->count() : 1; }
  ConvexPiece piece(std::size_t i) const;
  std::size_t corner_count(std::size_t i) const { return pieces_ ? pieces_->corners(i).size() : 4; }
  const Box<2>& box(Node node) const { return pieces_ ? pieces_->tree().box(node) : box_; }
  bool is_leaf(Node node) const { return !pieces_ || pieces_->tree().is_leaf(node); }
  std::size_t item(Node leaf) const { return pieces_ ? pieces_->tree().item(leaf) : 0; }
  static Node left(Node node) { return 2 * node + 1; }
  static Node right(Node node) { return 2 * node + 2; }
  bool is_point() const { return !pieces_ && is_point_; }

 private:
  const ConvexPieces* pieces_ = nullptr;  ///< null: the box
  std::array<Corner, 4> corners_;
  Box<2> box_;
  bool is_point_ = false;
  ScratchPieces<ConvexPieces> own_;
};

}  // namespace foresee
