#include <numeric>

#include "index/tpr_tree/leaf_pack.h"
#include "index/tpr_tree/update/choose_child.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/rebalance.h"
#include "index/tpr_tree/update/removal.h"

namespace foresee {
namespace {

/// The number of leaves that are packed together, and the number to try otherwise. At most max_moved objects
/// may change their leaf, unless a leaf holds more: each may be another row of the page map, and a small
/// commit should remain small.
constexpr std::size_t packed_together[] = {4, 2};
constexpr std::size_t max_moved = 72;
/// A change is worth it if it reduces the cost to less than this factor of what it was.
constexpr double worth_packing = 0.95, worth_moving = 0.8;

/// The cost that a child adds to its parent.
template <int D>
double share_of(const Node& parent, std::size_t child, double epoch, const VisitCost<D>& cost,
                const TypicalQuery& query) {
  Entry<D> rest;
  for (std::size_t slot = 0; slot < parent.size(); ++slot)
    if (slot != child) rest.include(entry_at<D>(parent, slot, epoch));
  Entry<D> all = rest;
  all.include(entry_at<D>(parent, child, epoch));
  return cost(all, query) - cost(rest, query);
}

/// Moves a leaf to another parent.
template <int D>
void move_leaf(TreeState<D>& state, NodeNumber leaf, NodeNumber from, NodeNumber to, NodeNumber above) {
  Node& old = state.pages.modify(from);
  Node& fresh = state.pages.modify(to);
  expect_no_child(fresh, leaf);
  const std::size_t slot = slot_of(old, leaf);
  const Branch<D> branch{leaf, from, old.level, entry_at<D>(old, slot), old.epoch};
  remove_slot(old, slot, state.stride(old.level));
  add_entry(fresh, leaf, branch.entry(fresh.epoch));
  add_children(state, Unread{leaf, from, 0}, to);
  Node& both = state.pages.modify(above);
  const auto set = [&](NodeNumber child, const Node& node, const Bounds<D>& known) {
    Entry<D> entry = summary(node, state.reader, both.epoch);
    entry.bounds.narrow_to(known);
    set_entry(both, slot_of(both, child), entry);
  };
  set(from, old, bounds_at<D>(both, slot_of(both, from)));
  Entry<D> with_leaf = entry_at<D>(both, slot_of(both, to));
  with_leaf.include(branch.entry(both.epoch));
  set(to, fresh, with_leaf.bounds);
  tighten_upward(state, above);
}

template <int D>
void move_where_it_costs_less(TreeState<D>& state, NodeNumber leaf) {
  NodeNumber from, to, above_number;
  {
    const auto node = state.pages.read(leaf);
    const auto parent = read_above(state.pages, leaf, *node);
    const auto above = parent ? read_above(state.pages, node->parent, *parent) : nullptr;
    if (!above || parent->size() <= state.min_size(parent->level)) return;
    from = node->parent, above_number = parent->parent;
    const VisitCost<D> cost = state.cost(above->epoch);
    const std::size_t own = slot_of(*above, from), slot = slot_of(*parent, leaf);
    const TypicalQuery query = cost.query_like(0.1, entry_at<D>(*above, own));
    const Entry<D> entry = entry_at<D>(*parent, slot, above->epoch);
    std::vector<Growth> others = growths(*above, entry, cost, query);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(own));
    if (others.empty()) return;
    const Growth best = *std::min_element(others.begin(), others.end());
    if (!(best.cost < worth_moving * share_of<D>(*parent, slot, above->epoch, cost, query))) return;
    to = above->keys[best.slot];
    const auto target = read_below(state.pages, above_number, *above, best.slot);
    if (target->size() >= state.capacity(target->level)) return;
  }
  move_leaf(state, leaf, from, to, above_number);
}

struct Packing {
  double epoch;  ///< of the new entries, and for the visit costs that are compared
  bool into_few_leaves;
  std::size_t max_arriving;  ///< the number of objects that may move to another leaf
};

/// Packs the leaves in these slots of a parent, into as many leaves or as few as hold their objects. Returns false if
/// the result is not worth it, or if too many objects would move.
template <int D>
bool pack_leaves(TreeState<D>& state, NodeNumber number, std::span<const std::size_t> slots,
                 const Packing& packing) {
  LeafPack<D> pack(state);
  std::vector<Entry<D>> before, after;
  {
    const auto parent = state.pages.read(number);
    for (const std::size_t slot : slots) {
      const auto old = read_below(state.pages, number, *parent, slot);
      pack.add(parent->keys[slot], *old);
      if (old->size() > 0) before.push_back(summary(*old, state.reader, packing.epoch));
    }
    if (before.empty()) return false;
    const VisitCost<D> cost = state.cost(packing.epoch);
    const TypicalQuery query = cost.query_like(0.5, before);
    pack.arrange(packing.into_few_leaves ? state.leaves_for(pack.objects()) : before.size());
    after = pack.summaries(packing.epoch);
    if (pack.arriving() > packing.max_arriving) return false;
    if (!(cost(after, query) < worth_packing * cost(before, query))) return false;
  }
  pack.write_beneath(number, state.pages.modify(number), after);
  return true;
}

template <int D>
bool pack_with_siblings(TreeState<D>& state, NodeNumber number, NodeNumber leaf, std::size_t together) {
  const auto parent = state.pages.read(number);
  const auto slots = closest_children(state, *parent, leaf, together);
  return pack_leaves(state, number, slots,
                     {.epoch = parent->epoch,
                      .into_few_leaves = false,
                      .max_arriving = std::max(max_moved, state.capacity(0))});
}

}  // namespace

template <int D>
void repack_around(TreeState<D>& state, NodeNumber leaf, std::size_t turn) {
  {
    const auto node = state.pages.read(leaf);
    if (!node->is_leaf()) throw BrokenTree("an object is not in a leaf of the tree");
    if (!read_above(state.pages, leaf, *node)) return;
  }
  move_where_it_costs_less(state, leaf);
  const NodeNumber parent = state.pages.read(leaf)->parent;
  for (const std::size_t together : packed_together)
    if (pack_with_siblings(state, parent, leaf, together)) break;
  if (turn % 2 == 0) renew_entries(state, parent);
  const NodeNumber above = state.pages.read(parent)->parent;
  if (turn % 16 == 0 && above != 0) renew_entries(state, above);
}

template <int D>
bool pack_all_leaves(TreeState<D>& state, NodeNumber parent) {
  const double epoch = state.epoch_for(*state.pages.read(parent));
  std::vector<std::size_t> slots(state.pages.read(parent)->size());
  std::iota(slots.begin(), slots.end(), std::size_t{0});
  if (!pack_leaves(state, parent, slots, {.epoch = epoch, .into_few_leaves = true, .max_arriving = SIZE_MAX}))
    return false;
  state.pages.modify(parent).epoch = epoch;
  return true;
}

#define FORESEE_OF_AXES(D)                                                \
  template void repack_around<D>(TreeState<D>&, NodeNumber, std::size_t); \
  template bool pack_all_leaves<D>(TreeState<D>&, NodeNumber)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
