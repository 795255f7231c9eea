#include "index/tpr_tree/update/insertion.h"

#include "index/tpr_tree/update/choose_child.h"
#include "index/tpr_tree/update/rebalance.h"

namespace foresee {
namespace {

/// The node of this level beneath `number` to which ChildChoice leads on every level. Throws BrokenTree if a
/// node is not beneath its parent.
template <int D, class Added>
NodeNumber choose_node(TreeState<D>& state, NodeNumber number, int level, const Added& added) {
  auto node = number == state.pages.find_root() ? read(state.pages, unread_root(state.pages))
                                                : state.pages.read(number);
  if (node->level < level || (node->level > 0 && node->size() == 0))
    throw BrokenTree("a tree's root has no place for what it should take in");
  while (node->level > level) {
    const Entry<D> entry = added.entry(node->epoch);
    const std::size_t slot = ChildChoice<D>(*node, state.cost(node->epoch)).choose(entry);
    const Unread child = unread_child(number, *node, slot);
    node = read(state.pages, child);
    number = child.number;
  }
  return number;
}

}  // namespace

template <int D>
NodeNumber put_root_above(TreeState<D>& state, NodeNumber old_root) {
  const NodeNumber number = state.pages.allocate();
  Node& root = state.pages.modify(number);
  Node& child = state.pages.modify(old_root);
  root.level = child.level + 1;
  root.epoch = state.epoch_for(child);
  add_entry(root, old_root, summary(child, state.reader, root.epoch));
  child.parent = number;
  state.pages.set_root(number);
  return number;
}

namespace {

/// True if the epoch is stale for this child: much of its width comes from the time since the epoch.
template <int D>
bool is_stale(const TreeState<D>& state, const Node& inner, std::size_t slot) {
  double epoch = state.clock.now(), drift = state.horizon;
  if (state.reader.ends()) {
    Lives beneath;
    include_times(inner, state.reader, beneath);
    epoch = state.epoch_for(beneath);
    if (!state.reference_times().is_clock(beneath.all))
      drift = std::min(drift, beneath.all.until_max - beneath.all.t_min);
  }
  const double away = std::abs(epoch - inner.epoch);
  if (!(away > 0.5 * drift)) return false;
  const Bounds<D> bounds = bounds_at<D>(inner, slot);
  const Vec<D> by_epoch =
      away * ((bounds.v_upper - bounds.v_lower) + (0.5 * away) * (bounds.a_upper - bounds.a_lower));
  return by_epoch.sum() > 0.5 * (bounds.x_upper - bounds.x_lower).sum();
}

/// True if the child's entry contains the addition beneath it and is not stale.
template <int D, class Added>
bool fits(const TreeState<D>& state, const Node& parent, NodeNumber child, const Added& added) {
  const std::size_t slot = slot_of(parent, child);
  return entry_at<D>(parent, slot).contains(added.entry(parent.epoch)) && !is_stale(state, parent, slot);
}

/// Widens the parent's entry so that it contains the addition beneath the child.
template <int D, class Added>
void widen(TreeState<D>& state, NodeNumber parent, NodeNumber child, const Added& added) {
  std::size_t slot;
  Entry<D> entry, wanted;
  {
    const auto node = state.pages.read(parent);
    slot = slot_of(*node, child);
    entry = entry_at<D>(*node, slot), wanted = added.entry(node->epoch);
  }
  if (!entry.contains(wanted)) {
    entry.include(wanted);
    set_entry(state.pages.modify(parent), slot, entry);
  }
  renew_if_stale(state, parent, slot);
}

template <int D>
std::vector<Entry<D>> entries_of(const Node& inner, double epoch) {
  std::vector<Entry<D>> all;
  all.reserve(inner.size());
  for (std::size_t slot = 0; slot < inner.size(); ++slot) all.push_back(entry_at<D>(inner, slot, epoch));
  return all;
}

/// Moves these slots of `node` (ascending) to the empty node `to`.
void move_slots(Node& node, std::span<const std::uint32_t> slots, Node& to, std::size_t stride) {
  for (const std::uint32_t slot : slots) {
    to.keys.push_back(node.keys[slot]);
    set_kinds(to, to.size() - 1, kinds_at(node, slot));
    const auto values = node.values.begin() + static_cast<std::ptrdiff_t>(slot * stride);
    to.values.insert(to.values.end(), values, values + static_cast<std::ptrdiff_t>(stride));
  }
  for (auto slot = slots.rbegin(); slot != slots.rend(); ++slot) remove_slot(node, *slot, stride);
}

}  // namespace

template <int D>
void add_children(TreeState<D>& state, const Unread& from, NodeNumber parent) {
  Node& node = state.pages.modify(from.number);
  expect_below(node, from.parent, from.level);
  node.parent = parent;
}

template <int D>
NodeNumber split_node(TreeState<D>& state, NodeNumber number, NodeNumber parent_number) {
  const NodeNumber sibling_number = state.pages.allocate();
  Node& node = state.pages.modify(number);
  Node& sibling = state.pages.modify(sibling_number);
  Node& parent = state.pages.modify(parent_number);
  sibling.level = node.level;
  sibling.parent = parent_number;
  sibling.epoch = node.epoch;
  const std::vector<Entry<D>> elements = entries_of<D>(node, parent.epoch);
  move_slots(node, choose_split<D>(elements, state.cost(parent.epoch)), sibling, state.stride(node.level));

  for (const NodeNumber child : sibling.keys)
    add_children(state, Unread{child, number, node.level - 1}, sibling_number);
  const std::size_t slot = slot_of(parent, number);
  const Bounds<D> before = bounds_at<D>(parent, slot);
  auto entry_for = [&](const Node& half) {
    Entry<D> entry = summary(half, state.reader, parent.epoch);
    entry.bounds.narrow_to(before);
    return entry;
  };
  set_entry(parent, slot, entry_for(node));
  add_entry(parent, sibling_number, entry_for(sibling));
  // A half of a schedule may never be written again: it gets the epoch of its own lives now.
  if (state.reader.ends())
    for (const NodeNumber half : {number, sibling_number}) renew_if_stale(state, half, 0);
  return sibling_number;
}

template <int D, class Added>
void fit_upward(TreeState<D>& state, NodeNumber number, const Added& added) {
  for (auto node = state.pages.read(number);;) {
    const bool overfull = node->size() > state.capacity(node->level), is_leaf = node->is_leaf();
    NodeNumber parent_number = node->parent;
    auto parent = read_above(state.pages, number, *node);
    if (!parent && !overfull) return;
    if (parent && !overfull && fits(state, *parent, number, added)) {
      node = std::move(parent), number = parent_number;
      continue;
    }
    // Released before they change.
    node.reset();
    parent.reset();
    if (parent_number == 0) parent_number = put_root_above(state, number);
    widen(state, parent_number, number, added);
    if (overfull && is_leaf) even_out_leaf(state, parent_number, number);
    if (overfull && !is_leaf) split_node(state, number, parent_number);
    node = state.pages.read(parent_number), number = parent_number;
  }
}

template <int D>
void renew_entries(TreeState<D>& state, NodeNumber inner) {
  Node fresh = *state.pages.read(inner);
  const double epoch = state.epoch_for(fresh);
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    Entry<D> entry = summary(*read_below(state.pages, inner, fresh, i), state.reader, epoch);
    entry.bounds.narrow_to(carried(bounds_at<D>(fresh, i), fresh.epoch, epoch));
    set_entry(fresh, i, entry);
  }
  fresh.epoch = epoch;
  state.pages.modify(inner) = std::move(fresh);
}

template <int D>
bool renew_if_stale(TreeState<D>& state, NodeNumber inner, std::size_t slot) {
  if (!is_stale(state, *state.pages.read(inner), slot)) return false;
  renew_entries(state, inner);
  return true;
}

template <int D>
void insert_object(TreeState<D>& state, const NewObject<D>& object, NodeNumber from, NodeNumber known_leaf) {
  if (from == 0) from = state.pages.find_root();
  if (from == 0) {
    from = state.pages.allocate();
    state.pages.set_root(from);
  }
  const NodeNumber number = choose_node(state, from, 0, object);
  Node& leaf = state.pages.modify(number);
  leaf.keys.push_back(object.id);
  leaf.values.insert(leaf.values.end(), object.record.begin(), object.record.end());
  if (number != known_leaf) state.pages.place({&object.id, 1}, number);
  fit_upward(state, number, object);
}

template <int D>
void insert_branch(TreeState<D>& state, const Branch<D>& branch) {
  const NodeNumber number = choose_node(state, state.pages.find_root(), branch.level, branch);
  Node& node = state.pages.modify(number);
  expect_no_child(node, branch.number);
  add_entry(node, branch.number, branch.entry(node.epoch));
  add_children(state, Unread{branch.number, branch.parent, branch.level - 1}, number);
  fit_upward(state, number, branch);
}

#define FORESEE_OF_AXES(D)                                                                    \
  template NodeNumber put_root_above<D>(TreeState<D>&, NodeNumber);                           \
  template void add_children<D>(TreeState<D>&, const Unread&, NodeNumber);                    \
  template NodeNumber split_node<D>(TreeState<D>&, NodeNumber, NodeNumber);                   \
  template void insert_object<D>(TreeState<D>&, const NewObject<D>&, NodeNumber, NodeNumber); \
  template void fit_upward(TreeState<D>&, NodeNumber, const NewObject<D>&);                   \
  template void insert_branch<D>(TreeState<D>&, const Branch<D>&);                            \
  template void renew_entries<D>(TreeState<D>&, NodeNumber);                                  \
  template bool renew_if_stale<D>(TreeState<D>&, NodeNumber, std::size_t)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
