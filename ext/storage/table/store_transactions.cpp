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
  store->count_.stored = 0;
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
  store->count_.stored = store->shadow_rows().read_objects();
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
      share_(*memory_, *this),
      cache_(format_, name_, share_),
      tree_(make_tpr_tree(cache_, declaration_.horizon)),
      pending_(std::make_shared<PendingObjects>(static_cast<std::size_t>(format_.at.size))),
      in_transaction_(is_new),
      is_new_(is_new),
      table_at_begin_(name_.table) {
  cache_.connect(*shadow_rows_);
  if (is_stored_apart(declaration_.layout.shape))
    forms_ =
        std::make_unique<StoredForms>(shadow_tables(db_, name_, declaration_), declaration_.layout.shape);
}

ShadowRows& Store::shadow_rows() {
  if (gone_)
    throw StoreError(SQLITE_SCHEMA, name_.table + ": the table is dropped; prepare the statement again");
  if (torn_) throw StoreError(SQLITE_ABORT, name_.table + ": a write failed half-way; roll back");
  return *shadow_rows_;
}

NodeCache& Store::nodes() {
  shadow_rows();
  return cache_;
}

void Store::damaged(const std::string& what) const {
  throw StoreError(SQLITE_CORRUPT_VTAB, name_.table + ": " + what);
}

std::shared_ptr<NodeSource> Store::take_snapshot() {
  revalidate_cache();
  merge_pending();
  return std::make_shared<TreeSnapshot>(shared_from_this());
}

// --- transactions

/// From here on no other connection can write, so savepoints are marks of the stored state. Damage is not
/// reported here, but where it is read: DROP TABLE starts a transaction too.
void Store::revalidate_at_begin() try { revalidate_cache(); } catch (const StoreError& error) {
  const int code = error.code & 0xff;
  if (code != SQLITE_ERROR && code != SQLITE_CORRUPT) throw;
  cache_.forget_all();
  cached_stamp_.reset();
}

void Store::begin() {
  if (in_transaction_ || gone_) return;
  revalidate_at_begin();
  table_at_begin_ = name_.table;
  cache_.begin();
  in_transaction_ = true;
}

// Several watches may call this in one COMMIT. With a savepoint open the cache reports changes that are
// already written: then nothing is left to do.
void Store::sync() {
  if (gone_) return;
  shadow_rows();
  if (synced_position_ == undo_position_ && !(has_unwritten() && was_rolled_back())) return;
  flush();
  synced_position_ = undo_position_;
}

void Store::end_transaction() noexcept {
  give_up_savepoints(0);
  in_transaction_ = is_new_ = writing_ = stamped_ = torn_ = false;
  ++transaction_;
  largest_ = {};
  own_stamp_.reset();
  pending_->clear();
  object_changes_.clear();
  keeps_changes_ = wants_changes_;
  changes_unknown_ = false;
  note_memory();
}

// A table that was created after a savepoint gets no callback when SQLite rolls back to it. Then the stamp
// that this transaction wrote is gone, or all its tables are.
bool Store::was_rolled_back() {
  if (!own_stamp_) return false;
  try {
    return shadow_rows().read_stamp() != own_stamp_;
  } catch (const StoreError& error) {
    if ((error.code & 0xff) != SQLITE_ERROR) throw;
    return true;
  }
}

void Store::close() noexcept {
  undo_transaction();
  cache_.forget_all();
  end_transaction();
  gone_ = true;
}

void Store::commit() {
  if (gone_) return;
  if (writing_ && !stamped_) cached_stamp_.reset();  // a rollback to a savepoint removed the new stamp
  cache_.commit();
  end_transaction();
}

void Store::rollback() {
  if (own_statements_ > 0) {
    rolled_back_ = true;
    return;
  }
  if (gone_) return;
  if (is_new_) return close();
  set_table_name(table_at_begin_);
  undo_transaction();
  watches_known_ = false;
  if (writing_) cached_stamp_ = stamp_before_;
  end_transaction();
  differs_from_version_ = false;
  version_changes_ = 0;  // with the restored stamp: the contents of that commit
}

void Store::undo_transaction() noexcept {
  cache_.roll_back();
  if (forms_) forms_->forget_texts();
  if (writing_) count_ = count_before_;
  origin_ = {};
  if (!savepoints_.empty()) pending_ = savepoints_.front().pending;
  pending_->clear();
  object_changes_.clear();
  give_up_savepoints(0);
}

// --- savepoints

void Store::savepoint(int level) {
  if (own_statements_ > 0 || gone_) return;
  shadow_rows();
  // Two virtual tables that share this store both get the callback.
  if (!savepoints_.empty() && savepoints_.back().level >= level) return;
  // Reserve first, by doubling: once the mark is set nothing may throw.
  if (savepoints_.size() == savepoints_.capacity())
    savepoints_.reserve(std::max<std::size_t>(8, 2 * savepoints_.size()));
  std::string table = name_.table;
  savepoints_.push_back({level, cache_.set_mark(false), cache_.map_position(), pending_, pending_->position(),
                         object_changes_.position(), largest_, count_, origin_, undo_position_, own_stamp_,
                         std::move(table), has_unwritten() || object_changes_.count() > 0});
}

void Store::give_up_savepoints(std::size_t from) noexcept {
  while (savepoints_.size() > from) {
    cache_.give_up(savepoints_.back().mark);
    savepoints_.pop_back();
  }
}

/// The number of savepoints older than this level.
std::size_t Store::savepoints_before(int level) const noexcept {
  const auto first = std::lower_bound(savepoints_.begin(), savepoints_.end(), level,
                                      [](const StoreSavepoint& one, int other) { return one.level < other; });
  return static_cast<std::size_t>(first - savepoints_.begin());
}

void Store::release(int level) {
  if (own_statements_ > 0 || gone_) return;
  const std::size_t kept = savepoints_before(level);
  give_up_savepoints(kept);
  if (kept == 0) pending_->forget_past();
}

void Store::rollback_to(int level) {
  if (own_statements_ > 0 || gone_) return;
  const std::size_t first = savepoints_before(level);
  const bool is_marked = first < savepoints_.size() && savepoints_[first].level == level;
  if (is_marked || first > 0) {
    if (first < savepoints_.size()) restore(savepoints_[first]);
    give_up_savepoints(is_marked ? first + 1 : first);
    return;
  }
  // No mark is that old. Either the mark could not be set, and its statement failed before it changed
  // anything; or the table joined the transaction after that savepoint.
  if (own_stamp_ && !was_rolled_back()) return;
  if (is_new_ && own_stamp_) return close();
  set_table_name(table_at_begin_);
  undo_transaction();
  own_stamp_.reset();
  watches_known_ = false;
  note_change();
  stamped_ = torn_ = false;
  largest_ = {};
}

void Store::restore(const StoreSavepoint& savepoint) {
  if (savepoint.undo_position == undo_position_ && !torn_) return;
  torn_ = true;  // until it is done
  watches_known_ = false;
  set_table_name(savepoint.table);
  own_stamp_ = savepoint.own_stamp;
  cache_.restore(savepoint.mark, savepoint.map_position);
  if (forms_) forms_->forget_texts();
  pending_ = savepoint.pending;
  pending_->rewind(savepoint.pending_position);
  object_changes_.rewind(savepoint.changes_position);
  largest_ = savepoint.largest;
  count_ = savepoint.count;
  origin_ = savepoint.origin;
  stamped_ = torn_ = false;
  note_change();
}

// --- the table itself

void Store::rename(const std::string& new_table) {
  flush();
  const OwnStatements own(*this);
  shadow_tables(db_, name_, declaration_).rename(new_table);
  set_table_name(new_table);
  note_change();
}

void Store::set_table_name(const std::string& table) {
  if (name_.table == table) return;
  name_.table = table;
  const ShadowTables tables = shadow_tables(db_, name_, declaration_);
  shadow_rows_ = std::make_unique<ShadowRows>(tables, declaration_);
  cache_.connect(*shadow_rows_);
  if (forms_) forms_->connect(tables);
  remember_open_store(db_, name_, shared_from_this());
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
