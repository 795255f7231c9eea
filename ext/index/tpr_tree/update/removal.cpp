#include "index/tpr_tree/update/removal.h"

#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/rebalance.h"

namespace foresee {
namespace {

/// The contents of dissolved nodes.
template <int D>
struct Orphans {
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  std::vector<Branch<D>> branches;

  void collect(NodeNumber number, const Node& node) {
    if (node.is_leaf()) {
      ids.insert(ids.end(), node.keys.begin(), node.keys.end());
      records.insert(records.end(), node.values.begin(), node.values.end());
      return;
    }
    for (std::size_t slot = 0; slot < node.size(); ++slot)
      branches.push_back({node.keys[slot], number, node.level, entry_at<D>(node, slot), node.epoch});
  }
};

/// Makes the parent's entry as tight as the node's numbers allow; false if it was so already.
template <int D>
bool tighten(TreeState<D>& state, NodeNumber number, NodeNumber parent) {
  std::size_t slot;
  Entry<D> tight;
  {
    const auto node = state.pages.read(number), above = state.pages.read(parent);
    slot = slot_of(*above, number);
    const Entry<D> before = entry_at<D>(*above, slot);
    tight = summary(*node, state.reader, above->epoch);
    tight.bounds.narrow_to(before.bounds);
    if (tight.times == before.times && tight.bounds == before.bounds && tight.kinds == before.kinds)
      return false;
  }
  set_entry(state.pages.modify(parent), slot, tight);
  return true;
}

template <int D>
void dissolve(TreeState<D>& state, NodeNumber number, NodeNumber parent_number, Orphans<D>& orphans) {
  orphans.collect(number, *state.pages.read(number));
  Node& parent = state.pages.modify(parent_number);
  remove_slot(parent, slot_of(parent, number), state.stride(parent.level));
  state.pages.free(number);
}

/// Rebalances a leaf that has lost an object, if it is less than half full. Returns the node at which to
/// continue: the leaf, or its parent if anything changed.
template <int D>
NodeNumber share(TreeState<D>& state, NodeNumber leaf) {
  NodeNumber parent;
  {
    const auto node = state.pages.read(leaf);
    if (2 * node->size() >= state.capacity(0) || !read_above(state.pages, leaf, *node)) return leaf;
    parent = node->parent;
  }
  return even_out_leaf(state, parent, leaf) ? parent : leaf;
}

/// Tightens and dissolves nodes from a leaf that has just lost an object up to the root. True if that leaf
/// still exists.
template <int D>
bool condense(TreeState<D>& state, NodeNumber leaf, Orphans<D>& orphans) {
  NodeNumber number = share(state, leaf);
  bool keeps_leaf = number == leaf || has_child(*state.pages.read(number), leaf);
  for (;;) {
    NodeNumber parent;
    bool too_empty;
    {
      const auto node = state.pages.read(number);
      parent = node->parent, too_empty = node->size() < state.min_size(node->level);
      if (!read_above(state.pages, number, *node)) break;
    }
    if (too_empty) {
      dissolve(state, number, parent, orphans);
      if (number == leaf) keeps_leaf = false;
    } else if (!tighten(state, number, parent)) {
      break;
    }
    number = parent;
  }
  return keeps_leaf;
}

template <int D>
void insert_again(TreeState<D>& state, const Orphans<D>& orphans) {
  for (auto branch = orphans.branches.rbegin(); branch != orphans.branches.rend(); ++branch)
    insert_branch(state, *branch);
  const std::size_t size = state.reader.record_size();
  for (std::size_t i = 0; i < orphans.ids.size(); ++i) {
    const std::span<const double> record(orphans.records.data() + i * size, size);
    insert_object(state, NewObject<D>{orphans.ids[i], record, Mover<D>(state.reader, record.data())});
  }
}

}  // namespace

template <int D>
void lower_root(TreeState<D>& state) {
  for (;;) {
    const NodeNumber number = state.pages.find_root();
    NodeNumber child = 0;
    {
      const auto root = state.pages.read(number);
      if (root->size() > 1 || (root->is_leaf() && root->size() == 1)) return;
      if (root->size() == 1) {
        child = root->keys[0];
        read_below(state.pages, number, *root, 0);
      }
    }
    state.pages.set_root(child);
    state.pages.free(number);
    if (child == 0) return;
    state.pages.modify(child).parent = 0;
  }
}

template <int D>
bool take_out(TreeState<D>& state, NodeNumber leaf, std::size_t slot) {
  remove_slot(state.pages.modify(leaf), slot, state.reader.record_size());
  Orphans<D> orphans;
  const bool keeps_leaf = condense(state, leaf, orphans);
  lower_root(state);
  insert_again(state, orphans);
  return keeps_leaf && state.pages.find_root() != 0;
}

template <int D>
bool erase_object(TreeState<D>& state, std::int64_t id) {
  const auto number = state.pages.find_leaf(id);
  if (!number) return false;
  std::size_t slot;
  {
    const auto leaf = state.pages.read(*number);
    if (!leaf->is_leaf()) throw BrokenTree("an object is not in a leaf of the tree");
    slot = slot_of(*leaf, id);
  }
  take_out(state, *number, slot);
  state.pages.forget(id);
  return true;
}

template <int D>
void tighten_upward(TreeState<D>& state, NodeNumber number) {
  for (;;) {
    const auto node = state.pages.read(number);
    if (!read_above(state.pages, number, *node) || !tighten(state, number, node->parent)) return;
    number = node->parent;
  }
}

template <int D>
bool is_outermost(TreeState<D>& state, NodeNumber leaf, std::size_t slot, const NewObject<D>& other) {
  const auto node = state.pages.read(leaf), above = read_above(state.pages, leaf, *node);
  if (!above) return false;
  const Mover<D> mover(state.reader, state.reader.record(*node, slot));
  const Entry<D> all = entry_at<D>(*above, slot_of(*above, leaf)), before = entry_of(mover, above->epoch),
                 after = other.entry(above->epoch);
  const auto leaves = [](const auto& end, const auto& from, const auto& to) {
    return (from == end && to != end).any();
  };
  using End = Vec<D> Bounds<D>::*;
  for (const End end : {&Bounds<D>::x_lower, &Bounds<D>::x_upper, &Bounds<D>::v_lower, &Bounds<D>::v_upper,
                        &Bounds<D>::a_lower, &Bounds<D>::a_upper})
    if (leaves(all.bounds.*end, before.bounds.*end, after.bounds.*end)) return true;
  const Times &ends = all.times, &from = before.times, &to = after.times;
  return (from.t_min == ends.t_min && to.t_min != ends.t_min) ||
         (from.until_max == ends.until_max && to.until_max != ends.until_max);
}

template <int D>
void refresh_newest(TreeState<D>& state, NodeNumber number) {
  for (;;) {
    std::size_t slot;
    Entry<D> entry;
    {
      const auto node = state.pages.read(number);
      const auto parent = read_above(state.pages, number, *node);
      if (!parent) return;
      slot = slot_of(*parent, number), entry = entry_at<D>(*parent, slot);
      const double newest = times_of(*node, state.reader).t_max;
      if (entry.times.t_max == newest) return;
      entry.times.t_max = newest;
      number = node->parent;
    }
    set_entry(state.pages.modify(number), slot, entry);
  }
}

#define FORESEE_OF_AXES(D)                                                                 \
  template bool is_outermost(TreeState<D>&, NodeNumber, std::size_t, const NewObject<D>&); \
  template bool erase_object<D>(TreeState<D>&, std::int64_t);                              \
  template void lower_root<D>(TreeState<D>&);                                              \
  template bool take_out<D>(TreeState<D>&, NodeNumber, std::size_t);                       \
  template void tighten_upward<D>(TreeState<D>&, NodeNumber);                              \
  template void refresh_newest<D>(TreeState<D>&, NodeNumber)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
