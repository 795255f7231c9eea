#include "index/tpr_tree/update/rebalance.h"

#include "index/tpr_tree/leaf_pack.h"
#include "index/tpr_tree/update/choose_child.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/removal.h"

namespace foresee {
namespace {

constexpr std::size_t siblings = 3;  ///< the number of siblings that are checked for free slots

std::size_t key_count(Pages& pages, NodeNumber number) {
  return pages.read(number)->size();
}

/// Of the siblings that a leaf overlaps most, the first with free slots for the leaf's surplus, otherwise the
/// first. The leaf itself if it has no sibling.
template <int D>
NodeNumber sibling_with_room(const TreeState<D>& state, const Node& parent, NodeNumber leaf) {
  const std::size_t size = key_count(state.pages, leaf);
  const std::vector<std::size_t> closest = closest_children(state, parent, leaf, 1 + siblings);
  if (closest.size() == 1) return leaf;
  for (std::size_t i = 1; i < closest.size(); ++i)
    if (size + key_count(state.pages, parent.keys[closest[i]]) <= 2 * state.packed_size())
      return parent.keys[closest[i]];
  return parent.keys[closest[1]];
}

/// The leaf with which a leaf shares its objects; itself if it has no sibling; 0 if no change is necessary.
template <int D>
NodeNumber partner_of(const TreeState<D>& state, const Node& parent, NodeNumber leaf) {
  const NodeNumber sibling = sibling_with_room(state, parent, leaf);
  const std::size_t size = key_count(state.pages, leaf), limit = state.capacity(0);
  const bool is_due = size > limit || size < state.min_size(0);
  const bool is_unchanged = sibling == leaf
                                ? size <= limit
                                : !is_due && size + key_count(state.pages, sibling) > state.packed_size();
  return is_unchanged ? 0 : sibling;
}

template <int D>
class EvenOut {
 public:
  EvenOut(TreeState<D>& state, NodeNumber number)
      : state_(state), number_(number), parent_(state.pages.modify(number)) {}

  void share(NodeNumber leaf, NodeNumber partner) {
    const NodeNumber both[] = {leaf, partner};
    pack(std::span(both).first(partner == leaf ? 1 : 2));
  }

  void run(std::span<const NodeNumber> children) {
    const bool is_new_epoch =
        2 * children.size() > parent_.size() && parent_.epoch != state_.epoch_for(parent_);
    if (is_new_epoch) start_epoch(children);
    std::vector<NodeNumber> uneven, sparse;
    for (const NodeNumber child : children) {
      const auto node = state_.pages.read(child);
      if (node->size() == 0) {
        let_go(child);
        continue;
      }
      renew(child, *node);
      if (is_even(*node)) continue;
      uneven.push_back(child);
      if (node->size() < state_.capacity(node->level)) sparse.push_back(child);
    }
    // With one sibling each would be sparse again.
    if (parent_.level == 1 && sparse.size() > 2 && 2 * sparse.size() >= parent_.size()) pack(sparse);
    for (const NodeNumber child : uneven)
      if (has(child)) parent_.level > 1 ? even_out_inner(child) : even_out_leaf(child);
    if (parent_.size() == 0 || is_new_epoch) return;
    for (const NodeNumber child : children)
      if (has(child) && renew_if_stale(state_, number_, slot_of(parent_, child))) break;
  }

 private:
  bool is_even(const Node& node) const {
    return node.size() <= state_.capacity(node.level) &&
           node.size() >= (node.is_leaf() ? state_.capacity(0) / 2 : state_.min_size(node.level));
  }

  /// Renews the entries of all children but these at a new epoch.
  void start_epoch(std::span<const NodeNumber> but) {
    std::vector<NodeNumber> sorted(but.begin(), but.end());
    std::sort(sorted.begin(), sorted.end());
    const double epoch = state_.epoch_for(parent_);
    for (std::size_t slot = 0; slot < parent_.size(); ++slot) {
      if (std::binary_search(sorted.begin(), sorted.end(), parent_.keys[slot])) continue;
      Entry<D> entry = summary(*read_below(state_.pages, number_, parent_, slot), state_.reader, epoch);
      entry.bounds.narrow_to(carried(bounds_at<D>(parent_, slot), parent_.epoch, epoch));
      set_entry(parent_, slot, entry);
    }
    parent_.epoch = epoch;
  }

  bool has(NodeNumber child) const { return has_child(parent_, child); }
  void renew(NodeNumber child, const Node& node) {
    set_entry(parent_, slot_of(parent_, child), summary(node, state_.reader, parent_.epoch));
  }
  void let_go(NodeNumber child) {
    remove_slot(parent_, slot_of(parent_, child), state_.stride(parent_.level));
    state_.pages.free(child);
  }

  /// Repacks these leaves into as few as hold their objects.
  void pack(std::span<const NodeNumber> old) {
    LeafPack<D> pack(state_);
    for (const NodeNumber leaf : old)
      pack.add(leaf, *read_below(state_.pages, number_, parent_, slot_of(parent_, leaf)));
    pack.arrange(state_.leaves_for(pack.objects()));
    pack.write_beneath(number_, parent_, pack.summaries(parent_.epoch));
  }

  void even_out_leaf(NodeNumber leaf) {
    if (const NodeNumber partner = partner_of(state_, parent_, leaf)) share(leaf, partner);
  }

  void even_out_inner(NodeNumber child) {
    while (key_count(state_.pages, child) < state_.min_size(parent_.level - 1)) {
      const NodeNumber sibling = parent_.keys[closest_sibling(state_, parent_, child)];
      if (sibling == child) return;
      take_up(child, sibling);
      child = sibling;
    }
    std::vector<NodeNumber> full{child};
    while (!full.empty()) {
      const NodeNumber node = full.back();
      full.pop_back();
      if (key_count(state_.pages, node) <= state_.capacity(parent_.level - 1)) continue;
      full.push_back(node);
      full.push_back(split_node(state_, node, number_));
    }
  }

  /// Moves all children of `child` to its sibling.
  void take_up(NodeNumber child, NodeNumber sibling) {
    const Node gone = *state_.pages.read(child);
    Node& taker = state_.pages.modify(sibling);
    expect_below(taker, number_, gone.level);
    std::vector<NodeNumber> children = gone.keys;
    if (taker.size() == 1) children.push_back(taker.keys[0]);
    for (std::size_t slot = 0; slot < gone.size(); ++slot) {
      expect_no_child(taker, gone.keys[slot]);
      Entry<D> entry = entry_at<D>(gone, slot);
      entry.bounds = carried(entry.bounds, gone.epoch, taker.epoch);
      add_entry(taker, gone.keys[slot], entry);
      add_children(state_, unread_child(child, gone, slot), sibling);
    }
    let_go(child);
    EvenOut(state_, sibling).run(children);  // those that had no sibling have siblings now
    renew(sibling, taker);
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
bool even_out_leaf(TreeState<D>& state, NodeNumber parent, NodeNumber leaf) {
  const NodeNumber partner = partner_of(state, *state.pages.read(parent), leaf);
  if (partner != 0) EvenOut<D>(state, parent).share(leaf, partner);
  return partner != 0;
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

#define FORESEE_OF_AXES(D)                                                           \
  template void even_out<D>(TreeState<D>&, NodeNumber, std::span<const NodeNumber>); \
  template bool even_out_leaf<D>(TreeState<D>&, NodeNumber, NodeNumber);             \
  template void even_out_root<D>(TreeState<D>&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
