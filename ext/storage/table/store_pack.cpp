// Store: reload of the whole tree, for 'rebuild', 'optimize' and loads that change most of the table.
//
// If the objects exceed the memory for sorting (memory_budget.h), they wait in a temporary file
// (object_spill.h), partitioned by position and motion, and become leaves one partition at a time. The old
// nodes are read twice, first for the ids and a sample of the records. So nothing is written before
// everything was read and is sound. Memory besides the partitions: 12 bytes per object (packed_map.h).
#include <algorithm>
#include <unordered_set>

#include "base/interrupt_steps.h"
#include "storage/format/inner_node.h"
#include "storage/format/leaf_node.h"
#include "storage/nodes/object_spill.h"
#include "storage/table/record_sample.h"
#include "storage/table/store.h"
#include "storage/table/store_change.h"

namespace foresee {
namespace {

template <class Each>
void for_each_object(const LeafView& leaf, std::size_t record_size, Each each) {
  std::vector<std::int64_t> ids(static_cast<std::size_t>(leaf.count()));
  std::vector<double> records(ids.size() * record_size);
  leaf.copy_ids(ids.data());
  leaf.copy_records(records.data());
  for (std::size_t i = 0; i < ids.size(); ++i) each(ids[i], records.data() + i * record_size);
}

template <class Each>
void for_each_object(const Node& leaf, std::size_t record_size, Each each) {
  for (std::size_t i = 0; i < leaf.size(); ++i) each(leaf.keys[i], leaf.values.data() + i * record_size);
}

}  // namespace

/// Steps of a partitioned load: see() every object, divide(), add() every object again, write().
class Store::PartitionedLoad {
 public:
  PartitionedLoad(Store& store, Interrupt& interrupt)
      : store_(store),
        interrupt_(interrupt),
        record_size_(static_cast<std::size_t>(store.format_.at.size)),
        sample_(record_size_) {}

  void see(std::int64_t id, const double* record) {
    ids_.push_back(id);
    sample_.add(record);
  }

  /// Throws if an id was seen twice. `newest`: as in TprTree::divide().
  void divide(std::span<const double> newest) {
    store_.require_unique(ids_, interrupt_);
    const std::size_t limit = std::max<std::size_t>(1, store_.memory_->max_ordered());
    const std::size_t partitions = ids_.size() * store_.format_.record_size / limit + 1;
    division_ = store_.tree_->divide(sample_.records(), partitions, newest, interrupt_);
    spill_.emplace(store_.db_, store_.name_, record_size_, partitions, limit / 4);
  }

  void add(std::int64_t id, const double* record) {
    spill_->add(division_->partition_of(record), id, record);
  }

  /// Replaces the contents by the added objects. Requires: in a change.
  void write() {
    spill_->finish();
    store_.cache_.drop_nodes(true);
    store_.cache_.erase_everything();
    PackedMap map(std::move(ids_));
    store_.cache_.place_into(map);
    store_.tree_->bulk_load_partitions(*spill_, interrupt_);
    store_.cache_.write_packed_map(interrupt_);
  }

 private:
  Store& store_;
  Interrupt& interrupt_;
  std::size_t record_size_;
  std::vector<std::int64_t> ids_;
  RecordSample sample_;
  std::unique_ptr<SpacePartitioning> division_;
  std::optional<ObjectSpill> spill_;
};

void Store::rebuild(Interrupt& interrupt) {
  changes_.note_others();  // in a damaged table it may recover objects
  pack(interrupt);
  const OwnStatements own(*this);
  if (!has_auxiliaries()) return;
  flush();
  shadow_rows().match_auxiliaries_to_map();
}

void Store::optimize(Interrupt& interrupt) {
  const std::vector<std::string> faults = integrity_check(interrupt);
  if (!faults.empty()) throw StoreError(SQLITE_CORRUPT_VTAB, faults.front());
  pack(interrupt);
}

void Store::require_unique(std::vector<std::int64_t>& ids, Interrupt& interrupt) const {
  Steps step(interrupt);
  std::sort(ids.begin(), ids.end(), [&](std::int64_t a, std::int64_t b) { return step(), a < b; });
  const auto twice = std::adjacent_find(ids.begin(), ids.end(),
                                        [&](std::int64_t a, std::int64_t b) { return step(), a == b; });
  if (twice != ids.end()) damaged("object " + std::to_string(*twice) + " is in two leaves");
}

/// Reads every stored leaf, whether or not the tree refers to it. The contents of inner nodes are ignored.
bool Store::read_stored_leaves(Interrupt& interrupt, const std::function<bool(const LeafView&)>& use) {
  unsigned nodes = 0;
  bool goes_on = true;
  shadow_rows().read_all_nodes([&](std::int64_t number, std::span<const std::byte> blob) {
    if (++nodes % 16 == 0) interrupt.check();
    if (!goes_on || is_inner(format_, blob, number)) return;
    read_stored_leaf(number, blob, [&](const LeafView& leaf) { goes_on = use(leaf); });
  });
  return goes_on;
}

void Store::pack(Interrupt& interrupt) {
  start_change({});
  flush();
  const auto size = static_cast<std::size_t>(format_.at.size);
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  const bool fits = read_stored_leaves(interrupt, [&](const LeafView& leaf) {
    for_each_object(leaf, size, [&](std::int64_t id, const double* record) {
      ids.push_back(id);
      records.insert(records.end(), record, record + size);
    });
    return records.size() * sizeof(double) <= memory_->max_ordered();
  });
  if (!fits) {
    ids = {}, records = {};
    return pack_partitioned(interrupt);
  }
  std::vector<std::int64_t> sorted = ids;
  require_unique(sorted, interrupt);
  sorted = {};
  interrupt.check();
  AtomicChange atomic_change(*this);
  cache_.erase_everything();
  with_sound_tree([&] { tree_->bulk_load(ids, records, interrupt); });
  write_count(static_cast<std::int64_t>(ids.size()));
  if (forms_) {
    std::unordered_set<std::int64_t> used;
    for (std::size_t i = 0; i < records.size(); i += size) used.insert(form_of(records.data() + i));
    keep_only_forms(used);
  }
  atomic_change.done();
}

void Store::pack_partitioned(Interrupt& interrupt) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  with_sound_tree([&] {
    PartitionedLoad load(*this, interrupt);
    std::unordered_set<std::int64_t> used;
    std::int64_t objects = 0;
    const auto for_each = [&](auto use) {
      read_stored_leaves(interrupt,
                         [&](const LeafView& leaf) { return for_each_object(leaf, size, use), true; });
    };
    for_each([&](std::int64_t id, const double* record) { load.see(id, record), ++objects; });
    load.divide({});
    for_each([&](std::int64_t id, const double* record) {
      load.add(id, record);
      if (forms_) used.insert(form_of(record));
    });
    AtomicChange atomic_change(*this);
    load.write();
    write_count(objects);
    if (forms_) keep_only_forms(used);
    atomic_change.done();
  });
}

/// As reload(), for many objects. Requires: in a change.
void Store::load_partitioned(Interrupt& interrupt) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  PartitionedLoad load(*this, interrupt);
  std::size_t stored = 0, replaced = 0;
  bool all_are_new = false;  // no pending object replaces a stored one; known after one pass
  const auto for_each = [&](auto use) {
    stored = 0;
    const auto use_stored = [&](std::int64_t id, const double* record) {
      ++stored;
      if (!all_are_new && pending_.find(id))
        ++replaced;
      else
        use(id, record);
    };
    const auto use_leaf = [&](const auto& leaf) { for_each_object(leaf, size, use_stored); };
    read_leaves(interrupt, use_leaf, use_leaf);
    Steps step(interrupt);
    pending_.for_each(
        [&](std::int64_t id, std::span<const double> record) { step(), use(id, record.data()); });
  };
  for_each([&](std::int64_t id, const double* record) { load.see(id, record); });
  all_are_new = replaced == 0;
  expect_objects(stored);
  load.divide(pending_.all_records());
  for_each([&](std::int64_t id, const double* record) { load.add(id, record); });
  load.write();
}

std::int64_t Store::form_of(const double* record) const {
  return static_cast<std::int64_t>(record[static_cast<std::size_t>(format_.at.outline)]);
}

void Store::keep_only_forms(const std::unordered_set<std::int64_t>& used) {
  if (!cache_.has_snapshots()) forms_->keep_only(used);
}

}  // namespace foresee
