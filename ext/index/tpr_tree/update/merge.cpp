#include "index/tpr_tree/update/merge.h"

#include "base/repeatable_choice.h"
#include "index/tpr_tree/update/batch_descent.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/rebalance.h"
#include "index/tpr_tree/update/removal.h"

namespace foresee {
namespace {

/// The leaves of a parent are packed together once about this fraction of their objects has changed. A smaller one
/// gives better leaves and more writes.
constexpr double changed_when_packed = 0.4;

template <int D>
class Merge {
 public:
  Merge(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
        Interrupt& interrupt)
      : state_(state), ids_(ids), batch_(state, ids, records, interrupt), interrupt_(interrupt) {}

  void run() {
    const std::size_t levels = batch_.levels();
    old_leaves_ = state_.pages.leaves_of(ids_, interrupt_);
    write_reports();
    for (std::size_t level = 1; level + 1 < levels; ++level) rise(level);
    for (std::size_t level = levels; level-- > 1;) batch_.sink(level);
    settle_leaves();
    settle_inner_nodes();
  }

  /// An object and its leaf.
  using Found = std::pair<NodeNumber, std::int64_t>;

  /// Erases objects, sorted by leaf.
  void erase(std::span<const Found> found) {
    std::vector<std::int64_t> some;
    for (std::size_t first = 0, last; first < found.size(); first = last) {
      const NodeNumber number = found[first].first;
      some.clear();
      for (last = first; last < found.size() && found[last].first == number; ++last)
        some.push_back(found[last].second);
      visit_upward(number, *leaf_at(number));
      Node& leaf = state_.pages.modify(number);
      for (const std::int64_t id : some) {
        batch_.step();
        remove_slot(leaf, slot_of(leaf, id), state_.reader.record_size());
        state_.pages.forget(id);
      }
    }
    settle_inner_nodes();
  }

 private:
  using Visit = typename BatchDescent<D>::Visit;

  std::shared_ptr<const Node> leaf_at(NodeNumber number) {
    auto leaf = state_.pages.read(number);
    if (!leaf->is_leaf()) throw BrokenTree("an object is not in a leaf of the tree");
    return leaf;
  }

  void settle_inner_nodes() {
    for (std::size_t level = 1; level < batch_.levels(); ++level)
      for (auto& [number, visit] : batch_.at(level)) {
        batch_.step();
        const bool due = level == 1 && is_due(number, visit);
        if (due && pack_all_leaves(state_, number)) continue;
        even_out(state_, number, visit.children);
        if (due) renew_if_older(number);
      }
    even_out_root(state_);
  }

  void renew_if_older(NodeNumber parent) {
    const auto node = state_.pages.read(parent);
    if (node->size() > 0 && node->epoch != state_.epoch_for(*node)) renew_entries(state_, parent);
  }

  /// Nothing is stored about the changes since leaves were packed, so their share is the probability. A hash decides:
  /// the same merges give the same tree.
  bool is_due(NodeNumber parent, const Visit& visit) const {
    if (visit.changes == 0) return false;
    const std::uint64_t draw = hash_of(static_cast<std::uint64_t>(parent)) ^ hash_of(batch_.object(0).record);
    const auto objects = static_cast<double>(state_.pages.read(parent)->size() * state_.packed_size());
    return fraction_of(hash_of(draw)) * changed_when_packed * objects < static_cast<double>(visit.changes);
  }

  /// Visits a node and all its ancestors; returns the visit of its parent.
  Visit& visit_upward(NodeNumber number, const Node& node) {
    const auto parent = read_above(state_.pages, number, node);
    if (!parent || static_cast<std::size_t>(parent->level) >= batch_.levels())
      throw BrokenTree("an object is in a leaf that is too high or too low");
    auto& above = batch_.at(static_cast<std::size_t>(parent->level));
    if (!above.contains(node.parent)) visit_upward(node.parent, *parent);
    batch_.visit_below(node.parent, *parent, slot_of(*parent, number));
    return above.at(node.parent);
  }

  /// Overwrites the objects that keep their leaves; the others leave them.
  void write_reports() {
    std::vector<std::pair<NodeNumber, std::uint32_t>> found;
    found.reserve(ids_.size());
    Visit& root = batch_.root();
    for (std::uint32_t i = 0; i < ids_.size(); ++i) {
      if (old_leaves_[i] != 0)
        found.emplace_back(old_leaves_[i], i);
      else
        root.objects.push_back(i);
    }
    std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
      batch_.step();
      return a < b;
    });
    for (std::size_t first = 0, last; first < found.size(); first = last) {
      for (last = first; last < found.size() && found[last].first == found[first].first;) ++last;
      write_reports_of(found[first].first, std::span(found).subspan(first, last - first));
    }
  }

  void write_reports_of(NodeNumber number, std::span<const std::pair<NodeNumber, std::uint32_t>> reports) {
    Visit* parent;
    Entry<D> entry;
    double epoch;
    {
      const auto leaf = leaf_at(number);
      parent = &visit_upward(number, *leaf);
      parent->changes += reports.size();
      const auto above = state_.pages.read(leaf->parent);
      entry = entry_without_newest<D>(*above, number), epoch = above->epoch;
    }
    Node& leaf = state_.pages.modify(number);
    for (const auto& [home, i] : reports) {
      batch_.step();
      const NewObject<D> report = batch_.object(i);
      const std::size_t slot = slot_of(leaf, report.id), size = report.record.size();
      if (entry.contains(report.entry(epoch))) {
        std::copy(report.record.begin(), report.record.end(),
                  leaf.values.begin() + static_cast<std::ptrdiff_t>(slot * size));
      } else {
        remove_slot(leaf, slot, size);
        parent->objects.push_back(i);
      }
    }
  }

  /// Moves objects that a node of this level does not contain to the level above.
  void rise(std::size_t level) {
    for (auto& [number, visit] : batch_.at(level)) {
      if (visit.objects.empty()) continue;
      const auto above = state_.pages.read(visit.parent);
      const Entry<D> entry = entry_without_newest<D>(*above, number);
      const auto contained = [&](std::uint32_t i) {
        batch_.step();
        return entry.contains(batch_.object(i).entry(above->epoch));
      };
      const auto rising = std::stable_partition(visit.objects.begin(), visit.objects.end(), contained);
      auto& higher = batch_.at(level + 1).at(visit.parent).objects;
      higher.insert(higher.end(), rising, visit.objects.end());
      visit.objects.erase(rising, visit.objects.end());
    }
  }

  void settle_leaves() {
    std::vector<std::int64_t> arriving;
    for (auto& [number, visit] : batch_.at(0)) {
      if (visit.objects.empty()) continue;
      batch_.at(1).at(visit.parent).changes += visit.objects.size();
      Node& leaf = state_.pages.modify(number);
      arriving.clear();
      for (const std::uint32_t i : visit.objects) {
        batch_.step();
        const NewObject<D> added = batch_.object(i);
        leaf.keys.push_back(added.id);
        leaf.values.insert(leaf.values.end(), added.record.begin(), added.record.end());
        if (old_leaves_[i] != number) arriving.push_back(added.id);
      }
      state_.pages.place(arriving, number);
    }
  }

  TreeState<D>& state_;
  std::span<const std::int64_t> ids_;
  BatchDescent<D> batch_;
  Interrupt& interrupt_;
  std::vector<NodeNumber> old_leaves_;  ///< the old leaf of each object; 0: a new object
};

}  // namespace

template <int D>
void merge_objects(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                   Interrupt& interrupt) {
  Merge<D>(state, ids, records, interrupt).run();
}

namespace {

/// The objects with their leaves, sorted by leaf.
template <int D>
std::vector<typename Merge<D>::Found> find_by_leaf(TreeState<D>& state, std::span<const std::int64_t> ids,
                                                   Interrupt& interrupt) {
  const std::vector<NodeNumber> leaves = state.pages.leaves_of(ids, interrupt);
  std::vector<typename Merge<D>::Found> found;
  found.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (leaves[i] == 0) throw BrokenTree("the map lacks an object of the tree");
    found.emplace_back(leaves[i], ids[i]);
  }
  Steps step(interrupt);
  std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    step();
    return a < b;
  });
  return found;
}

}  // namespace

template <int D>
void erase_objects(TreeState<D>& state, std::span<const std::int64_t> ids, std::size_t max_leaves,
                   Interrupt& interrupt) {
  constexpr std::size_t few = 32;
  Steps step(interrupt);
  const auto erase_one_by_one = [&](std::span<const std::int64_t> some) {
    for (const std::int64_t id : some) {
      step();
      if (!erase_object(state, id)) throw BrokenTree("the map lacks an object of the tree");
    }
  };
  if (ids.size() < few) return erase_one_by_one(ids);
  const auto all = find_by_leaf(state, ids, interrupt);
  std::vector<std::int64_t> some;
  for (std::size_t first = 0, last; first < all.size(); first = last) {
    std::size_t leaves = 0;
    for (last = first; last < all.size(); ++last) {
      leaves += last == first || all[last].first != all[last - 1].first;
      if (leaves > max_leaves) break;
    }
    some.clear();
    for (std::size_t i = first; i < last; ++i) some.push_back(all[i].second);
    if (state.pages.read(state.pages.find_root())->is_leaf()) {
      erase_one_by_one(some);
    } else {
      // Objects of a later portion may have got other leaves.
      const auto found = last - first == all.size() ? all : find_by_leaf(state, some, interrupt);
      Merge<D>(state, {}, {}, interrupt).erase(found);
    }
    state.pages.make_room();
  }
}

#define FORESEE_OF_AXES(D)                                                                              \
  template void merge_objects<D>(TreeState<D>&, std::span<const std::int64_t>, std::span<const double>, \
                                 Interrupt&);                                                           \
  template void erase_objects<D>(TreeState<D>&, std::span<const std::int64_t>, std::size_t, Interrupt&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
