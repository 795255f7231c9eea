// How are the objects of some leaves packed into other leaves? As a bulk load would, in as many as wanted.
//
//   LeafPack<2> pack(state);
//   pack.add(7, *leaf7), pack.add(9, *leaf9);
//   pack.arrange(3);                          // into three leaves; nothing is written yet
//   pack.summaries(epoch)                     // what the parent would say of each
//   pack.write_beneath(parent, above, entries);
//
// A new leaf takes the number of the old one that most of its objects come from: what stays where it was
// costs the page map nothing.
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

  /// Objects are shared out evenly among the leaves. Requires: objects.
  void arrange(std::size_t leaves);
  std::vector<Entry<D>> summaries(double epoch) const;
  /// How many objects would come into another leaf.
  std::size_t arriving() const;

  /// The old leaves leave their parent and the new ones come, with these entries. `above`: the parent, which
  /// changes.
  void write_beneath(NodeNumber parent, Node& above, const std::vector<Entry<D>>& entries);

 private:
  /// A leaf of before, or one to come.
  struct Leaf {
    Node node;
    NodeNumber number = 0;  ///< 0: a new one
    std::vector<std::int64_t> arriving;
  };
  void take_number(Leaf& leaf, std::span<const std::uint32_t> objects);
  /// Writes new leaf i, once; the number that it has.
  NodeNumber write(std::size_t i, NodeNumber parent);

  TreeState<D>& state_;
  std::vector<NodeNumber> old_, numbers_;  ///< of the old leaves; then 0 where one is taken
  std::vector<std::int64_t> ids_;
  std::vector<double> records_;
  std::vector<std::uint32_t> from_;  ///< which old leaf each object comes from
  std::vector<Leaf> leaves_;
};

}  // namespace foresee
