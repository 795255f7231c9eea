#include "index/tpr_tree/repack.h"

#include <cmath>

#include "index/tpr_tree/choose.h"
#include "index/tpr_tree/grow.h"
#include "index/tpr_tree/leaf_pack.h"
#include "index/tpr_tree/order.h"
#include "index/tpr_tree/shrink.h"

namespace foresee::index {
namespace {

/// Room that is left in a leaf, so that the next writes do not split it.
constexpr double fill = 0.85;
/// How much dearer to visit than even ones leaves must look for a try; just bulk loaded: 1.0 to 1.05.
constexpr double loose = 1.2;
/// How much cheaper the new leaves must be.
constexpr double gain = 0.8;

/// The leaves beneath one or two nodes, before and after.
template <int D>
class Repack {
 public:
  Repack(TreeState<D>& state, std::vector<NodeNumber> parents)
      : state_(state),
        now_(state.clock.now()),
        cost_(state.cost(now_)),
        parents_(std::move(parents)),
        pack_(state) {
    for (const NodeNumber parent : parents_) read_entries(*state.pages.read(parent));
  }

  /// By what the nodes say: would leaves of even size that share their extent be far cheaper to visit?
  bool is_loose() const {
    Bounds<D> all = Bounds<D>::nothing();
    for (const Entry<D>& entry : before_) all.include(entry.bounds);
    const auto leaves = static_cast<double>(before_.size());
    all.x_upper -= (all.x_upper - all.x_lower) * (1 - std::pow(leaves, -1.0 / D));
    const double query = 0.5 * cost_.mean_width(all);
    return total(before_, query) > loose * leaves * cost_(all, query);
  }

  /// False if it would not pay.
  bool run() {
    before_.clear();
    for (const NodeNumber parent : parents_) {
      const auto node = state_.pages.read(parent);
      for (std::size_t slot = 0; slot < node->size(); ++slot) {
        const auto leaf = read_below(state_.pages, parent, *node, slot);
        before_.push_back(summary(*leaf, state_.reader, now_));
        pack_.add(node->keys[slot], *leaf);
      }
    }
    arrange();
    double width = 0;
    for (const Entry<D>& entry : after_) width += cost_.mean_width(entry.bounds);
    const double query = 0.5 * width / static_cast<double>(after_.size());
    if (!(total(after_, query) < gain * total(before_, query))) return false;
    write();
    return true;
  }

 private:
  void read_entries(const Node& parent) {
    for (std::size_t slot = 0; slot < parent.size(); ++slot)
      before_.push_back({times_at<D>(parent, slot), carried(bounds_at<D>(parent, slot), parent.epoch, now_)});
  }

  void arrange() {
    const auto roomy = static_cast<std::size_t>(fill * static_cast<double>(state_.pages.leaf_capacity()));
    const std::size_t needed = (pack_.objects() + roomy - 1) / roomy;
    const std::size_t least = std::min(before_.size(), parents_.size() * state_.least_size(1));
    pack_.arrange(std::clamp(needed, least, before_.size()), parents_.size());
    after_ = pack_.summaries(now_);
  }

  double total(const std::vector<Entry<D>>& entries, double query) const {
    double sum = 0;
    for (const Entry<D>& entry : entries) sum += cost_(entry.bounds, query);
    return sum;
  }

  void write() {
    for (std::size_t p = 0, i = 0; p < parents_.size(); ++p) {
      Node& parent = state_.pages.modify(parents_[p]);
      parent.epoch = now_;
      parent.keys.clear(), parent.values.clear();
      for (const std::size_t last = first_child(p + 1, parents_.size(), after_.size()); i < last; ++i)
        add_entry(parent, pack_.write(i, parents_[p]), after_[i]);
    }
    pack_.free_rest();
  }

  TreeState<D>& state_;
  const double now_;
  VisitCost<D> cost_;
  std::vector<NodeNumber> parents_;
  LeafPack<D> pack_;
  std::vector<Entry<D>> before_, after_;
};

/// Entries for nodes that hold other leaves than before, and all their siblings', at the clock's time.
template <int D>
void renew_above(TreeState<D>& state, NodeNumber above, std::span<const NodeNumber> changed) {
  Node& node = state.pages.modify(above);
  for (const NodeNumber number : changed)
    set_entry(node, slot_of(node, number), Entry<D>{{}, Bounds<D>::everything()});
  renew_entries(state, above);
  tighten_upward(state, above);
}

}  // namespace

template <int D>
void repack_around(TreeState<D>& state, NodeNumber leaf) {
  std::vector<NodeNumber> parents;
  NodeNumber above_number;
  {
    const auto node = state.pages.read(leaf);
    if (!node->is_leaf()) throw BrokenTree("an object is not in a leaf of the tree");
    const auto parent = read_above(state.pages, leaf, *node);
    if (!parent) return;
    parents.push_back(node->parent);
    above_number = parent->parent;
    if (const auto above = read_above(state.pages, node->parent, *parent)) {
      const std::size_t sibling = closest_sibling(state, *above, node->parent);
      read_below(state.pages, above_number, *above, sibling);
      if (above->keys[sibling] != node->parent) parents.push_back(above->keys[sibling]);
    }
  }
  Repack<D> repack(state, parents);
  if (repack.is_loose() && repack.run() && above_number != 0) renew_above<D>(state, above_number, parents);
}

template void repack_around<1>(TreeState<1>&, NodeNumber);
template void repack_around<2>(TreeState<2>&, NodeNumber);
template void repack_around<3>(TreeState<3>&, NodeNumber);

}  // namespace foresee::index
