// Store: creation, opening, transactions, savepoints, renaming and dropping.
#include <algorithm>
#include <utility>

#include "storage/table/open_stores.h"
#include "storage/table/store.h"
#include "storage/table/store_change.h"
#include "storage/table/tree_snapshot.h"

namespace foresee {
namespace {

bool same_columns(const Declaration& a, const Declaration& b) {
  return a.horizon == b.horizon && a.frame == b.frame && describe_columns(a) == describe_columns(b);
}

}  // namespace

std::shared_ptr<Store> Store::create(sqlite3* db, const std::string& schema, const std::string& table,
                                     const Declaration& declaration) {
  const QualifiedName name{schema, table};
  const NodeFormat format = create_shadow_tables(db, name, declaration);
  // A rollback to a savepoint has removed a table of this name, which SQLite does not report.
  if (const auto other = find_open_store(db, name); other && other->is_named(table)) other->close();
  auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, declaration), declaration);
  auto store =
      std::make_shared<Store>(db, name, declaration, format, std::move(rows), true, memory_budget_of(db));
  store->totals_.change().count.stored = 0;
  remember_open_store(db, name, store);
  return store;
}

std::shared_ptr<Store> Store::open(sqlite3* db, const std::string& schema, const std::string& table,
                                   const Declaration& declaration) {
  const QualifiedName name{schema, table};
  const ShadowTables tables = shadow_tables(db, name, declaration);
  auto rows = std::make_unique<ShadowRows>(tables, declaration);
  const NodeFormat format = read_node_format(tables, rows->meta(), declaration);
  if (auto live = find_open_store(db, name);
      live && live->is_named(name.table) && same_columns(live->declaration(), declaration) &&
      live->format().node_size == format.node_size && !live->was_rolled_back())
    return live;
  auto store =
      std::make_shared<Store>(db, name, declaration, format, std::move(rows), false, memory_budget_of(db));
  store->totals_.change().count.stored = store->shadow_rows().read_objects();
  remember_open_store(db, name, store);
  return store;
}

// SQLite creates a table inside a write transaction and does not call begin() for it.
Store::Store(sqlite3* db, QualifiedName name, Declaration declaration, const NodeFormat& format,
             std::unique_ptr<ShadowRows> rows, bool is_new, std::shared_ptr<MemoryBudget> memory)
    : db_(db),
      name_(std::move(name)),
      declaration_(std::move(declaration)),
      format_(format),
      shadow_rows_(std::move(rows)),
      memory_(std::move(memory)),
      tree_(db, format_, name_, declaration_.horizon, journal_, *memory_, [this] { write_out(); }),
      is_new_(is_new) {
  tree_.connect(shadow_rows_->tree());
  if (is_stored_apart(declaration_.layout.shape))
    forms_ = std::make_unique<StoredForms>(journal_, shadow_tables(db_, name_, declaration_),
                                           declaration_.layout.shape);
  if (declaration_.layout.has_plan) {
    plans_ = std::make_unique<StoredPlans>(db_, format_, name_, declaration_.horizon, journal_, *memory_,
                                           [this] { write_out(); });
    plans_->connect(shadow_tables(db_, name_, declaration_), shadow_rows_->meta());
  }
  if (is_new_) journal_.begin();
}

void Store::forget_nodes() {
  tree_.nodes().forget_all();
  if (plans_) plans_->tree().nodes().forget_all();
  if (forms_) forms_->forget_all();
}

Store& Store::require_usable() {
  if (gone_)
    throw StoreError(SQLITE_SCHEMA, name_.table + ": the table is dropped; prepare the statement again");
  resolve_doubt();
  if (torn_) throw StoreError(SQLITE_ABORT, name_.table + ": a write failed half-way; roll back");
  return *this;
}

void Store::damaged(const std::string& what) const {
  throw StoreError(SQLITE_CORRUPT_VTAB, name_.table + ": " + what);
}

std::shared_ptr<NodeSource> Store::take_snapshot(StatementReadState* statement_state) {
  revalidate_cache(statement_state);
  merge_pending();
  return std::make_shared<TreeSnapshot>(shared_from_this());
}

// --- transactions

/// From here on no other connection can write, so savepoints are marks of the stored state. Damage is not
/// reported here, but where it is read: DROP TABLE starts a transaction too.
void Store::revalidate_at_begin() try { revalidate_cache(); } catch (const StoreError& error) {
  const int code = error.code & 0xff;
  if (code != SQLITE_ERROR && code != SQLITE_CORRUPT) throw;
  forget_nodes();
  version_.forget();
}

void Store::begin() {
  if (journal_.is_open() || gone_) return;
  revalidate_at_begin();
  journal_.begin();
  version_.begin();
}

void Store::sync() {
  if (gone_) return;
  require_usable();
  flush(TreeStore::Reason::commit);
}

void Store::end_transaction(Journal::Ended how) {
  give_up_savepoints(0);
  journal_.end(how);
  version_.end(how);
  totals_.change().largest = {};
  torn_ = in_doubt_ = false;
  note_memory();
}

// A table that was created after a savepoint gets no callback when SQLite rolls back to it. Then the stamp
// that this transaction wrote is gone, or all its tables are. A torn store answers too.
bool Store::was_rolled_back() {
  if (!version_.written_here()) return false;
  if (gone_) return true;
  try {
    return shadow_rows_->read_stamp() != version_.seen();
  } catch (const StoreError& error) {
    if ((error.code & 0xff) != SQLITE_ERROR) throw;
    return true;
  }
}

void Store::close() {
  end_transaction(Journal::Ended::rolled_back);
  forget_nodes();
  gone_ = true;
}

void Store::commit() {
  if (gone_) return;
  if (plans_ && version_.written_here() && version_.seen())
    plans_->note_commit(version_.before_first_change(), *version_.seen());
  end_transaction(Journal::Ended::committed);
  is_new_ = false;
}

void Store::rollback() {
  if (own_statements_ > 0) {
    rolled_back_ = true;
    return;
  }
  if (gone_) return;
  if (is_new_) return close();
  end_transaction(Journal::Ended::rolled_back);
  use_table_name(table_.get());
}

void Store::restart_transaction() {
  end_transaction(Journal::Ended::rolled_back);
  journal_.begin();
  version_.note_change();
  use_table_name(table_.get());
}

// --- savepoints

void Store::savepoint(int level) {
  if (own_statements_ > 0 || gone_ || !journal_.is_open()) return;
  require_usable();
  // Two virtual tables that share this store both get the callback.
  if (!savepoints_.empty() && savepoints_.back().level >= level) return;
  // Reserve first, by doubling: once the mark is set nothing may throw.
  if (savepoints_.size() == savepoints_.capacity())
    savepoints_.reserve(std::max<std::size_t>(8, 2 * savepoints_.size()));
  const bool unwritten = has_unwritten() || changes_.count() > 0;
  savepoints_.push_back({level, journal_.set_mark(), unwritten});
}

void Store::give_up_savepoints(std::size_t from) noexcept {
  if (from >= savepoints_.size()) return;
  journal_.forget(savepoints_[from].mark);
  savepoints_.resize(from);
}

/// The number of savepoints older than this level.
std::size_t Store::savepoints_before(int level) const noexcept {
  const auto first = std::lower_bound(savepoints_.begin(), savepoints_.end(), level,
                                      [](const Savepoint& one, int other) { return one.level < other; });
  return static_cast<std::size_t>(first - savepoints_.begin());
}

void Store::release(int level) {
  if (own_statements_ > 0 || gone_ || !journal_.is_open()) return;
  give_up_savepoints(savepoints_before(level));
}

// SQLite has rolled the rows back already, and calls no further table once one fails. So this does not fail: a store
// that cannot follow is torn; one that cannot read the stamp is in doubt until it is used.
void Store::rollback_to(int level) noexcept {
  if (own_statements_ > 0 || gone_ || !journal_.is_open()) return;
  const std::size_t first = savepoints_before(level);
  const bool is_marked = first < savepoints_.size() && savepoints_[first].level == level;
  try {
    if (is_marked || first > 0) {
      if (first < savepoints_.size()) restore(savepoints_[first]);
    } else if (level < 0 || !version_.written_here()) {  // -1: the savepoint that has opened the transaction
      undo_transaction();
    } else {
      // No mark is that old. Either the mark could not be set, and its statement failed before it changed
      // anything; or the table joined the transaction after that savepoint.
      in_doubt_ = true;
      resolve_doubt();
    }
  } catch (...) {
    torn_ |= !in_doubt_;
  }
  if (is_marked || first > 0) give_up_savepoints(is_marked ? first + 1 : first);
}

void Store::resolve_doubt() {
  if (!in_doubt_) return;
  if (was_rolled_back()) undo_transaction();
  in_doubt_ = false;
}

void Store::undo_transaction() {
  if (is_new_ && version_.written_here()) return close();
  restart_transaction();
}

void Store::restore(const Savepoint& savepoint) {
  const bool was_torn = std::exchange(torn_, true);  // until it is done
  if (!journal_.is_whole()) return;
  if (journal_.rewind(savepoint.mark) || was_torn) {
    use_table_name(table_.get());
    version_.note_change();
  }
  torn_ = false;
}

// --- the table itself

void Store::rename(const std::string& new_table) {
  flush();
  const OwnStatements own(*this);
  shadow_tables(db_, name_, declaration_).rename(new_table);
  table_.change() = new_table;
  use_table_name(new_table);
  version_.note_change();
}

void Store::use_table_name(const std::string& table) {
  if (name_.table == table) return;
  const QualifiedName name{name_.schema, table};
  const ShadowTables tables = shadow_tables(db_, name, declaration_);
  shadow_rows_ = std::make_unique<ShadowRows>(tables, declaration_);
  tree_.connect(shadow_rows_->tree());
  if (forms_) forms_->connect(tables);
  if (plans_) plans_->connect(tables, shadow_rows_->meta());
  remember_open_store(db_, name, shared_from_this());
  name_ = name;  // last: if anything has thrown, the next call repeats it all
}

// Unwritten changes from before a savepoint would be lost with this object, although SQLite may roll back to
// there. The newest mark belongs to the DROP itself.
void Store::drop() {
  for (std::size_t i = 0; i + 1 < savepoints_.size(); ++i)
    if (savepoints_[i].has_unwritten)
      throw StoreError(SQLITE_LOCKED,
                       name_.table +
                           " has changes from before an open savepoint: RELEASE it, or COMMIT, "
                           "and then DROP the table");
  const OwnStatements own(*this);
  shadow_tables(db_, name_, declaration_).drop();
  close();
}

}  // namespace foresee
