#include <algorithm>
#include <numeric>
#include <utility>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/bulk_load/bulk_load.h"
#include "index/tpr_tree/update/batch_descent.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/merge.h"
#include "index/tpr_tree/update/rebalance.h"

namespace foresee {
namespace {

/// A smaller batch has too few objects for most partitions.
constexpr double min_share = 1.0 / 256;
/// Fewer objects of a partition are inserted one by one.
constexpr std::size_t min_objects = 8;
/// Of loose to main objects, on average.
constexpr double max_loose = 1.0 / 4;
/// Of the leaves of a packed partition: the rest is for loose ones.
constexpr double main_fill = 0.75;

/// max_loose times 0.7 to 1.3. Consecutive numbers differ as evenly as can be (repeatable_choice.h).
double max_loose_in(NodeNumber partition) {
  return max_loose * (0.7 + 0.6 * spread_fraction(static_cast<std::uint64_t>(partition)));
}

template <int D>
class RunMerge {
 public:
  RunMerge(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
           Interrupt& interrupt)
      : state_(state), interrupt_(interrupt), ids_(ids), batch_(state, ids, records, interrupt) {}

  Remainder run() {
    auto& all = batch_.root().objects;
    for (std::uint32_t i = 0; i < batch_.size(); ++i) all.push_back(i);
    for (std::size_t level = batch_.levels(); --level > 1;) batch_.sink(level);
    state_.pages.start_placing(ids_);
    for (auto& [number, visit] : batch_.at(1))
      visit.objects.size() >= min_objects ? pack(number, visit) : rest_.add(batch_, visit.objects);
    state_.pages.finish_placing(interrupt_);
    for (const Packed& packed : packed_) connect(packed);
    for (std::size_t level = 2; level < batch_.levels(); ++level)
      for (auto& [number, visit] : batch_.at(level)) {
        batch_.step();
        even_out(state_, number, visit.children);
      }
    even_out_root(state_);
    return std::move(rest_);
  }

 private:
  using Visit = typename BatchDescent<D>::Visit;

  /// A run that takes the place of leaves of a partition, or of all of it.
  struct Packed {
    NodeNumber partition, parent;
    std::vector<NodeNumber> old;  ///< the leaves that it replaces
    std::vector<Branch<D>> run;

    bool is_all() const { return run.front().level > 1; }
  };

  /// Packs the objects that have come to a partition, with its newest loose leaves or with all of it.
  void pack(NodeNumber number, const Visit& visit) {
    interrupt_.check();
    const auto partition = state_.pages.read(number);
    Remainder& objects = packing_;
    objects.clear();
    Packed packed{number, visit.parent, {}, {}};
    const std::size_t added = visit.objects.size(), main = count_main_leaves(*partition, number);
    const auto of_leaves = [&](std::size_t leaves) {
      return static_cast<double>(leaves * state_.packed_size());
    };
    const std::size_t loose = partition->size() - main;
    const bool is_due =
        of_leaves(loose) + static_cast<double>(added) > max_loose_in(number) * of_leaves(main);
    const std::size_t kept =
        is_due ? 0 : main + loose - leaves_of_newest_runs(loose, state_.leaves_for(added));
    const std::vector<std::size_t> slots = by_number(*partition);
    for (std::size_t i = kept; i < slots.size(); ++i) take_leaf(*partition, slots[i], packed, objects);
    objects.add(batch_, visit.objects);
    packed.run = pack_objects(objects, packed.old, is_due);
    const bool fits =
        partition->size() - packed.old.size() + packed.run.size() <= state_.pages.inner_capacity();
    if (packed.is_all() || !fits) return packed_.push_back(std::move(packed));
    connect(packed);
    state_.pages.make_room();
  }

  /// A loose leaf has a larger number than its partition.
  static std::size_t count_main_leaves(const Node& partition, NodeNumber number) {
    return static_cast<std::size_t>(std::count_if(partition.keys.begin(), partition.keys.end(),
                                                  [=](NodeNumber leaf) { return leaf < number; }));
  }

  /// The main leaves, then the loose ones, oldest first: a run takes the numbers of the newest leaves, then larger
  /// ones.
  static std::vector<std::size_t> by_number(const Node& partition) {
    std::vector<std::size_t> slots(partition.size());
    std::iota(slots.begin(), slots.end(), std::size_t{0});
    std::sort(slots.begin(), slots.end(),
              [&](std::size_t a, std::size_t b) { return partition.keys[a] < partition.keys[b]; });
    return slots;
  }

  /// How many of the loose leaves are packed together with a batch that takes `added` leaves. As a binary counter
  /// carries: the runs have 1, 2, 4 … batches, and a batch takes in the newest ones, up to the first size that is
  /// missing. So an object is packed again as often as the number of its batches doubles.
  static std::size_t leaves_of_newest_runs(std::size_t loose, std::size_t added) {
    const std::size_t batches = loose / added;
    const std::size_t carried = (batches ^ (batches + 1)) >> 1;
    return std::min(loose, carried * added);
  }

  void take_leaf(const Node& partition, std::size_t slot, Packed& packed, Remainder& objects) {
    const auto leaf = read_below(state_.pages, packed.partition, partition, slot);
    packed.old.push_back(partition.keys[slot]);
    objects.ids.insert(objects.ids.end(), leaf->keys.begin(), leaf->keys.end());
    objects.records.insert(objects.records.end(), leaf->values.begin(), leaf->values.end());
  }

  /// Packs into leaves, or into new partitions. The old leaves are used again as far as they go.
  std::vector<Branch<D>> pack_objects(const Remainder& objects, std::span<const NodeNumber> old,
                                      bool into_partitions) {
    std::vector<NodeNumber> numbers(old.begin(), old.end());
    std::sort(numbers.begin(), numbers.end());
    std::vector<std::size_t> levels{state_.leaves_for(objects.ids.size())};
    if (into_partitions) {
      const auto size =
          static_cast<std::size_t>(main_fill * static_cast<double>(state_.pages.inner_capacity()));
      levels[0] = std::max<std::size_t>(levels[0], 2);
      // No partition has a single leaf.
      levels.push_back(std::min((levels[0] + size - 1) / size, levels[0] / 2));
    }
    const std::span<const NodeNumber> leaves(numbers);
    const std::size_t used = std::min(levels[0], leaves.size());
    auto run =
        pack_run(state_, objects.ids, objects.records, std::move(levels), interrupt_, leaves.first(used));
    for (const NodeNumber leaf : leaves.subspan(used)) state_.pages.free(leaf);
    return run;
  }

  /// Puts a run in the place of what it replaces. A new partition has a larger number than its leaves.
  void connect(const Packed& packed) {
    const NodeNumber above = packed.is_all() ? packed.parent : packed.partition;
    Node& node = state_.pages.modify(above);
    const auto remove = [&](NodeNumber child) {
      remove_slot(node, slot_of(node, child), state_.stride(node.level));
    };
    if (packed.is_all()) {
      remove(packed.partition);
      state_.pages.free(packed.partition);
    } else {
      std::for_each(packed.old.begin(), packed.old.end(), remove);
    }
    for (const Branch<D>& branch : packed.run) {
      add_entry(node, branch.number, branch.entry(node.epoch));
      add_children(state_, Unread{branch.number, branch.parent, branch.level - 1}, above);
    }
    if (!packed.is_all()) return;
    auto& children = batch_.at(2).at(above).children;
    std::erase(children, packed.partition);
    for (const Branch<D>& branch : packed.run) children.push_back(branch.number);
  }

  TreeState<D>& state_;
  Interrupt& interrupt_;
  std::span<const std::int64_t> ids_;
  BatchDescent<D> batch_;
  /// Not connected yet: pages may write nodes while others are packed, and none may be overfull then.
  std::vector<Packed> packed_;
  Remainder rest_;
  Remainder packing_;  ///< the objects of one partition; its memory serves all
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
  return root != 0 && state.pages.read(root)->level > 1 &&
         static_cast<double>(objects) >=
             min_share * estimate_objects(state.pages, static_cast<double>(objects));
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
