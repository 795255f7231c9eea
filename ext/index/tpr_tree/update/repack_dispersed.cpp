#include <algorithm>
#include <cmath>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/bulk_load/bulk_load.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/rebalance.h"

namespace foresee {
namespace {

/// The highest level beneath whose nodes all is packed at once: some 20,000 to 50,000 objects in nodes of 4 kB.
constexpr int highest_packed = 2;
/// Changes between two packings, as a share of the objects that one packs; and of those until nodes are examined again
/// if none has dispersed.
constexpr double changes_between = 0.25, examined_again = 0.25;
/// So many nodes are examined, of which the worst is packed.
constexpr std::uint64_t candidates = 4;
/// Objects have dispersed if queries visit so many times the leaves that they visit when packed.
constexpr double dispersed = 2.5;

/// What is beneath a node.
struct Beneath {
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

/// The entries of all leaves beneath a node, at `epoch`.
template <int D>
void append_entries(const TreeState<D>& state, NodeNumber number, double epoch,
                    std::vector<Entry<D>>& entries) {
  const auto inner = state.pages.read(number);
  for (std::size_t slot = 0; slot < inner->size(); ++slot)
    if (inner->level == 1) {
      entries.push_back(entry_at<D>(*inner, slot, epoch));
    } else {
      read_below(state.pages, number, *inner, slot);  // checks it
      append_entries(state, inner->keys[slot], epoch, entries);
    }
}

/// The expected number of leaves beneath a node that a query visits, if it is half as wide as a leaf and somewhere in
/// the bounds of all.
template <int D>
double visits_beneath(const TreeState<D>& state, NodeNumber number) {
  const double epoch = state.clock.now();
  const VisitCost<D> cost = state.cost(epoch);
  std::vector<Entry<D>> entries;
  append_entries(state, number, epoch, entries);
  Entry<D> all;
  for (const Entry<D>& entry : entries) all.include(entry);
  Bounds<D>& bounds = all.bounds;  // at the clock: a small crowd would spread far beyond its leaves
  bounds.v_lower = bounds.v_upper = bounds.a_lower = bounds.a_upper = Vec<D>::Zero();
  const TypicalQuery query = cost.query_like(0.5, entries);
  return cost(entries, query) / cost(all, query);
}

/// Packs all objects beneath a node of level 1 or 2 again. Returns false, and writes nothing, if they do not fit it.
template <int D>
bool pack_beneath(TreeState<D>& state, NodeNumber number) {
  Beneath old;
  append_beneath(state, number, old);
  std::sort(old.leaves.begin(), old.leaves.end());
  if (std::adjacent_find(old.leaves.begin(), old.leaves.end()) != old.leaves.end())
    throw BrokenTree("a node of a tree has a child twice");
  const int level = state.pages.read(number)->level;
  std::vector<std::size_t> levels{state.leaves_for(old.ids.size())};
  if (level == 2) {
    const auto full = static_cast<std::size_t>(packed_fill * static_cast<double>(state.capacity(1)));
    levels.push_back((levels[0] + full - 1) / full);
  }
  if (levels.back() < 2 || levels.back() > state.capacity(level)) return false;
  const std::span<const NodeNumber> leaves(old.leaves);
  const std::size_t used = std::min(levels[0], leaves.size());
  NeverInterrupt never;  // a small COMMIT should not fail for this
  const auto run = pack_run(state, old.ids, old.records, std::move(levels), never, leaves.first(used));
  for (const NodeNumber leaf : leaves.subspan(used)) state.pages.free(leaf);
  for (const NodeNumber inner : old.inner_nodes) state.pages.free(inner);
  Lives lives;
  for (const Branch<D>& branch : run) lives.include(branch.known.times);
  Node& node = state.pages.modify(number);
  node.keys.clear(), node.values.clear(), node.kinds.clear();
  node.epoch = state.epoch_for(lives);
  for (const Branch<D>& branch : run) {
    add_entry(node, branch.number, branch.entry(node.epoch));
    add_children(state, Unread{branch.number, branch.parent, branch.level - 1}, number);
  }
  return true;
}

/// The root, or beneath a higher one a node of level 2 at the end of a path that a draw chooses.
template <int D>
NodeNumber drawn_node(const TreeState<D>& state, std::uint64_t draw) {
  NodeNumber number = state.pages.find_root();
  for (auto node = state.pages.read(number); node->level > highest_packed;) {
    if (node->size() == 0) throw BrokenTree("an inner node of the tree is empty");
    draw = hash_of(draw);
    const std::size_t slot = static_cast<std::size_t>(draw >> 32) % node->size();
    auto next = read_below(state.pages, number, *node, slot);
    number = node->keys[slot], node = std::move(next);
  }
  return number;
}

/// About so many objects are beneath a node that may be packed.
template <int D>
double packed_at_once(const TreeState<D>& state, const Node& root) {
  constexpr double fill = 0.7;
  const double inner = fill * static_cast<double>(state.capacity(1)),
               children = root.level <= highest_packed ? static_cast<double>(root.size()) : inner;
  return children * (root.level == 1 ? 1 : inner) * static_cast<double>(state.packed_size());
}

}  // namespace

template <int D>
void repack_dispersed(TreeState<D>& state, std::size_t changes, std::uint64_t draw) {
  if (state.pages.find_root() == 0) return;
  double between;
  {
    const auto root = read(state.pages, unread_root(state.pages));
    if (root->is_leaf()) return;
    between = changes_between * packed_at_once(state, *root);
  }
  RepackTurns& turns = state.repack_turns;
  if (!turns.are_known) turns = {.are_known = true, .changes = fraction_of(hash_of(draw)) * between};
  turns.changes += static_cast<double>(changes);
  if (turns.changes < between) return;
  NodeNumber number = 0;
  double visits = 0;
  for (std::uint64_t i = 0; i < candidates; ++i) {
    const NodeNumber candidate = drawn_node(state, hash_of(draw + i));
    const double theirs = visits_beneath(state, candidate);
    if (theirs > visits) visits = theirs, number = candidate;
  }
  const double packed = std::max(turns.visits_when_packed, std::pow(1.5, D));
  if (!(visits > dispersed * packed) || !pack_beneath(state, number)) {
    turns.changes = (1 - examined_again) * between;
    return;
  }
  turns.changes = 0, turns.visits_when_packed = visits_beneath(state, number);
  while (const NodeNumber parent = state.pages.read(number)->parent) {
    even_out(state, parent, {&number, 1});
    number = parent;
  }
  even_out_root(state);
  state.pages.make_room();
}

template <int D>
void note_all_packed(TreeState<D>& state) {
  const NodeNumber root = state.pages.find_root();
  const bool has_leaves = root != 0 && !state.pages.read(root)->is_leaf();
  state.repack_turns = {.are_known = true,
                        .changes = 0,
                        .visits_when_packed = has_leaves ? visits_beneath(state, drawn_node(state, 0)) : 0};
}

#define FORESEE_OF_AXES(D)                         \
  template void note_all_packed<D>(TreeState<D>&); \
  template void repack_dispersed<D>(TreeState<D>&, std::size_t, std::uint64_t)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
