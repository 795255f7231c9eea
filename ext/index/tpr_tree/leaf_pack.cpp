#include "index/tpr_tree/leaf_pack.h"

#include "index/tpr_tree/bulk_load/leaf_order.h"

namespace foresee {

template <int D>
void LeafPack<D>::add(NodeNumber number, const Node& leaf) {
  if (!leaf.is_leaf()) throw BrokenTree("an inner node of the tree is where a leaf should be");
  if (std::find(old_.begin(), old_.end(), number) != old_.end())
    throw BrokenTree("a node of a tree has a child twice");
  ids_.insert(ids_.end(), leaf.keys.begin(), leaf.keys.end());
  records_.insert(records_.end(), leaf.values.begin(), leaf.values.end());
  from_.resize(ids_.size(), static_cast<std::uint32_t>(numbers_.size()));
  old_.push_back(number);
  numbers_.push_back(number);
}

template <int D>
void LeafPack<D>::arrange(std::size_t leaves) {
  NeverInterrupt never;
  const auto order = leaf_order(state_, records_, {leaves, 1}, {0, leaves}, never);
  const std::size_t size = state_.reader.record_size();
  leaves_.resize(leaves);
  for (std::size_t i = 0; i < leaves; ++i) {
    const auto objects = part_of(order, i, leaves);
    leaves_[i].node = objects_at(objects, ids_, records_, size);
    take_number(leaves_[i], objects);
  }
}

template <int D>
void LeafPack<D>::take_number(Leaf& leaf, std::span<const std::uint32_t> objects) {
  std::vector<std::size_t> shares(numbers_.size());
  for (const std::uint32_t object : objects)
    if (numbers_[from_[object]] != 0) ++shares[from_[object]];
  const auto best = static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
  if (shares[best] > 0) leaf.number = std::exchange(numbers_[best], 0);
  for (const std::uint32_t object : objects)
    if (leaf.number == 0 || from_[object] != best) leaf.arriving.push_back(ids_[object]);
}

template <int D>
std::vector<Entry<D>> LeafPack<D>::summaries(double epoch) const {
  std::vector<Entry<D>> all;
  for (const Leaf& leaf : leaves_) all.push_back(summary(leaf.node, state_.reader, epoch));
  return all;
}

template <int D>
std::size_t LeafPack<D>::arriving() const {
  std::size_t sum = 0;
  for (const Leaf& leaf : leaves_) sum += leaf.arriving.size();
  return sum;
}

template <int D>
void LeafPack<D>::write_beneath(NodeNumber parent, Node& above, const std::vector<Entry<D>>& entries) {
  for (const NodeNumber old : old_) remove_slot(above, slot_of(above, old), state_.stride(1));
  for (std::size_t i = 0; i < entries.size(); ++i) add_entry(above, write(i, parent), entries[i]);
  for (const NodeNumber number : numbers_)
    if (number != 0) state_.pages.free(number);
}

template <int D>
NodeNumber LeafPack<D>::write(std::size_t i, NodeNumber parent) {
  Leaf& leaf = leaves_[i];
  if (leaf.number == 0) leaf.number = state_.pages.allocate();
  state_.pages.place(leaf.arriving, leaf.number);
  leaf.node.parent = parent;
  state_.pages.modify(leaf.number) = std::move(leaf.node);
  return leaf.number;
}

template class LeafPack<1>;
template class LeafPack<2>;
template class LeafPack<3>;

}  // namespace foresee
