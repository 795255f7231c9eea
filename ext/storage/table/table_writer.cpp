#include "storage/table/table_writer.h"

#include <cstring>
#include <limits>

#include "database/statement.h"
#include "format/leaf_node.h"

namespace foresee {

void TableWriter::require_sound(std::span<const double> record) const {
  if (const char* fault = record_fault(format_, record.data())) throw Error(name_.table + ": " + fault);
}

void TableWriter::start_change(std::span<const double> record) {
  if (!record.empty()) require_sound(record);
  // A rollback inside the statement, by a function that it calls, takes the table out of the transaction: no
  // COMMIT would reach what is written from here on.
  if (!transaction_.is_open())
    throw StoreError(SQLITE_ABORT_ROLLBACK, name_.table + ": a rollback ended this statement; run it again");
  transaction_.require_usable();
  if (!version().written_here()) {
    revalidate_cache();
    load_watch_names();
    if (!watch_names_->value().empty()) changes_.start_keeping();
  }
  note_memory();
  if (memory_->too_much_waits()) memory_->write_out();
  if (version().written_here()) return;
  const OwnStatements own(transaction_);
  write_new_stamp();
  version().note_change();  // the contents count as another version from here on, also if this change fails
}

const LargestId& TableWriter::read_largest() {
  // Unknown: no object was added in this transaction.
  if (!totals_->largest.known)
    totals_.change().largest = {true, !tree_.has_unwritten(), shadow_rows().tree().map().read_largest_id()};
  return totals_->largest;
}

std::int64_t TableWriter::find_next_id() {
  transaction_.resolve_doubt();
  if (!totals_->largest.known || !totals_->largest.exact) {
    flush();
    totals_.change().largest = {};
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

StoredForms::Known TableWriter::find_or_add_form(std::string_view text, const StoredForms::Reader& read) {
  start_change({});
  const OwnStatements own(transaction_);
  return forms_->find_or_add(text, read);
}

// --- changes of a transaction

void TableWriter::load_watch_names() {
  if (!watch_names_.get()) watch_names_.change() = shadow_rows().read_watches();
}

void TableWriter::log_change(std::int64_t id) {
  if (changes_.lacks(id)) changes_.add(id);
}

// Bit for bit: 0 and -0 differ.
void TableWriter::log_update(std::int64_t id, std::span<const double> record) {
  if (!changes_.lacks(id)) return;
  const std::optional<std::vector<double>> before = read(id);
  if (!before || std::memcmp(before->data(), record.data(), record.size_bytes()) != 0) changes_.add(id);
}

void TableWriter::for_each_change(const std::function<void(std::int64_t, std::span<const double>)>& each) {
  transaction_.resolve_doubt();
  for (const std::int64_t id : changes_.ids()) each(id, read(id).value_or(std::vector<double>()));
}

std::optional<std::int64_t> TableWriter::stamp_before_changes() {
  return changes_.are_complete() ? stamp_at_begin() : std::nullopt;
}

std::optional<std::int64_t> TableWriter::stamp_at_begin() {
  return version().written_here() ? version().before_first_change() : shadow_rows().read_stamp();
}

// --- changes

void TableWriter::add(std::int64_t id, std::span<const double> record) {
  const std::optional<std::int64_t> last = read_largest().id;
  Totals& totals = totals_.change();
  tree_.insert(id, record);  // all that follows cannot fail
  ++totals.count.added;
  if (!last || *last <= id) totals.largest = {true, true, id};
}

void TableWriter::throw_missing(std::int64_t id) const {
  throw StoreError(SQLITE_ERROR, name_.table + ": there is no object " + std::to_string(id));
}

void TableWriter::remove(std::int64_t id) {
  if (!tree_.erase(id)) throw_missing(id);
  Totals& totals = totals_.change();
  --totals.count.added;
  if (totals.largest.id == id) totals.largest.exact = false;
}

std::span<const double> TableWriter::change_plans(StoredPlans::Change& plans, std::int64_t id,
                                                  std::int64_t new_id, std::span<const double> record,
                                                  const Plan* plan) {
  const std::optional<std::vector<double>> before = read(id);
  if (!before) throw_missing(id);
  if (new_id != id) plans.remove(new_id, read(new_id).value_or(std::vector<double>()));
  if (!plan) {
    record = plans.keep(id, new_id, *before, record);
  } else {
    std::optional<StoredPlans::Head> old;
    if (has_plan(format_.at, before->data())) old = plans_->head_of(id, before->data());
    record = plans.add(new_id, record, *plan, old ? &*old : nullptr);
  }
  require_sound(record);
  return record;
}

void TableWriter::insert(std::int64_t id, std::span<const double> record,
                         std::span<sqlite3_value*> auxiliaries, const std::optional<LatLon>& origin,
                         const Plan* plan) {
  start_change(record);
  // For most tables add() is the whole change, and atomic itself.
  if (!plans_ && !origin && !changes_.lacks(id) && !has_auxiliaries() && totals_->largest.known) {
    add(id, record);
    return version().note_change();
  }
  AtomicChange atomic_change(transaction_);
  std::optional<StoredPlans::Change> plans;
  if (plans_) {
    plans.emplace(*plans_, transaction_.rolled_back_within());
    record = plan ? plans->add(id, record, *plan) : plans->keep(id, id, {}, record);
    if (plan) require_sound(record);
  }
  if (origin) origin_.change() = {.known = true, .unwritten = true, .value = origin};
  log_change(id);
  add(id, record);
  if (plans) plans->write();
  if (has_auxiliaries()) shadow_rows().insert_auxiliaries(id, auxiliaries);
  if (plans) plans->finish();
  atomic_change.done();
}

void TableWriter::update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
                         std::span<sqlite3_value*> auxiliaries, const Plan* plan) {
  start_change(record);
  AtomicChange atomic_change(transaction_);
  std::optional<StoredPlans::Change> plans;
  if (plans_)
    record =
        change_plans(plans.emplace(*plans_, transaction_.rolled_back_within()), id, new_id, record, plan);
  tree_.reporting_damage([&] {
    if (new_id != id) {
      log_change(id);
      log_change(new_id);
      if (contains(new_id)) remove(new_id);
      remove(id);
      add(new_id, record);
    } else {
      log_update(id, record);
      if (!tree_.update(id, record)) throw_missing(id);
    }
  });
  if (plans) plans->write();
  if (has_auxiliaries()) shadow_rows().update_auxiliaries(id, new_id, auxiliaries);
  if (plans) plans->finish();
  atomic_change.done();
}

void TableWriter::erase(std::int64_t id) {
  start_change({});
  AtomicChange atomic_change(transaction_);
  std::optional<StoredPlans::Change> plans;
  if (plans_)
    plans.emplace(*plans_, transaction_.rolled_back_within())
        .remove(id, read(id).value_or(std::vector<double>()));
  tree_.reporting_damage([&] {
    log_change(id);
    remove(id);
  });
  if (has_auxiliaries()) shadow_rows().erase_auxiliaries(id);
  if (plans) plans->finish();
  atomic_change.done();
}

}  // namespace foresee
