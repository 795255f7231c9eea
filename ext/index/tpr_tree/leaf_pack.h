// Repacking of leaves: the objects of some leaves are distributed over a given number of leaves, in the order
// of a bulk load.
//
//   LeafPack<2> pack(state);
//   pack.add(7, *leaf7), pack.add(9, *leaf9);
//   pack.arrange(3);                          // into three leaves; nothing is written yet
//   pack.summaries(epoch)                     // the parent's entries for them
//   pack.write_beneath(parent, above, entries);
//
// A new leaf takes the number of the old leaf that most of its objects come from. So objects that keep their
// leaf cost no change of the page map.
#pragma once

#include <vector>

#include "index/tpr_tree/tree_state.h"

namespace foresee {

template <int D>
class LeafPack {
 public:
  explicit LeafPack(TreeState<D>& state) : state_(state) {}

  void add(NodeNumber number, const Node& leaf);
  std::size_t objects() const { return ids_.size(); }

  /// Distributes the objects evenly over the leaves. Requires: objects.
  void arrange(std::size_t leaves);
  std::vector<Entry<D>> summaries(double epoch) const;
  /// The number of objects whose leaf would change.
  std::size_t arriving() const;

  /// Replaces the old leaves of `parent` by the new ones, with these entries. `above` is the parent's node,
  /// which changes.
  void write_beneath(NodeNumber parent, Node& above, const std::vector<Entry<D>>& entries);

 private:
  /// An old or a new leaf.
  struct Leaf {
    Node node;
    NodeNumber number = 0;  ///< 0: a new number
    std::vector<std::int64_t> arriving;
  };
  void take_number(Leaf& leaf, std::span<const std::uint32_t> objects);
  /// Writes new leaf i, once; returns its number.
  NodeNumber write(std::size_t i, NodeNumber parent);

  TreeState<D>& state_;
  std::vector<NodeNumber> old_;      ///< the numbers of the old leaves
  std::vector<NodeNumber> numbers_;  ///< the same; 0 once a new leaf has taken the number
  std::vector<std::int64_t> ids_;
  std::vector<double> records_;
  std::vector<std::uint32_t> from_;  ///< the index of the old leaf of each object
  std::vector<Leaf> leaves_;
};

}  // namespace foresee
