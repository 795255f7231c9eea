// Balanced binary tree of axis-aligned boxes (BVH) in flat arrays, for intersection tests of boxes and trees.
//
//   const std::vector<std::uint32_t> order = tree_order<2>(boxes);      // what is near lies near
//   BoxTree<2> tree(boxes_in_that_order);
//   if (tree.is_leaf(node)) test(tree.item(node)); else visit(tree.left(node)), visit(tree.right(node));
//
// Nodes are laid out as in a heap: the root is node 0, the children of node i are 2i + 1 and 2i + 2. The last
// nodes are the leaves, one per box. No node stores a pointer, and one order serves whatever boxes the items
// get later: the pieces of an outline, rotated by each row's heading.
//
// Cost: order n log n, once per outline; a tree n, some nanoseconds per box. No leaf is deeper than log2(n) +
// 1, so that a traversal may be recursive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/axis_aligned_box.h"

namespace foresee {

template <int D>
class BoxTree {
 public:
  using Node = std::uint32_t;
  static constexpr Node root = 0;

  BoxTree() = default;
  /// `boxes`: in an order from tree_order(). Requires: at least one, none of them empty.
  explicit BoxTree(std::span<const Box<D>> boxes);

  std::size_t memory() const { return nodes_.size() * sizeof(Box<D>); }
  std::size_t items() const { return (nodes_.size() + 1) / 2; }
  const Box<D>& box(Node node) const { return nodes_[node]; }
  bool is_leaf(Node node) const { return node >= first_leaf(); }
  Node left(Node node) const { return 2 * node + 1; }
  Node right(Node node) const { return 2 * node + 2; }
  /// The index of a leaf's box, and the leaf of a box.
  std::size_t item(Node leaf) const { return leaf - first_leaf(); }
  Node leaf(std::size_t item) const { return static_cast<Node>(item + first_leaf()); }

 private:
  Node first_leaf() const { return first_leaf_; }

  std::vector<Box<D>> nodes_;
  Node first_leaf_ = 0;
};

/// The order of boxes for a tree: the index of the first item, of the second, and so on. The boxes of each
/// node are halved along the axis on which their midpoints are spread widest.
template <int D>
std::vector<std::uint32_t> tree_order(std::span<const Box<D>> boxes);

}  // namespace foresee
