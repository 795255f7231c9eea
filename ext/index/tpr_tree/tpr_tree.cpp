#include "index/tpr_tree/tpr_tree.h"

#include "base/axes.h"
#include "base/interrupt_steps.h"
#include "index/tpr_tree/bulk_load/bulk_load.h"
#include "index/tpr_tree/bulk_load/leaf_order.h"
#include "index/tpr_tree/update/insertion.h"
#include "index/tpr_tree/update/merge.h"
#include "index/tpr_tree/update/rebalance.h"
#include "index/tpr_tree/update/removal.h"

namespace foresee {
namespace {

/// Fewer objects than these are merged one by one.
constexpr std::size_t few = 32;
/// The max number of objects merged at once, and the memory for the case that each of them is in another
/// leaf. During a merge, memory holds the leaves as they were and as they become.
constexpr std::size_t max_merged = 1 << 15, merge_memory = 64 << 20;
/// One of so many updates repacks around its leaf.
constexpr std::size_t between_repacks = 24;

template <int D>
class Tree final : public TprTree {
 public:
  Tree(Pages& pages, double horizon) : state_(pages, horizon) {}

  void insert(std::int64_t id, std::span<const double> record) override {
    state_.clock.observe(state_.reader.t(record.data()));
    insert_object(state_, NewObject<D>{id, record, Mover<D>(state_.reader, record.data())});
  }

  bool update(std::int64_t id, std::span<const double> record) override {
    const auto leaf = state_.pages.find_leaf(id);
    if (!leaf) return false;
    state_.clock.observe(state_.reader.t(record.data()));
    const NewObject<D> object{id, record, Mover<D>(state_.reader, record.data())};
    renew_stale_above(*leaf);
    const auto [slot, fits] = place_of(*leaf, id, object);
    if (fits) {
      overwrite(*leaf, slot, object);
    } else {
      const bool keeps_leaf = take_out(state_, *leaf, slot);
      insert_object(state_, object, keeps_leaf ? ancestor_containing(*leaf, object) : 0,
                    keeps_leaf ? *leaf : 0);
    }
    if (++updates_ % between_repacks == 0) repack_around(state_, leaf_of(id), updates_ / between_repacks);
    return true;
  }

  bool erase(std::int64_t id) override { return start_clock(state_), erase_object(state_, id); }

  bool replace(std::int64_t id, std::int64_t new_id, std::span<const double> record) override {
    const auto leaf = state_.pages.find_leaf(id);
    if (!leaf) return false;
    const NewObject<D> object{new_id, record, Mover<D>(state_.reader, record.data())};
    renew_stale_above(*leaf);
    const auto [slot, fits] = place_of(*leaf, id, object);
    if (!fits) return false;
    const bool was_outermost = is_outermost(state_, *leaf, slot, object);
    state_.clock.observe(object.mover.motion.t);
    state_.pages.modify(*leaf).keys[slot] = new_id;
    state_.pages.forget(id);
    state_.pages.place({&new_id, 1}, *leaf);
    overwrite(*leaf, slot, object);
    if (was_outermost) tighten_upward(state_, *leaf);
    return true;
  }

  void bulk_load(std::span<const std::int64_t> ids, std::span<const double> records,
                 Interrupt& interrupt) override {
    std::vector<std::int64_t> old_ids;
    std::vector<double> old_records;
    collect_objects(state_.pages, old_ids, old_records, interrupt);
    Steps step(interrupt);
    for (const std::int64_t id : old_ids) step(), state_.pages.forget(id);
    state_.clock = {};
    free_all(state_.pages, interrupt);
    load_all(ids, records, interrupt);
  }

  void merge(std::span<const std::int64_t> ids, std::span<const double> records,
             Interrupt& interrupt) override {
    if (ids.empty()) return;
    if (state_.pages.find_root() == 0) return load_all(ids, records, interrupt);
    const std::size_t size = state_.reader.record_size();
    if (ids.size() < few || state_.pages.read(state_.pages.find_root())->is_leaf()) {
      Steps step(interrupt);
      for (std::size_t i = 0; i < ids.size(); ++i) {
        step();
        const auto record = records.subspan(i * size, size);
        if (!update(ids[i], record)) insert(ids[i], record);
      }
      return;
    }
    observe_newest(records);
    const auto merge_some = [&](std::span<const std::int64_t> some, std::span<const double> theirs) {
      merge_objects(state_, some, theirs, interrupt);
      state_.pages.make_room();
    };
    const std::size_t portions = (ids.size() + merge_size() - 1) / merge_size();
    if (portions == 1) return merge_some(ids, records);
    const auto order = leaf_order(state_, records, {portions, 1}, {0, portions}, interrupt);
    for (std::size_t i = 0; i < portions; ++i) {
      const Node some = objects_at(part_of(order, i, portions), ids, records, size);
      merge_some(some.keys, some.values);
    }
  }

  bool arrive_in_place(std::span<const std::int64_t> ids, std::span<const double> records,
                       Interrupt& interrupt) override {
    return foresee::arrive_in_place(state_, ids, records, interrupt);
  }

  void erase_all(std::span<const std::int64_t> ids, std::size_t max_leaves, Interrupt& interrupt) override {
    start_clock(state_);
    erase_objects(state_, ids, max_leaves, interrupt);
  }

  void repack_dispersed(std::size_t changes, std::uint64_t draw) override {
    foresee::repack_dispersed(state_, changes, draw);
  }

  bool packs_new(std::size_t objects) override { return objects >= few && takes_runs(state_, objects); }

  void merge_new(std::span<const std::int64_t> ids, std::span<const double> records,
                 Interrupt& interrupt) override {
    if (!packs_new(ids.size())) return merge(ids, records, interrupt);
    observe_newest(records);
    const Remainder rest = merge_runs(state_, ids, records, interrupt);
    merge(rest.ids, rest.records, interrupt);
  }

  bool takes_run(std::size_t objects) override {
    return state_.pages.find_root() == 0 || !run_levels(state_, objects, root_level()).empty();
  }

  void add_run(std::span<const std::int64_t> ids, std::span<const double> records,
               Interrupt& interrupt) override {
    const NodeNumber root = state_.pages.find_root();
    if (root == 0) return load_all(ids, records, interrupt);
    observe_newest(records);
    const int level = root_level();
    const auto run = pack_run(state_, ids, records, run_levels(state_, ids.size(), level), interrupt);
    if (run.front().level > level) put_root_above(state_, root);
    for (const Branch<D>& branch : run) insert_branch(state_, branch);
  }

  void reload(std::span<const std::int64_t> ids, std::span<const double> records,
              Interrupt& interrupt) override {
    observe_newest(records);
    free_all(state_.pages, interrupt);
    load_all(ids, records, interrupt);
  }

  std::unique_ptr<SpacePartitioning> divide(std::span<const double> sample, std::size_t partitions,
                                            std::span<const double> newest, Interrupt& interrupt) override {
    if (newest.empty()) state_.clock = {};
    observe_newest(newest);
    return divide_space(state_, sample, partitions, interrupt);
  }

  void bulk_load_partitions(ObjectPartitions& partitions, Interrupt& interrupt) override {
    free_all(state_.pages, interrupt);
    bulk_load_tree(state_, partitions, interrupt);
    note_all_packed(state_);
  }

  void rebuild(Interrupt& interrupt) override {
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    collect_objects(state_.pages, ids, records, interrupt);
    free_all(state_.pages, interrupt);
    load_all(ids, records, interrupt);
  }

 private:
  void load_all(std::span<const std::int64_t> ids, std::span<const double> records, Interrupt& interrupt) {
    bulk_load_tree(state_, ids, records, interrupt);
    note_all_packed(state_);
  }

  int root_level() { return read(state_.pages, unread_root(state_.pages))->level; }

  /// Requires: the tree has the object.
  NodeNumber leaf_of(std::int64_t id) {
    const auto leaf = state_.pages.find_leaf(id);
    if (!leaf) throw BrokenTree("the map lacks an object of the tree");
    return *leaf;
  }

  /// The number of objects merged at once.
  std::size_t merge_size() const {
    const std::size_t leaf = state_.pages.leaf_capacity() * state_.reader.record_size() * sizeof(double);
    return std::clamp(merge_memory / leaf, few, max_merged);
  }

  /// Updates the clock from the last records, which were written last.
  void observe_newest(std::span<const double> records) {
    const std::size_t size = state_.reader.record_size(), all = records.size() / size;
    for (std::size_t i = all - std::min(all, WriteClock::memory); i < all; ++i)
      state_.clock.observe(state_.reader.t(records.data() + i * size));
  }

  static std::size_t slot_in_leaf(const Node& leaf, std::int64_t id) {
    if (!leaf.is_leaf()) throw BrokenTree("an object is not in a leaf of the tree");
    return slot_of(leaf, id);
  }

  struct Place {
    std::size_t slot;
    bool fits;  ///< the leaf's entry contains the new object
  };
  Place place_of(NodeNumber number, std::int64_t id, const NewObject<D>& object) {
    const auto leaf = state_.pages.read(number);
    const std::size_t slot = slot_in_leaf(*leaf, id);
    const auto parent = read_above(state_.pages, number, *leaf);
    return {slot, !parent || entry_contains(*parent, number, object)};
  }

  /// True if the child's entry would contain the object beneath it. Max t is ignored: it is cheap to update.
  static bool entry_contains(const Node& parent, NodeNumber child, const NewObject<D>& object) {
    return entry_without_newest<D>(parent, child).contains(object.entry(parent.epoch));
  }

  /// The lowest ancestor of this node whose entry contains the object; otherwise the root.
  NodeNumber ancestor_containing(NodeNumber number, const NewObject<D>& object) {
    auto node = state_.pages.read(number);
    auto parent = read_above(state_.pages, number, *node);
    for (;;) {
      number = node->parent, node = std::move(parent);
      if (!node) return number;
      parent = read_above(state_.pages, number, *node);
      if (!parent || entry_contains(*parent, number, object)) return number;
    }
  }

  void renew_stale_above(NodeNumber number) {
    for (;;) {
      const auto node = state_.pages.read(number);
      std::size_t slot;
      {
        const auto parent = read_above(state_.pages, number, *node);
        if (!parent) return;
        slot = slot_of(*parent, number);
      }
      if (!renew_if_stale(state_, node->parent, slot)) return;
      number = node->parent;
    }
  }

  /// The entries of higher levels contain the leaf's objects, but not all that the leaf's entry allows. So
  /// fit_upward() checks them too.
  void overwrite(NodeNumber leaf, std::size_t slot, const NewObject<D>& object) {
    double* place = state_.reader.record(state_.pages.modify(leaf), slot);
    const double t_before = state_.reader.t(place);
    const Kinds kinds_before = state_.reader.kinds(place);
    std::copy(object.record.begin(), object.record.end(), place);
    if (object.mover.motion.t != t_before) refresh_newest(state_, leaf);
    fit_upward(state_, leaf, object);
    if (object.mover.kinds != kinds_before) tighten_upward(state_, leaf);
  }

  TreeState<D> state_;
  std::size_t updates_ = 0;
};

}  // namespace

std::unique_ptr<TprTree> make_tpr_tree(Pages& pages, double horizon) {
  return with_axes(pages.layout().axes, [&]<int D>(Axes<D>) -> std::unique_ptr<TprTree> {
    return std::make_unique<Tree<D>>(pages, horizon);
  });
}

double read_newest_t(NodeSource& source) {
  if (source.find_root() == 0) return 0;
  const auto root = read(source, unread_root(source));
  return with_axes(source.layout().axes,
                   [&]<int D>(Axes<D>) { return times_of(*root, LeafReader<D>(source.layout())).t_max; });
}

}  // namespace foresee
