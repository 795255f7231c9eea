#include "index/tpr_tree/bulk_load/bulk_load.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/interrupt_steps.h"
#include "index/tpr_tree/bulk_load/leaf_order.h"

namespace foresee {
namespace {

/// The time that all but a twentieth of a sample have reached. Objects that have not reported again are older than
/// the current time; few are scheduled for later.
template <int D>
double typical_t(const LeafReader<D>& reader, std::span<const double> records) {
  const std::size_t count = records.size() / reader.record_size(), step = count / 1024 + 1;
  std::vector<double> sample;
  for (std::size_t i = 0; i < count; i += step)
    sample.push_back(reader.t(records.data() + i * reader.record_size()));
  const auto late = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() - sample.size() / 20 - 1);
  std::nth_element(sample.begin(), late, sample.end());
  return *late;
}

template <int D>
class TreeLoad {
 public:
  /// The first leaves get the numbers of `old_leaves`.
  TreeLoad(TreeState<D>& state, Interrupt& interrupt, std::span<const NodeNumber> old_leaves = {})
      : state_(state), interrupt_(interrupt), old_leaves_(old_leaves) {}

  void run(std::span<const std::int64_t> ids, std::span<const double> records) {
    pack(ids, records, level_sizes(state_.leaves_for(ids.size()), state_.pages.inner_capacity()));
    set_root();
  }

  void run(ObjectPartitions& partitions) {
    const std::span<const std::size_t> counts = partitions.counts();
    std::vector<std::size_t> leaves;
    for (const std::size_t count : counts) leaves.push_back(count == 0 ? 0 : state_.leaves_for(count));
    number_nodes(level_sizes(std::accumulate(leaves.begin(), leaves.end(), std::size_t{0}),
                             state_.pages.inner_capacity()));
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    for (std::size_t i = 0, first = 0; i < leaves.size(); first += leaves[i++]) {
      if (leaves[i] == 0) continue;
      partitions.read(i, ids, records);
      write_leaves(ids, records, {first, leaves[i]});
    }
    std::vector<double>().swap(records);
    write_inner_levels();
    set_root();
  }

  /// Subtrees of this many nodes per level, which are not connected to the tree yet.
  std::vector<Branch<D>> pack_branches(std::span<const std::int64_t> ids, std::span<const double> records,
                                       std::vector<std::size_t> levels) {
    pack(ids, records, std::move(levels));
    std::vector<Branch<D>> branches;
    const std::size_t top = levels_.size() - 1;
    for (std::size_t i = 0; i < levels_[top]; ++i)
      branches.push_back({number(top, i), 0, static_cast<int>(top) + 1, entries_[i], epochs_.back()});
    return branches;
  }

 private:
  void pack(std::span<const std::int64_t> ids, std::span<const double> records,
            std::vector<std::size_t> levels) {
    start_clock(state_, records);
    number_nodes(std::move(levels));
    write_leaves(ids, records, {0, levels_[0]});
    write_inner_levels();
  }

  void set_root() { state_.pages.set_root(number(levels_.size() - 1, 0)); }

  void number_nodes(std::vector<std::size_t> levels) {
    levels_ = std::move(levels);
    std::size_t nodes = 0;
    for (const std::size_t level : levels_) {
      firsts_.push_back(static_cast<NodeNumber>(nodes));
      nodes += level;
    }
    const NodeNumber first =
        state_.pages.reserve(nodes - old_leaves_.size()) - static_cast<NodeNumber>(old_leaves_.size());
    for (NodeNumber& number : firsts_) number += first;
  }

  NodeNumber number(std::size_t level, std::size_t i) const {
    if (level == 0 && i < old_leaves_.size()) return old_leaves_[i];
    return firsts_[level] + static_cast<NodeNumber>(i);
  }

  void write_leaves(std::span<const std::int64_t> ids, std::span<const double> records, LeafRange leaves) {
    const auto order = leaf_order(state_, records, levels_, leaves, interrupt_);
    for (std::size_t i = 0; i < leaves.count; ++i) {
      Node leaf = objects_at(part_of(order, i, leaves.count), ids, records, state_.reader.record_size());
      state_.pages.place(leaf.keys, number(0, leaves.first + i));
      finish(std::move(leaf), 0, leaves.first + i);
    }
  }

  void write_inner_levels() {
    for (std::size_t level = 1; level < levels_.size(); ++level) write_inner_nodes(level);
  }

  void write_inner_nodes(std::size_t level) {
    const std::vector<Entry<D>> below = std::exchange(entries_, {});
    const std::vector<double> epochs = std::exchange(epochs_, {});
    const std::size_t nodes = levels_[level];
    for (std::size_t i = 0; i < nodes; ++i) {
      Node inner;
      inner.level = static_cast<int>(level);
      inner.epoch = epochs[i];
      const std::size_t last = first_child(i + 1, nodes, below.size());
      for (std::size_t child = first_child(i, nodes, below.size()); child < last; ++child)
        add_entry(inner, number(level - 1, child), below[child]);
      finish(std::move(inner), level, i);
    }
  }

  /// Writes node i of a level, together with its siblings, whose lives choose the epoch of their parent.
  void finish(Node node, std::size_t level, std::size_t i) {
    if (i % 64 == 0) interrupt_.check();
    const bool is_root = level + 1 == levels_.size();
    const std::size_t nodes = levels_[level], parents = is_root ? 1 : levels_[level + 1];
    std::size_t parent = i * parents / nodes;
    while (first_child(parent + 1, parents, nodes) <= i) ++parent;
    node.parent = is_root ? 0 : number(level + 1, parent);
    siblings_.push_back(std::move(node));
    if (i + 1 == first_child(parent + 1, parents, nodes)) write_siblings(level, i + 1);
  }

  /// Writes the nodes of a level before its node `end` and keeps their entries for the level above.
  void write_siblings(std::size_t level, std::size_t end) {
    Lives lives;
    for (const Node& node : siblings_) lives.include(times_of(node, state_.reader));
    epochs_.push_back(state_.epoch_for(lives));
    std::size_t next = end - siblings_.size();
    for (Node& node : siblings_) {
      entries_.push_back(summary(node, state_.reader, epochs_.back()));
      state_.pages.put(number(level, next++), std::move(node));
    }
    siblings_.clear();
  }

  TreeState<D>& state_;
  Interrupt& interrupt_;
  std::span<const NodeNumber> old_leaves_;
  std::vector<std::size_t> levels_;  ///< number of nodes per level
  std::vector<NodeNumber> firsts_;   ///< the first node number of each level; the others follow
  std::vector<Node> siblings_;       ///< not written yet
  std::vector<Entry<D>> entries_;    ///< of the nodes written last, for the level above
  std::vector<double> epochs_;       ///< of the nodes of the level above
};

}  // namespace

template <int D>
void start_clock(TreeState<D>& state, std::span<const double> records) {
  if (!state.clock.runs()) state.clock.set(typical_t(state.reader, records));
}

template <int D>
void start_clock(TreeState<D>& state) {
  if (state.clock.runs() || state.pages.find_root() == 0) return;
  const auto root = read(state.pages, unread_root(state.pages));
  if (root->is_leaf()) return start_clock(state, root->values);
  std::vector<double> newest;
  for (std::size_t slot = 0; slot < root->size(); ++slot) newest.push_back(times_at<D>(*root, slot).t_max);
  if (newest.empty()) return;
  const auto middle = newest.begin() + static_cast<std::ptrdiff_t>(newest.size() / 2);
  std::nth_element(newest.begin(), middle, newest.end());
  if (std::isfinite(*middle)) state.clock.set(*middle);
}

void free_all(Pages& pages, Interrupt& interrupt) {
  std::vector<Unread> all;
  if (pages.find_root() != 0) all.push_back(unread_root(pages));
  for (std::size_t i = 0; i < all.size(); ++i) {
    interrupt.check();
    const auto node = read(pages, all[i]);
    const NodeNumber number = all[i].number;
    for (std::size_t slot = 0; slot < (node->is_leaf() ? 0 : node->size()); ++slot)
      all.push_back(unread_child(number, *node, slot));
  }
  pages.set_root(0);
  Steps step(interrupt);
  for (const Unread& node : all) {
    step();
    pages.free(node.number);
  }
}

template <int D>
void bulk_load_tree(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                    Interrupt& interrupt) {
  if (!ids.empty()) TreeLoad<D>(state, interrupt).run(ids, records);
}

template <int D>
void bulk_load_tree(TreeState<D>& state, ObjectPartitions& partitions, Interrupt& interrupt) {
  TreeLoad<D>(state, interrupt).run(partitions);
}

template <int D>
std::vector<std::size_t> run_levels(const TreeState<D>& state, std::size_t objects, int root_level) {
  const std::size_t leaves = state.leaves_for(objects), capacity = state.pages.inner_capacity();
  const auto height = static_cast<std::size_t>(root_level);
  std::vector<std::size_t> levels = level_sizes(leaves, capacity);
  if (levels.size() > height + 1) return {};
  if (levels.size() >= height) return levels;
  // Its nodes are less full, so that it is as high as the others; but none has a single child.
  if (height > 32 || leaves < std::size_t{1} << (height - 1)) return {};
  levels.resize(height);
  for (std::size_t level = 1; level < height; ++level)
    levels[level] =
        std::max((levels[level - 1] + capacity - 1) / capacity, std::size_t{1} << (height - 1 - level));
  return levels;
}

template <int D>
std::vector<Branch<D>> pack_run(TreeState<D>& state, std::span<const std::int64_t> ids,
                                std::span<const double> records, std::vector<std::size_t> levels,
                                Interrupt& interrupt, std::span<const NodeNumber> old_leaves) {
  return TreeLoad<D>(state, interrupt, old_leaves).pack_branches(ids, records, std::move(levels));
}

#define FORESEE_OF_AXES(D)                                                                                   \
  template void start_clock<D>(TreeState<D>&);                                                               \
  template void start_clock<D>(TreeState<D>&, std::span<const double>);                                      \
  template void bulk_load_tree<D>(TreeState<D>&, std::span<const std::int64_t>, std::span<const double>,     \
                                  Interrupt&);                                                               \
  template void bulk_load_tree<D>(TreeState<D>&, ObjectPartitions&, Interrupt&);                             \
  template std::vector<std::size_t> run_levels<D>(const TreeState<D>&, std::size_t, int);                    \
  template std::vector<Branch<D>> pack_run<D>(TreeState<D>&, std::span<const std::int64_t>,                  \
                                              std::span<const double>, std::vector<std::size_t>, Interrupt&, \
                                              std::span<const NodeNumber>)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
