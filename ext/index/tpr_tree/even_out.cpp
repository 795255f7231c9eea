#include "index/tpr_tree/even_out.h"

#include "index/tpr_tree/choose.h"
#include "index/tpr_tree/grow.h"
#include "index/tpr_tree/leaf_pack.h"
#include "index/tpr_tree/shrink.h"

namespace foresee::index {
namespace {

template <int D>
class EvenOut {
 public:
  EvenOut(TreeState<D>& state, NodeNumber number)
      : state_(state), number_(number), parent_(state.pages.modify(number)) {}

  void run(std::span<const NodeNumber> children) {
    std::vector<NodeNumber> uneven;
    for (const NodeNumber child : children) {
      const auto node = state_.pages.read(child);
      if (node->size() == 0) {
        let_go(child);
        continue;
      }
      renew(child, *node);
      if (node->size() > state_.capacity(node->level) || node->size() < state_.least_size(node->level))
        uneven.push_back(child);
    }
    for (const NodeNumber child : uneven)
      if (has(child)) parent_.level > 1 ? even_out_inner(child) : even_out_leaf(child);
    if (parent_.size() == 0) return;
    if (2 * children.size() > parent_.size() && parent_.epoch != state_.clock.now())
      renew_entries(state_, number_);
    else
      for (const NodeNumber child : children)
        if (has(child) && freshen(state_, number_, slot_of(parent_, child))) break;
  }

 private:
  bool has(NodeNumber child) const {
    return std::find(parent_.keys.begin(), parent_.keys.end(), child) != parent_.keys.end();
  }
  std::size_t size_of(NodeNumber child) const { return state_.pages.read(child)->size(); }
  void renew(NodeNumber child, const Node& node) {
    set_entry(parent_, slot_of(parent_, child), summary(node, state_.reader, parent_.epoch));
  }
  void let_go(NodeNumber child) {
    remove_slot(parent_, slot_of(parent_, child), state_.stride(parent_.level));
    state_.pages.free(child);
  }

  /// Packs these leaves anew, in as few as hold their objects.
  void pack(std::span<const NodeNumber> old) {
    LeafPack<D> pack(state_);
    for (const NodeNumber leaf : old) {
      pack.add(leaf, *read_below(state_.pages, number_, parent_, slot_of(parent_, leaf)));
      remove_slot(parent_, slot_of(parent_, leaf), state_.stride(1));
    }
    pack.arrange((pack.objects() + state_.capacity(0) - 1) / state_.capacity(0), 1);
    const std::vector<Entry<D>> entries = pack.summaries(parent_.epoch);
    for (std::size_t i = 0; i < entries.size(); ++i) add_entry(parent_, pack.write(i, number_), entries[i]);
    pack.free_rest();
  }

  void even_out_leaf(NodeNumber leaf) {
    const std::size_t size = size_of(leaf);
    if (size <= state_.capacity(0) && size >= state_.least_size(0)) return;
    const NodeNumber sibling = parent_.keys[closest_sibling(state_, parent_, leaf)];
    const NodeNumber both[] = {leaf, sibling};
    pack(std::span(both).first(sibling == leaf ? 1 : 2));
  }

  void even_out_inner(NodeNumber child) {
    if (size_of(child) < state_.least_size(parent_.level - 1)) {
      const NodeNumber sibling = parent_.keys[closest_sibling(state_, parent_, child)];
      if (sibling == child) return;
      take_up(child, sibling);
      child = sibling;
    }
    std::vector<NodeNumber> full{child};
    while (!full.empty()) {
      const NodeNumber node = full.back();
      full.pop_back();
      if (size_of(node) <= state_.capacity(parent_.level - 1)) continue;
      full.push_back(node);
      full.push_back(split_node(state_, node, number_));
    }
  }

  /// Hangs everything beneath `child` below its sibling.
  void take_up(NodeNumber child, NodeNumber sibling) {
    const Node gone = *state_.pages.read(child);
    Node& stays = state_.pages.modify(sibling);
    expect_below(stays, number_, gone.level);
    for (std::size_t slot = 0; slot < gone.size(); ++slot) {
      Entry<D> entry = entry_at<D>(gone, slot);
      entry.bounds = carried(entry.bounds, gone.epoch, stays.epoch);
      add_entry(stays, gone.keys[slot], entry);
      hang_below(state_, unread_child(child, gone, slot), sibling);
    }
    let_go(child);
    renew(sibling, stays);
  }

  TreeState<D>& state_;
  const NodeNumber number_;
  Node& parent_;
};

}  // namespace

template <int D>
void even_out(TreeState<D>& state, NodeNumber parent, std::span<const NodeNumber> children) {
  EvenOut<D>(state, parent).run(children);
}

template <int D>
void even_out_root(TreeState<D>& state) {
  for (;;) {
    const NodeNumber root = state.pages.find_root();
    const auto node = state.pages.read(root);
    if (node->size() <= state.capacity(node->level)) break;
    const NodeNumber child[] = {root};
    even_out(state, put_root_above(state, root), child);
  }
  lower_root(state);
}

template void even_out<1>(TreeState<1>&, NodeNumber, std::span<const NodeNumber>);
template void even_out<2>(TreeState<2>&, NodeNumber, std::span<const NodeNumber>);
template void even_out<3>(TreeState<3>&, NodeNumber, std::span<const NodeNumber>);
template void even_out_root<1>(TreeState<1>&);
template void even_out_root<2>(TreeState<2>&);
template void even_out_root<3>(TreeState<3>&);

}  // namespace foresee::index
