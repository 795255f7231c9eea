// Which of many boxes meet a box, or those of another tree? A binary tree of boxes along the axes, balanced,
// in two flat arrays.
//
//   const std::vector<std::uint32_t> order = tree_order<2>(boxes);      // what is near lies near
//   BoxTree<2> tree(boxes_in_that_order);
//   if (tree.is_leaf(node)) test(tree.item(node)); else visit(tree.left(node)), visit(tree.right(node));
//
// The nodes are laid out as in a heap: the root is node 0, the children of node i are 2i + 1 and 2i + 2, and
// the last nodes, as many as there are boxes, are the leaves. So no node stores where another is, and the
// same order serves whatever boxes the items get later: the pieces of one outline, turned by each row's
// heading.
//
// Cost: order n log n, once an outline; a tree n, some nanoseconds a box. No leaf lies deeper than
// log2(n) + 1, so that a walk may be recursive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/box.h"

namespace foresee {

template <int D>
class BoxTree {
 public:
  using Node = std::uint32_t;
  static constexpr Node root = 0;

  BoxTree() = default;
  /// Of boxes in an order as tree_order() gives it. Requires: at least one, none empty.
  explicit BoxTree(std::span<const Box<D>> boxes);

  std::size_t memory() const { return nodes_.size() * sizeof(Box<D>); }
  std::size_t items() const { return (nodes_.size() + 1) / 2; }
  const Box<D>& box(Node node) const { return nodes_[node]; }
  bool is_leaf(Node node) const { return node >= first_leaf(); }
  Node left(Node node) const { return 2 * node + 1; }
  Node right(Node node) const { return 2 * node + 2; }
  /// Which box a leaf is, and the leaf of a box.
  std::size_t item(Node leaf) const { return leaf - first_leaf(); }
  Node leaf(std::size_t item) const { return static_cast<Node>(item + first_leaf()); }

 private:
  Node first_leaf() const { return first_leaf_; }

  std::vector<Box<D>> nodes_;
  Node first_leaf_ = 0;
};

/// Which box is to be the first item of a tree, which the second, and so on: each node's boxes are halved
/// along the axis on which their middles lie farthest apart.
template <int D>
std::vector<std::uint32_t> tree_order(std::span<const Box<D>> boxes);

}  // namespace foresee
