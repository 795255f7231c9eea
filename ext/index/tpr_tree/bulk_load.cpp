#include "index/tpr_tree/bulk_load.h"

#include "base/steps.h"
#include "index/tpr_tree/order.h"

namespace foresee::index {
namespace {

/// The time that most objects have reached: the upper quartile of a sample of their t.
template <int D>
double typical_t(const LeafReader<D>& reader, std::span<const double> records) {
  const std::size_t count = records.size() / reader.record_size(), step = count / 1024 + 1;
  std::vector<double> sample;
  for (std::size_t i = 0; i < count; i += step)
    sample.push_back(reader.t(records.data() + i * reader.record_size()));
  const auto quartile = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() * 3 / 4);
  std::nth_element(sample.begin(), quartile, sample.end());
  return *quartile;
}

template <int D>
class TreeLoad {
 public:
  TreeLoad(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
           Interrupt& interrupt)
      : state_(state), ids_(ids), records_(records), interrupt_(interrupt) {}

  void run() {
    if (!state_.clock.runs()) state_.clock.set(typical_t(state_.reader, records_));
    const auto levels = level_sizes(state_.leaves_for(ids_.size()), state_.pages.inner_capacity());
    const auto order = leaf_order(state_, records_, levels, interrupt_);
    for (const std::size_t nodes : levels) {
      auto& numbers = numbers_.emplace_back(nodes);
      for (NodeNumber& number : numbers) number = state_.pages.allocate();
    }
    write_leaves(order);
    for (std::size_t level = 1; level < levels.size(); ++level) write_inner_nodes(level);
    state_.pages.set_root(numbers_.back()[0]);
  }

 private:
  void write_leaves(const std::vector<std::uint32_t>& order) {
    const std::size_t leaves = numbers_[0].size(), size = state_.reader.record_size();
    for (std::size_t i = 0; i < leaves; ++i) {
      Node leaf = objects_at(part_of(order, i, leaves), ids_, records_, size);
      state_.pages.place(leaf.keys, numbers_[0][i]);
      finish(std::move(leaf), 0, i);
    }
  }

  void write_inner_nodes(std::size_t level) {
    const std::vector<Entry<D>> below = std::exchange(entries_, {});
    const std::size_t nodes = numbers_[level].size();
    for (std::size_t i = 0; i < nodes; ++i) {
      Node inner;
      inner.level = static_cast<int>(level);
      inner.epoch = state_.clock.now();
      const std::size_t last = first_child(i + 1, nodes, below.size());
      for (std::size_t child = first_child(i, nodes, below.size()); child < last; ++child)
        add_entry(inner, numbers_[level - 1][child], below[child]);
      finish(std::move(inner), level, i);
    }
  }

  /// Writes node i of a level and keeps its entry for the level above.
  void finish(Node node, std::size_t level, std::size_t i) {
    if (i % 64 == 0) interrupt_.check();
    entries_.push_back(summary(node, state_.reader, state_.clock.now()));
    if (level + 1 < numbers_.size()) {
      const std::size_t nodes = numbers_[level].size(), parents = numbers_[level + 1].size();
      std::size_t parent = i * parents / nodes;
      while (first_child(parent + 1, parents, nodes) <= i) ++parent;
      node.parent = numbers_[level + 1][parent];
    }
    state_.pages.put(numbers_[level][i], std::move(node));
  }

  TreeState<D>& state_;
  std::span<const std::int64_t> ids_;
  std::span<const double> records_;
  Interrupt& interrupt_;
  std::vector<std::vector<NodeNumber>> numbers_;  ///< by level
  std::vector<Entry<D>> entries_;                 ///< of the nodes written last, for the level above
};

}  // namespace

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
  for (const Unread& node : all) step(), pages.free(node.number);
}

template <int D>
void bulk_load_tree(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                    Interrupt& interrupt) {
  if (!ids.empty()) TreeLoad<D>(state, ids, records, interrupt).run();
}

template void bulk_load_tree<1>(TreeState<1>&, std::span<const std::int64_t>, std::span<const double>,
                                Interrupt&);
template void bulk_load_tree<2>(TreeState<2>&, std::span<const std::int64_t>, std::span<const double>,
                                Interrupt&);
template void bulk_load_tree<3>(TreeState<3>&, std::span<const std::int64_t>, std::span<const double>,
                                Interrupt&);

}  // namespace foresee::index
