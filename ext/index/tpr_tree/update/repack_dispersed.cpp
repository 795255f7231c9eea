#include <algorithm>
#include <cmath>
#include <optional>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/bulk_load/bulk_load.h"
#include "index/tpr_tree/bulk_load/leaf_order.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/rebalance.h"

namespace foresee {
namespace {

/// At most about so many objects are packed at once, so that a COMMIT takes little longer.
constexpr double max_packed = 50000;
/// Changes between two packings, as a share of the objects that one packs; and of those until nodes are examined again
/// if none has dispersed.
constexpr double changes_between = 0.25, examined_again = 0.25;
/// So many nodes are examined, of which the worst is packed.
constexpr std::uint64_t candidates = 4;
/// Objects have dispersed if queries visit so many times the leaves that they visit when packed.
constexpr double dispersed = 2.5;

/// A node that is packed, and what is beneath it.
struct Beneath {
  NodeNumber number;
  std::vector<NodeNumber> leaves, inner_nodes;
  std::vector<std::int64_t> ids;
  std::vector<double> records;
};

template <int D>
void append_beneath(const TreeState<D>& state, NodeNumber number, Beneath& all) {
  const auto inner = state.pages.read(number);
  for (std::size_t slot = 0; slot < inner->size(); ++slot) {
    const auto node = read_below(state.pages, number, *inner, slot);
    if (!node->is_leaf()) {
      all.inner_nodes.push_back(inner->keys[slot]);
      append_beneath(state, inner->keys[slot], all);
      continue;
    }
    all.leaves.push_back(inner->keys[slot]);
    all.ids.insert(all.ids.end(), node->keys.begin(), node->keys.end());
    all.records.insert(all.records.end(), node->values.begin(), node->values.end());
  }
}

template <int D>
Beneath read_beneath(const TreeState<D>& state, NodeNumber number) {
  Beneath all{.number = number, .leaves = {}, .inner_nodes = {}, .ids = {}, .records = {}};
  append_beneath(state, number, all);
  std::sort(all.leaves.begin(), all.leaves.end());
  if (std::adjacent_find(all.leaves.begin(), all.leaves.end()) != all.leaves.end())
    throw BrokenTree("a node of a tree has a child twice");
  return all;
}

/// The expected number of leaves that a query visits, if it is half as wide as a leaf and somewhere in the bounds of
/// all. Their entries are at the clock.
template <int D>
double visits_of(const TreeState<D>& state, const std::vector<Entry<D>>& leaves) {
  const VisitCost<D> cost = state.cost(state.clock.now());
  Entry<D> all;
  for (const Entry<D>& entry : leaves) all.include(entry);
  Bounds<D>& bounds = all.bounds;  // at the clock: a small crowd would spread far beyond its leaves
  bounds.v_lower = bounds.v_upper = bounds.a_lower = bounds.a_upper = Vec<D>::zero();
  const TypicalQuery query = cost.query_like(0.5, leaves);
  return cost(leaves, query) / cost(all, query);
}

template <int D>
void append_entries(const TreeState<D>& state, NodeNumber number, std::vector<Entry<D>>& leaves) {
  const auto inner = state.pages.read(number);
  for (std::size_t slot = 0; slot < inner->size(); ++slot)
    if (inner->level == 1) {
      leaves.push_back(entry_at<D>(*inner, slot, state.clock.now()));
    } else {
      read_below(state.pages, number, *inner, slot);  // checks it
      append_entries(state, inner->keys[slot], leaves);
    }
}

/// visits_of() the leaves beneath a node.
template <int D>
double visits_beneath(const TreeState<D>& state, NodeNumber number) {
  std::vector<Entry<D>> leaves;
  append_entries(state, number, leaves);
  return visits_of(state, leaves);
}

/// visits_of() the leaves into which these objects would be packed.
template <int D>
double visits_if_packed(const TreeState<D>& state, const Beneath& all) {
  NeverInterrupt never;
  std::vector<Entry<D>> leaves(state.leaves_for(all.ids.size()));
  const auto order = leaf_order(state, all.records, {leaves.size(), 1}, {0, leaves.size()}, never);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
    for (const std::uint32_t object : part_of(order, leaf, leaves.size())) {
      const double* const record = all.records.data() + object * state.reader.record_size();
      leaves[leaf].include(entry_of(Mover<D>(state.reader, record), state.clock.now()));
    }
  return visits_of(state, leaves);
}

/// The root, or beneath a higher one a node of this level at the end of a path that a draw chooses.
template <int D>
NodeNumber drawn_node(const TreeState<D>& state, int level, std::uint64_t draw) {
  NodeNumber number = state.pages.find_root();
  for (auto node = state.pages.read(number); node->level > level;) {
    if (node->size() == 0) throw BrokenTree("an inner node of the tree is empty");
    draw = hash_of(draw);
    const std::size_t slot = static_cast<std::size_t>(draw >> 32) % node->size();
    auto next = read_below(state.pages, number, *node, slot);
    number = node->keys[slot], node = std::move(next);
  }
  return number;
}

/// The numbers of leaves, and of nodes per level, for all beneath the node. Empty if they do not fit it.
template <int D>
std::vector<std::size_t> levels_beneath(const TreeState<D>& state, const Beneath& all) {
  const int level = state.pages.read(all.number)->level;
  const auto full = static_cast<std::size_t>(packed_fill * static_cast<double>(state.capacity(1)));
  std::vector<std::size_t> levels{state.leaves_for(all.ids.size())};
  while (static_cast<int>(levels.size()) < level) levels.push_back((levels.back() + full - 1) / full);
  return levels.back() < 2 || levels.back() > state.capacity(level) ? std::vector<std::size_t>() : levels;
}

/// Reads only. Nothing if no node is due.
template <int D>
std::optional<Beneath> find_dispersed(TreeState<D>& state, std::size_t changes, std::uint64_t draw) {
  if (state.pages.find_root() == 0) return {};
  const auto root = read(state.pages, unread_root(state.pages));
  const int level = std::min(state.highest_level_within(max_packed), root->level);
  if (level == 0 || root->size() == 0) return {};
  const double children = level == root->level ? static_cast<double>(root->size()) : state.likely_children();
  const double between = changes_between * state.likely_objects(level, children);
  RepackTurns& turns = state.repack_turns;
  if (!turns.are_known) turns = {.are_known = true, .changes = fraction_of(hash_of(draw)) * between};
  turns.changes += static_cast<double>(changes);
  if (turns.changes < between) return {};
  turns.changes = (1 - examined_again) * between;
  start_clock(state);
  NodeNumber number = 0;
  double visits = 0;
  for (std::uint64_t i = 0; i < candidates; ++i) {
    const NodeNumber candidate = drawn_node(state, level, hash_of(draw + i));
    const double theirs = visits_beneath(state, candidate);
    if (theirs > visits) visits = theirs, number = candidate;
  }
  const auto are_dispersed = [&] {
    return visits > dispersed * std::max(std::pow(1.5, D), turns.visits_when_packed);
  };
  if (!are_dispersed()) return {};
  Beneath found = read_beneath(state, number);
  if (turns.visits_when_packed == 0) turns.visits_when_packed = visits_if_packed(state, found);
  if (!are_dispersed() || levels_beneath(state, found).empty()) return {};
  return found;
}

/// Packs all beneath the node again.
template <int D>
void pack(TreeState<D>& state, const Beneath& old) {
  NeverInterrupt never;  // a small COMMIT should not fail for this
  std::vector<std::size_t> levels = levels_beneath(state, old);
  const std::span<const NodeNumber> leaves(old.leaves);
  const std::size_t used = std::min(levels[0], leaves.size());
  const auto run = pack_run(state, old.ids, old.records, std::move(levels), never, leaves.first(used));
  for (const NodeNumber leaf : leaves.subspan(used)) state.pages.free(leaf);
  for (const NodeNumber inner : old.inner_nodes) state.pages.free(inner);
  Lives lives;
  for (const Branch<D>& branch : run) lives.include(branch.known.times);
  Node& node = state.pages.modify(old.number);
  node.keys.clear(), node.values.clear(), node.kinds.clear();
  node.epoch = state.epoch_for(lives);
  for (const Branch<D>& branch : run) {
    add_entry(node, branch.number, branch.entry(node.epoch));
    add_children(state, Unread{branch.number, branch.parent, branch.level - 1}, old.number);
  }
}

}  // namespace

template <int D>
void repack_dispersed(TreeState<D>& state, std::size_t changes, std::uint64_t draw) {
  std::optional<Beneath> found;
  try {
    found = find_dispersed(state, changes, draw);
  } catch (const Error& error) {
    if (!error.is_damage()) throw;
    return;  // nothing is written yet; damage is reported where a query or a change reads it
  }
  if (!found) return;
  pack(state, *found);
  RepackTurns& turns = state.repack_turns;
  const double visits = visits_beneath(state, found->number);
  turns.changes = 0, turns.visits_when_packed = 0.5 * (turns.visits_when_packed + visits);
  NodeNumber number = found->number;
  while (const NodeNumber parent = state.pages.read(number)->parent) {
    even_out(state, parent, {&number, 1});
    number = parent;
  }
  even_out_root(state);
  state.pages.make_room();
}

template <int D>
void note_all_packed(TreeState<D>& state) {
  state.repack_turns = {.are_known = true};
  const int level = state.highest_level_within(max_packed);
  if (state.pages.find_root() == 0 || level == 0) return;
  const NodeNumber number = drawn_node(state, level, 0);
  if (!state.pages.read(number)->is_leaf())
    state.repack_turns.visits_when_packed = visits_beneath(state, number);
}

#define FORESEE_OF_AXES(D)                                                      \
  template void repack_dispersed<D>(TreeState<D>&, std::size_t, std::uint64_t); \
  template void note_all_packed<D>(TreeState<D>&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
