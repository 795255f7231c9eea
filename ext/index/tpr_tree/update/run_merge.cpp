#include <algorithm>
#include <utility>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/bulk_load/bulk_load.h"
#include "index/tpr_tree/update/batch_descent.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/merge.h"
#include "index/tpr_tree/update/rebalance.h"

namespace foresee {
namespace {

/// A smaller batch is inserted object by object: packing again what is loose would write as much.
constexpr double min_share = 1.0 / 256;
constexpr std::size_t min_objects = 8;  // of a partition; fewer are inserted one by one
/// No partition has many more, so that each is packed in little time and memory. Of nodes of 4 kB: those of level 2.
constexpr double max_objects = 100'000;
/// Of loose to main objects, on average.
constexpr double max_loose = 1.0 / 4;
/// Of the children of a packed partition: the rest is for loose ones.
constexpr double main_fill = 0.75;

/// max_loose times 0.7 to 1.3. Consecutive numbers differ as evenly as can be (repeatable_choice.h).
double max_loose_in(NodeNumber partition) {
  return max_loose * (0.7 + 0.6 * spread_fraction(static_cast<std::uint64_t>(partition)));
}

/// Of what the tree holds.
template <int D>
double share_of(const TreeState<D>& state, std::size_t objects) {
  const double added = static_cast<double>(objects);
  return added / std::max(estimate_objects(state.pages, added), 1.0);
}

/// The level of the nodes that are partitions: the lowest to which the batch brings a leaf each, or the highest.
template <int D>
std::size_t partition_level(const TreeState<D>& state, std::size_t objects) {
  const double share = share_of(state, objects), leaf = static_cast<double>(state.packed_size());
  const int highest =
      std::min(state.pages.read(state.pages.find_root())->level - 1, state.highest_level_within(max_objects));
  int level = 1;
  while (level < highest && share * state.likely_objects(level, state.likely_children()) < leaf) ++level;
  return static_cast<std::size_t>(level);
}

template <int D>
class RunMerge {
 public:
  RunMerge(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
           Interrupt& interrupt)
      : state_(state),
        interrupt_(interrupt),
        ids_(ids),
        batch_(state, ids, records, interrupt),
        level_(partition_level(state, ids.size())) {}

  Remainder run() {
    auto& all = batch_.root().objects;
    for (std::uint32_t i = 0; i < batch_.size(); ++i) all.push_back(i);
    for (std::size_t level = batch_.levels(); --level > level_;) batch_.sink(level);
    state_.pages.start_placing(ids_);
    for (auto& [number, visit] : batch_.at(level_))
      makes_run(visit.objects.size()) ? pack(number, visit) : rest_.add(batch_, visit.objects);
    state_.pages.finish_placing(interrupt_);
    for (const Packed& packed : packed_) connect(packed);
    for (std::size_t level = level_ + 1; level < batch_.levels(); ++level)
      for (auto& [number, visit] : batch_.at(level)) {
        batch_.step();
        even_out(state_, number, visit.children);
      }
    even_out_root(state_);
    return std::move(rest_);
  }

 private:
  using Visit = typename BatchDescent<D>::Visit;

  /// A run that takes the place of children of a partition, or of all of it.
  struct Packed {
    NodeNumber partition, parent;
    std::vector<NodeNumber> old;  ///< the children that it replaces
    std::vector<Branch<D>> run;
    bool is_all;
  };
  struct Child {
    NodeNumber number;
    std::size_t slot, leaves;
    bool is_loose;  ///< has a larger number than its partition
  };
  /// The nodes of a partition that are replaced, and their objects.
  struct Replaced {
    std::vector<NodeNumber> leaves, inner;
    Remainder objects;
  };

  /// Of a subtree whose root has this level: no node has a single child.
  static std::size_t min_leaves(std::size_t level) { return std::size_t{1} << level; }

  /// No leaf may be empty.
  bool makes_run(std::size_t objects) const {
    return objects >= std::max(min_objects, 2 * min_leaves(level_ - 1));
  }

  /// Packs the objects that have come to a partition, with its newest runs or with all of it.
  void pack(NodeNumber number, const Visit& visit) {
    interrupt_.check();
    const auto partition = state_.pages.read(number);
    const std::size_t added = visit.objects.size();
    std::vector<Child> children = children_by_number(number, *partition);
    std::size_t main = 0, loose = 0;
    for (const Child& child : children) (child.is_loose ? loose : main) += child.leaves;
    const double added_leaves = static_cast<double>(added) / static_cast<double>(state_.packed_size());
    const bool is_due =
        static_cast<double>(loose) + added_leaves > max_loose_in(number) * static_cast<double>(main);
    std::size_t to_take = is_due ? main + loose : leaves_of_newest_runs(loose, state_.leaves_for(added));
    Packed packed{number, visit.parent, {}, {}, is_due};
    replaced_.leaves.clear(), replaced_.inner.clear(), replaced_.objects.clear();
    for (; to_take > 0 && !children.empty(); children.pop_back()) {
      const Child& newest = children.back();
      to_take -= std::min(to_take, newest.leaves);
      packed.old.push_back(newest.number);
      take(number, *partition, newest.slot);
    }
    replaced_.objects.add(batch_, visit.objects);
    packed.run = pack_objects(is_due);
    const bool fits =
        partition->size() - packed.old.size() + packed.run.size() <= state_.pages.inner_capacity();
    if (packed.is_all || !fits) return packed_.push_back(std::move(packed));
    connect(packed);
    state_.pages.make_room();
  }

  /// The main children, then the loose ones, oldest first.
  std::vector<Child> children_by_number(NodeNumber number, const Node& partition) {
    std::vector<Child> children;
    for (std::size_t slot = 0; slot < partition.size(); ++slot)
      children.push_back({partition.keys[slot], slot, leaves_beneath(number, partition, slot),
                          partition.keys[slot] > number});
    std::sort(children.begin(), children.end(),
              [](const Child& a, const Child& b) { return a.number < b.number; });
    return children;
  }

  std::size_t leaves_beneath(NodeNumber number, const Node& node, std::size_t slot) {
    if (node.level == 1) return 1;
    const auto child = read_below(state_.pages, number, node, slot);
    if (child->level == 1) return child->size();
    std::size_t leaves = 0;
    for (std::size_t i = 0; i < child->size(); ++i) leaves += leaves_beneath(node.keys[slot], *child, i);
    return leaves;
  }

  /// How many loose leaves are packed together with a batch that takes `added` leaves. As a binary counter
  /// carries: the runs have 1, 2, 4 … batches, and a batch takes in the newest ones, up to the first size that is
  /// missing. So an object is packed again as often as the number of its batches doubles. Subtrees are one run: a query
  /// would visit a node and a leaf of each.
  std::size_t leaves_of_newest_runs(std::size_t loose, std::size_t added) const {
    if (level_ > 1) return loose;
    const std::size_t batches = loose / added;
    const std::size_t carried = (batches ^ (batches + 1)) >> 1;
    return std::min(loose, carried * added);
  }

  void take(NodeNumber number, const Node& node, std::size_t slot) {
    const auto child = read_below(state_.pages, number, node, slot);
    const NodeNumber below = node.keys[slot];
    if (!child->is_leaf()) {
      for (std::size_t i = 0; i < child->size(); ++i) take(below, *child, i);
      return replaced_.inner.push_back(below);
    }
    replaced_.leaves.push_back(below);
    auto& [ids, records] = replaced_.objects;
    ids.insert(ids.end(), child->keys.begin(), child->keys.end());
    records.insert(records.end(), child->values.begin(), child->values.end());
  }

  /// Packs what is replaced into children of the partition, or into new partitions. The old leaves are used again as
  /// far as they go.
  std::vector<Branch<D>> pack_objects(bool into_partitions) {
    auto& [leaves, inner, objects] = replaced_;
    std::sort(leaves.begin(), leaves.end());
    if (std::adjacent_find(leaves.begin(), leaves.end()) != leaves.end())
      throw BrokenTree("a node of a tree has a child twice");
    std::vector<std::size_t> levels = levels_for(objects.ids.size(), into_partitions ? level_ : level_ - 1);
    const std::size_t used = std::min(levels[0], leaves.size());
    auto run = pack_run(state_, objects.ids, objects.records, std::move(levels), interrupt_,
                        std::span<const NodeNumber>(leaves).first(used));
    for (std::size_t i = used; i < leaves.size(); ++i) state_.pages.free(leaves[i]);
    for (const NodeNumber node : inner) state_.pages.free(node);
    return run;
  }

  /// The number of nodes of each level up to `top`, none of which has a single child. Of new partitions, those have
  /// room for loose children.
  std::vector<std::size_t> levels_for(std::size_t objects, std::size_t top) const {
    std::vector<std::size_t> levels{std::max(state_.leaves_for(objects), min_leaves(top))};
    for (std::size_t level = 1; level <= top; ++level) {
      const double fill = level == level_ ? main_fill : 1;
      const auto size = static_cast<std::size_t>(fill * static_cast<double>(state_.pages.inner_capacity()));
      const std::size_t below = levels.back();
      levels.push_back(std::min(std::max((below + size - 1) / size, min_leaves(top - level)), below / 2));
    }
    return levels;
  }

  /// Puts a run in the place of what it replaces. A new partition has a larger number than its children.
  void connect(const Packed& packed) {
    const NodeNumber above = packed.is_all ? packed.parent : packed.partition;
    Node& node = state_.pages.modify(above);
    const auto remove = [&](NodeNumber child) {
      remove_slot(node, slot_of(node, child), state_.stride(node.level));
    };
    if (packed.is_all) {
      remove(packed.partition);
      state_.pages.free(packed.partition);
    } else {
      std::for_each(packed.old.begin(), packed.old.end(), remove);
    }
    for (const Branch<D>& branch : packed.run) {
      add_entry(node, branch.number, branch.entry(node.epoch));
      add_children(state_, Unread{branch.number, branch.parent, branch.level - 1}, above);
    }
    if (!packed.is_all) return;
    auto& children = batch_.at(level_ + 1).at(above).children;
    std::erase(children, packed.partition);
    for (const Branch<D>& branch : packed.run) children.push_back(branch.number);
  }

  TreeState<D>& state_;
  Interrupt& interrupt_;
  std::span<const std::int64_t> ids_;
  BatchDescent<D> batch_;
  std::size_t level_;  ///< of the partitions
  /// Not connected yet: pages may write nodes while others are packed, and none may be overfull then.
  std::vector<Packed> packed_;
  Remainder rest_;
  Replaced replaced_;  ///< of one partition; its memory serves all
};

/// The ancestor of a leaf at this level, or the root.
NodeNumber ancestor_of(Pages& pages, NodeNumber number, int level) {
  auto node = pages.read(number);
  while (node->level < level) {
    const auto above = read_above(pages, number, *node);
    if (!above) break;
    number = std::exchange(node, above)->parent;
  }
  return number;
}

}  // namespace

template <int D>
bool takes_runs(const TreeState<D>& state, std::size_t objects) {
  const NodeNumber root = state.pages.find_root();
  return root != 0 && state.pages.read(root)->level > 1 && share_of(state, objects) >= min_share;
}

template <int D>
Remainder merge_runs(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                     Interrupt& interrupt) {
  return RunMerge<D>(state, ids, records, interrupt).run();
}

template <int D>
bool arrive_in_place(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                     Interrupt& interrupt) {
  constexpr std::size_t samples = 64;
  const int root = state.pages.read(state.pages.find_root())->level;
  if (ids.size() < 2 * samples || root == 0) return false;
  const int level =
      std::max(1, std::min(state.highest_level_within(static_cast<double>(ids.size()) / 8), root - 1));
  const std::size_t size = state.reader.record_size();
  std::size_t in_place = 0;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    const std::size_t first = sample * (ids.size() - 2) / samples;
    const auto pair = state.pages.leaves_of(ids.subspan(first, 2), interrupt);
    if (pair[0] == 0 || pair[1] == 0) continue;
    const NodeNumber number = ancestor_of(state.pages, pair[1], level);
    if (ancestor_of(state.pages, pair[0], level) != number) continue;
    const auto above = read_above(state.pages, number, *state.pages.read(number));
    const Mover<D> mover(state.reader, records.data() + (first + 1) * size);
    in_place += !above || entry_without_newest<D>(*above, number).contains(entry_of(mover, above->epoch));
  }
  return 2 * in_place > samples;
}

#define FORESEE_OF_AXES(D)                                                                                \
  template bool arrive_in_place<D>(TreeState<D>&, std::span<const std::int64_t>, std::span<const double>, \
                                   Interrupt&);                                                           \
  template bool takes_runs<D>(const TreeState<D>&, std::size_t);                                          \
  template Remainder merge_runs<D>(TreeState<D>&, std::span<const std::int64_t>, std::span<const double>, \
                                   Interrupt&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
