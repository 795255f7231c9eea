// TreeStore: load of a whole tree, for 'rebuild', 'optimize' and changes of most of the table.
//
// Objects that exceed the memory for sorting become leaves one partition of object_spill.h at a time. Memory besides
// it: 12 bytes per object (placed_ids.h).
#include <algorithm>

#include "base/interrupt_steps.h"
#include "base/record_sample.h"
#include "database/sqlite_api.h"
#include "format/inner_node.h"
#include "format/leaf_node.h"
#include "storage/nodes/object_spill.h"
#include "storage/tree/tree_store.h"

namespace foresee {
namespace {

template <class Each>
void for_each_object(const Node& leaf, std::size_t record_size, Each each) {
  for (std::size_t i = 0; i < leaf.size(); ++i) each(leaf.keys[i], leaf.values.data() + i * record_size);
}

}  // namespace

void TreeStore::require_unique(std::vector<std::int64_t>& ids, Interrupt& interrupt) const {
  Steps step(interrupt);
  std::sort(ids.begin(), ids.end(), [&](std::int64_t a, std::int64_t b) {
    step();
    return a < b;
  });
  const auto twice = std::adjacent_find(ids.begin(), ids.end(), [&](std::int64_t a, std::int64_t b) {
    step();
    return a == b;
  });
  if (twice != ids.end()) throw_damaged(name_, "object " + std::to_string(*twice) + " is in two leaves");
}

// --- of objects that can be read again

TreeStore::Replacement::Replacement(TreeStore& tree, Interrupt& interrupt)
    : tree_(tree), interrupt_(interrupt) {}

TreeStore::Replacement::~Replacement() = default;

void TreeStore::Replacement::read(const EachObject& for_each) {
  if (!read_into_memory(for_each)) partition(for_each, {});
}

bool TreeStore::Replacement::read_into_memory(const EachObject& for_each) {
  const auto size = static_cast<std::size_t>(tree_.format_.at.size);
  bool fits = true;
  for_each([&](std::int64_t id, const double* record) {
    ids_.push_back(id);
    records_.insert(records_.end(), record, record + size);
    return fits = records_.size() * sizeof(double) <= tree_.share_.budget().max_ordered();
  });
  if (!fits) {
    ids_ = {};
    records_ = {};
    return false;
  }
  std::vector<std::int64_t> sorted = ids_;
  tree_.require_unique(sorted, interrupt_);
  interrupt_.check();
  objects_ = ids_.size();
  return true;
}

void TreeStore::Replacement::partition(const EachObject& for_each, std::span<const double> newest) {
  const auto use_all = [&](auto use) {
    for_each([&](std::int64_t id, const double* record) {
      use(id, record);
      return true;
    });
  };
  const auto size = static_cast<std::size_t>(tree_.format_.at.size);
  std::vector<std::int64_t> ids;
  RecordSample sample(size);
  use_all([&](std::int64_t id, const double* record) {
    ids.push_back(id);
    sample.add(record);
  });
  tree_.require_unique(ids, interrupt_);
  for (const std::int64_t id : ids) seen_.add(id);
  objects_ = ids.size();
  std::vector<std::int64_t>().swap(ids);
  const std::size_t limit = std::max<std::size_t>(1, tree_.share_.budget().max_ordered());
  const std::size_t partitions = objects_ * tree_.format_.record_size / limit + 1;
  const auto division = tree_.reporting_damage(
      [&] { return tree_.tree_->divide(sample.records(), partitions, newest, interrupt_); });
  spill_ = std::make_unique<ObjectSpill>(tree_.db_, tree_.name_, size, partitions, limit / 4);
  use_all([&](std::int64_t id, const double* record) {
    spill_->add(division->partition_of(record), id, record);
  });
  spill_->finish();
}

void TreeStore::Replacement::write() {
  tree_.reporting_damage([&] {
    NodeCache& cache = tree_.cache_;
    if (!spill_) {
      cache.erase_everything();
      return tree_.tree_->bulk_load(ids_, records_, interrupt_);
    }
    cache.drop_nodes(true);
    cache.erase_everything();
    cache.start_placing_new(objects_);
    tree_.tree_->bulk_load_partitions(*spill_, interrupt_);
    cache.write_places(seen_, interrupt_);
  });
  tree_.note_packed();
}

TreeStore::Rebuild::Rebuild(TreeStore& tree, Interrupt& interrupt)
    : tree_(tree), interrupt_(interrupt), replacement_(tree, interrupt) {
  replacement_.read([this](const UseObject& use) { read_leaves(use); });
  if (!damaged_nodes_.empty()) require_leaves_of_map();
}

void TreeStore::Rebuild::read_leaves(const UseObject& use) {
  const NodeFormat& format = tree_.format_;
  const auto size = static_cast<std::size_t>(format.at.size);
  Node leaf;
  unsigned nodes = 0;
  bool goes_on = true;
  forms_.clear();
  damaged_nodes_.clear();
  tree_.rows_->nodes().read_all([&](std::int64_t number, std::span<const std::byte> blob) {
    if (++nodes % 16 == 0) interrupt_.check();
    if (is_inner(format, blob, number)) return true;
    if (const char* fault = tree_.cache_.fault(number, blob)) {
      damaged_nodes_.emplace(number, fault);
      return true;
    }
    decode_leaf(format, blob, leaf);
    for_each_object(leaf, size, [&](std::int64_t id, const double* record) {
      goes_on = goes_on && use(id, record);
      if (is_stored_apart(format.layout.shape))
        forms_.insert(static_cast<std::int64_t>(record[format.at.outline]));
    });
    return goes_on;
  });
}

// A damaged node is no leaf if the map sends no object to it, and the other leaves have all objects of the map.
void TreeStore::Rebuild::require_leaves_of_map() {
  std::size_t objects = 0;
  const auto damaged = [&](const auto& node) {
    throw_damaged(tree_.name_, "node " + std::to_string(node.first) + " is damaged: " + node.second);
  };
  Steps step(interrupt_);
  tree_.rows_->map().read([&](std::int64_t, std::int64_t leaf) {
    step();
    ++objects;
    if (const auto found = damaged_nodes_.find(leaf); found != damaged_nodes_.end()) damaged(*found);
  });
  if (objects != this->objects()) damaged(*damaged_nodes_.begin());
}

// --- with pending objects

void TreeStore::reload(Interrupt& interrupt) {
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  collect_objects(cache_, ids, records, interrupt);
  require_as_many(ids.size());
  if (ids.empty() && !pending_.has_holes())
    return tree_->bulk_load(pending_.all_ids(), pending_.all_records(), interrupt);
  const auto size = static_cast<std::size_t>(format_.at.size);
  std::size_t kept = 0;
  Steps step(interrupt);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    step();
    if (pending_.find(ids[i])) continue;
    if (kept != i) {
      ids[kept] = ids[i];
      std::copy_n(records.begin() + static_cast<std::ptrdiff_t>(i * size), size,
                  records.begin() + static_cast<std::ptrdiff_t>(kept * size));
    }
    ++kept;
  }
  ids.resize(kept);
  records.resize(kept * size);
  append_pending(ids, records);
  tree_->reload(ids, records, interrupt);
}

void TreeStore::append_pending(std::vector<std::int64_t>& ids, std::vector<double>& records) const {
  ids.reserve(ids.size() + pending_.count());
  records.reserve(records.size() + pending_.count() * static_cast<std::size_t>(format_.at.size));
  pending_.for_each([&](std::int64_t id, std::span<const double> record) {
    ids.push_back(id);
    records.insert(records.end(), record.begin(), record.end());
  });
}

void TreeStore::load_partitioned(Interrupt& interrupt) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  const bool all_are_new = !pending_updates_.get();
  std::size_t stored = 0;
  const EachObject for_each = [&](const UseObject& use) {
    bool goes_on = true;
    stored = 0;
    read_leaves(interrupt, [&](const Node& leaf) {
      stored += leaf.size();
      for_each_object(leaf, size, [&](std::int64_t id, const double* record) {
        if (all_are_new || !pending_.find(id)) goes_on = goes_on && use(id, record);
      });
    });
    Steps step(interrupt);
    pending_.for_each([&](std::int64_t id, std::span<const double> record) {
      step();
      goes_on = goes_on && use(id, record.data());
    });
  };
  Replacement load(*this, interrupt);
  load.partition(for_each, pending_.all_records());
  require_as_many(stored);
  load.write();
}

}  // namespace foresee
