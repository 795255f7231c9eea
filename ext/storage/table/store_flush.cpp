// Store: moves pending objects into the tree, and writes all changes to the shadow rows.
#include <algorithm>

#include "base/interrupt_steps.h"
#include "storage/format/inner_node.h"
#include "storage/format/leaf_node.h"
#include "storage/rows/statement.h"
#include "storage/table/store.h"
#include "storage/table/store_change.h"

namespace foresee {
namespace {

// Per object a bulk load of the whole table costs a twentieth of an insert, and it gives a better tree.
constexpr double min_reload_ratio = 1.0 / 8;

}  // namespace

bool Store::has_unwritten() const {
  return cache_.has_unwritten() || pending_.count() > 0 || totals_->count.added != 0 || origin_->unwritten;
}

void Store::merge_pending() {
  if (pending_.count() == 0) return;
  shadow_rows();
  StatementInterrupt interrupt(db_);
  AtomicChange atomic_change(*this);
  with_sound_tree([&] {
    const double pending = static_cast<double>(pending_.count()), stored = estimate_objects(cache_);
    const double bytes = (pending + stored) * static_cast<double>(format_.record_size);
    if (stored > 0 && pending <= stored * min_reload_ratio)
      merge_into_tree(interrupt);
    else if (stored > 0 && bytes > static_cast<double>(memory_->max_ordered()))
      load_partitioned(interrupt);
    else
      reload(interrupt);
  });
  pending_.take_all();
  atomic_change.done_with_same_contents();
}

void Store::merge_into_tree(Interrupt& interrupt) {
  if (!pending_.has_holes()) return tree_->merge(pending_.all_ids(), pending_.all_records(), interrupt);
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  append_pending(ids, records);
  tree_->merge(ids, records, interrupt);
}

void Store::reload(Interrupt& interrupt) {
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  collect_objects(cache_, ids, records, interrupt);
  expect_objects(ids.size());
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
  ids.resize(kept), records.resize(kept * size);
  append_pending(ids, records);
  tree_->reload(ids, records, interrupt);
}

void Store::append_pending(std::vector<std::int64_t>& ids, std::vector<double>& records) const {
  ids.reserve(ids.size() + pending_.count());
  records.reserve(records.size() + pending_.count() * static_cast<std::size_t>(format_.at.size));
  pending_.for_each([&](std::int64_t id, std::span<const double> record) {
    ids.push_back(id);
    records.insert(records.end(), record.begin(), record.end());
  });
}

// If it fails half-way the rest stays unwritten; writing the same again is harmless. The new stamp comes
// last: a connection that reads uncommitted rows (shared cache) has seen the first stamp with other rows.
void Store::flush() {
  if (!has_unwritten()) return;
  if (was_rolled_back()) return restart_transaction();
  merge_pending();
  shadow_rows();
  const OwnStatements own(*this);
  StatementInterrupt interrupt(db_);
  with_sound_tree([&] { cache_.write(interrupt); });
  if (totals_->count.added != 0) {
    const std::optional<std::int64_t> sum = totals_->count.sum();
    write_count(sum ? *sum : shadow_rows().map().count_ids());
  }
  if (origin_->unwritten) {
    shadow_rows().meta().write("origin", origin_text(*origin_->value));
    origin_.change().unwritten = false;
  }
  write_new_stamp(true);
}

void Store::write_count(std::int64_t objects) {
  shadow_rows().write_objects(objects);
  ObjectCount& count = totals_.change().count;
  count.stored = objects, count.added = 0;
}

void Store::note_memory() noexcept {
  share_.hold_pending(pending_.memory());
  cache_.note_memory();
}

/// Called by another table of the connection, or by a trigger on a shadow table during a change.
void Store::write_out() {
  if (own_statements_ == 0 && !torn_) flush();
  note_memory();
}

}  // namespace foresee
