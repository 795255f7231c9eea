// Store: inserts, updates and deletes; each is atomic.
#include <cstring>
#include <limits>

#include "storage/format/leaf_node.h"
#include "storage/table/store.h"
#include "storage/table/store_change.h"

namespace foresee {
// Memory is freed here, before the change: so the change stays atomic.
void Store::start_change(std::span<const double> record) {
  if (!record.empty())
    if (const char* fault = record_fault(format_, record.data())) throw Error(name_.table + ": " + fault);
  // A rollback inside the statement, by a function that it calls, takes the table out of the transaction: no
  // COMMIT would reach what is written from here on.
  if (!in_transaction_)
    throw StoreError(SQLITE_ABORT_ROLLBACK, name_.table + ": a rollback ended this statement; run it again");
  shadow_rows();
  if (!writing_) {
    revalidate_cache();
    stamp_before_ = cached_stamp_;
    count_before_ = count_;
    load_watches();
    keeps_changes_ |= !watches_.empty();
  }
  note_memory();
  if (memory_->too_much_waits()) memory_->write_out();
  if (stamped_) return;
  const OwnStatements own(*this);
  write_new_stamp();
  differs_from_version_ = true;  // even if this change fails: the stamp is not committed yet
  ++undo_position_;
}

void Store::write_new_stamp() {
  std::int64_t stamp;
  sqlite3_randomness(sizeof stamp, &stamp);
  shadow_rows().write_stamp(stamp);
  cached_stamp_ = own_stamp_ = stamp;
  writing_ = stamped_ = true;
}

const LargestId& Store::read_largest() {
  // Unknown: no object was added in this transaction.
  if (!largest_.known) largest_ = {true, !cache_.has_unwritten(), shadow_rows().map().read_largest_id()};
  return largest_;
}

std::int64_t Store::find_next_id() {
  if (!largest_.known || !largest_.exact) {
    flush();
    largest_ = {};
  }
  const std::optional<std::int64_t> last = read_largest().id;
  if (!last) return 1;
  if (*last < std::numeric_limits<std::int64_t>::max()) return *last + 1;
  for (int attempt = 0; attempt < 100; ++attempt) {  // as SQLite does
    std::int64_t id;
    sqlite3_randomness(sizeof id, &id);
    id &= std::numeric_limits<std::int64_t>::max() >> 1;
    if (!contains(++id)) return id;
  }
  throw StoreError(SQLITE_FULL, name_.table + ": there is no id left");
}

StoredForms::Known Store::find_or_add_form(std::string_view text, const StoredForms::Reader& read) {
  start_change({});
  const OwnStatements own(*this);
  ++undo_position_;  // a row may be written, which only a rollback removes
  return forms_->find_or_add(text, read);
}

// --- changes of a transaction

void Store::keep_changes(bool wanted) {
  wants_changes_ = wanted;
  if (wanted || !in_transaction_) keeps_changes_ = wanted;
}

void Store::log_before_change(std::int64_t id) {
  if (!keeps_changes_ || object_changes_.knows(id)) return;
  const std::optional<std::vector<double>> before = read(id);
  object_changes_.add(id, before ? std::span<const double>(*before) : std::span<const double>());
}

void Store::for_each_change(
    const std::function<void(std::int64_t, std::span<const double>, std::span<const double>)>& each) {
  object_changes_.for_each([&](std::int64_t id, std::span<const double> before) {
    const std::vector<double> after = read(id).value_or(std::vector<double>());
    // Bit for bit: 0 and -0 differ. (An empty record has no bytes to compare.)
    const bool equal = before.size() == after.size() &&
                       (before.empty() || std::memcmp(before.data(), after.data(), before.size_bytes()) == 0);
    if (!equal) each(id, before, after);
  });
}

// --- changes

void Store::add(std::int64_t id, std::span<const double> record) {
  const std::optional<std::int64_t> last = read_largest().id;
  pending_->add(id, record);
  ++count_.added;
  if (!last || *last <= id) largest_ = {true, true, id};
}

void Store::throw_missing(std::int64_t id) const {
  throw StoreError(SQLITE_ERROR, name_.table + ": there is no object " + std::to_string(id));
}

void Store::remove(std::int64_t id) {
  const bool is_pending = pending_->find(id) != nullptr;
  if (is_pending) pending_->erase(id);
  if (!tree_->erase(id) && !is_pending) throw_missing(id);
  --count_.added;
  if (largest_.id == id) largest_.exact = false;
}

void Store::insert(std::int64_t id, std::span<const double> record, std::span<sqlite3_value*> auxiliaries,
                   const std::optional<LatLon>& origin) {
  start_change(record);
  AtomicChange atomic_change(*this);
  if (origin) origin_ = {.known = true, .unwritten = true, .value = origin};
  if (keeps_changes_ && !object_changes_.knows(id)) object_changes_.add(id, {});
  add(id, record);
  if (has_auxiliaries()) shadow_rows().insert_auxiliaries(id, auxiliaries);
  atomic_change.done();
}

void Store::update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
                   std::span<sqlite3_value*> auxiliaries) {
  start_change(record);
  AtomicChange atomic_change(*this);
  with_sound_tree([&] {
    log_before_change(id);
    log_before_change(new_id);
    if (new_id != id) {
      if (contains(new_id)) remove(new_id);
      remove(id);
      add(new_id, record);
    } else if (pending_->find(id)) {
      pending_->replace(id, record);
    } else {
      if (!nodes().find_record(id)) throw_missing(id);
      pending_->add(id, record);
    }
  });
  if (has_auxiliaries()) shadow_rows().update_auxiliaries(id, new_id, auxiliaries);
  atomic_change.done();
}

void Store::erase(std::int64_t id) {
  start_change({});
  AtomicChange atomic_change(*this);
  with_sound_tree([&] {
    log_before_change(id);
    remove(id);
  });
  if (has_auxiliaries()) shadow_rows().erase_auxiliaries(id);
  atomic_change.done();
}

}  // namespace foresee
