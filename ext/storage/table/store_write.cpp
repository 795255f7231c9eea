// Store: inserts, updates and deletes, each atomic; and the writing of all changes to the shadow rows.
#include <cstring>
#include <limits>

#include "storage/format/leaf_node.h"
#include "storage/rows/statement.h"
#include "storage/table/store.h"
#include "storage/table/store_change.h"

namespace foresee {

void Store::require_sound(std::span<const double> record) const {
  if (const char* fault = record_fault(format_, record.data())) throw Error(name_.table + ": " + fault);
}

void Store::note_memory() noexcept {
  tree_.note_memory();
  if (plans_) plans_->tree().note_memory();
}

// Memory is freed here, before the change: so the change stays atomic.
void Store::start_change(std::span<const double> record) {
  if (!record.empty()) require_sound(record);
  // A rollback inside the statement, by a function that it calls, takes the table out of the transaction: no
  // COMMIT would reach what is written from here on.
  if (!journal_.is_open())
    throw StoreError(SQLITE_ABORT_ROLLBACK, name_.table + ": a rollback ended this statement; run it again");
  require_usable();
  if (!version_.written_here()) {
    revalidate_cache();
    load_watch_names();
    if (!watch_names_->value().empty()) changes_.start_keeping();
  }
  note_memory();
  if (memory_->too_much_waits()) memory_->write_out();
  if (version_.written_here()) return;
  const OwnStatements own(*this);
  write_new_stamp();
  version_.note_change();  // the contents count as another version from here on, also if this change fails
}

void Store::write_new_stamp(bool same_contents) {
  std::int64_t stamp;
  sqlite3_randomness(sizeof stamp, &stamp);
  shadow_rows().write_stamp(stamp);
  version_.wrote(stamp, same_contents);
}

const LargestId& Store::read_largest() {
  // Unknown: no object was added in this transaction.
  if (!totals_->largest.known)
    totals_.change().largest = {true, !tree_.has_unwritten(), shadow_rows().tree().map().read_largest_id()};
  return totals_->largest;
}

std::int64_t Store::find_next_id() {
  resolve_doubt();
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

StoredForms::Known Store::find_or_add_form(std::string_view text, const StoredForms::Reader& read) {
  start_change({});
  const OwnStatements own(*this);
  return forms_->find_or_add(text, read);
}

// --- changes of a transaction

void Store::log_before_change(std::int64_t id) {
  if (!changes_.are_kept() || changes_.knows(id)) return;
  const std::optional<std::vector<double>> before = read(id);
  changes_.add(id, before ? std::span<const double>(*before) : std::span<const double>());
}

void Store::for_each_change(const std::function<void(std::int64_t, std::span<const double>)>& each) {
  resolve_doubt();
  changes_.for_each([&](std::int64_t id, std::span<const double> before) {
    const std::vector<double> after = read(id).value_or(std::vector<double>());
    // Bit for bit: 0 and -0 differ. (An empty record has no bytes to compare.)
    const bool equal = before.size() == after.size() &&
                       (before.empty() || std::memcmp(before.data(), after.data(), before.size_bytes()) == 0);
    if (!equal) each(id, after);
  });
}

// --- changes

void Store::add(std::int64_t id, std::span<const double> record) {
  const std::optional<std::int64_t> last = read_largest().id;
  Totals& totals = totals_.change();
  tree_.insert(id, record);  // all that follows cannot fail
  ++totals.count.added;
  if (!last || *last <= id) totals.largest = {true, true, id};
}

void Store::throw_missing(std::int64_t id) const {
  throw StoreError(SQLITE_ERROR, name_.table + ": there is no object " + std::to_string(id));
}

void Store::remove(std::int64_t id) {
  if (!tree_.erase(id)) throw_missing(id);
  Totals& totals = totals_.change();
  --totals.count.added;
  if (totals.largest.id == id) totals.largest.exact = false;
}

void Store::insert(std::int64_t id, std::span<const double> record, std::span<sqlite3_value*> auxiliaries,
                   const std::optional<LatLon>& origin, const Plan* plan) {
  start_change(record);
  // For most tables add() is the whole change, and atomic itself.
  if (!plans_ && !origin && !changes_.are_kept() && !has_auxiliaries() && totals_->largest.known) {
    add(id, record);
    return version_.note_change();
  }
  AtomicChange atomic_change(*this);
  std::optional<StoredPlans::Change> plans;
  if (plans_) {
    plans.emplace(*plans_, rolled_back_);
    record = plan ? plans->add(id, record, *plan) : plans->keep(id, id, {}, record);
    if (plan) require_sound(record);
  }
  if (origin) origin_.change() = {.known = true, .unwritten = true, .value = origin};
  if (changes_.are_kept() && !changes_.knows(id)) changes_.add(id, {});
  add(id, record);
  if (plans) plans->write();
  if (has_auxiliaries()) shadow_rows().insert_auxiliaries(id, auxiliaries);
  if (plans) plans->finish();
  atomic_change.done();
}

void Store::update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
                   std::span<sqlite3_value*> auxiliaries, const Plan* plan) {
  start_change(record);
  AtomicChange atomic_change(*this);
  std::optional<StoredPlans::Change> plans;
  if (plans_) record = change_plans(plans.emplace(*plans_, rolled_back_), id, new_id, record, plan);
  tree_.reporting_damage([&] {
    log_before_change(id);
    if (new_id != id) {
      log_before_change(new_id);
      if (contains(new_id)) remove(new_id);
      remove(id);
      add(new_id, record);
    } else if (!tree_.update(id, record)) {
      throw_missing(id);
    }
  });
  if (plans) plans->write();
  if (has_auxiliaries()) shadow_rows().update_auxiliaries(id, new_id, auxiliaries);
  if (plans) plans->finish();
  atomic_change.done();
}

void Store::erase(std::int64_t id) {
  start_change({});
  AtomicChange atomic_change(*this);
  std::optional<StoredPlans::Change> plans;
  if (plans_) plans.emplace(*plans_, rolled_back_).remove(id, read(id).value_or(std::vector<double>()));
  tree_.reporting_damage([&] {
    log_before_change(id);
    remove(id);
  });
  if (has_auxiliaries()) shadow_rows().erase_auxiliaries(id);
  if (plans) plans->finish();
  atomic_change.done();
}

// --- from memory to the rows

bool Store::has_unwritten() const {
  return tree_.has_unwritten() || (plans_ && plans_->tree().has_unwritten()) || totals_->count.added != 0 ||
         origin_->unwritten;
}

bool Store::must_merge(TreeStore::Reason reason) const {
  return tree_.must_merge(reason) || (plans_ && plans_->tree().must_merge(reason));
}

void Store::merge_pending(TreeStore::Reason reason) {
  if (!must_merge(reason)) return;
  require_usable();
  StatementInterrupt interrupt(db_);
  AtomicChange atomic_change(*this);
  tree_.merge_pending(reason, interrupt);
  if (plans_) plans_->tree().merge_pending(reason, interrupt);
  atomic_change.done_with_same_contents();
}

// The new stamp comes last: a connection that reads uncommitted rows (shared cache) has seen the first stamp with
// other rows.
void Store::flush(TreeStore::Reason reason) {
  if (!has_unwritten() && !must_merge(reason)) return;
  if (was_rolled_back()) return restart_transaction();
  merge_pending(reason);
  require_usable();
  const OwnStatements own(*this);
  StatementInterrupt interrupt(db_);
  tree_.write(interrupt);
  if (plans_) plans_->tree().write(interrupt);
  if (totals_->count.added != 0) {
    const std::optional<std::int64_t> sum = totals_->count.sum();
    write_count(sum ? *sum : shadow_rows().tree().map().count_ids());
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
  count.stored = objects;
  count.added = 0;
}

void Store::write_out() {
  if (own_statements_ == 0 && !torn_) flush(TreeStore::Reason::memory);
  note_memory();
}

}  // namespace foresee
