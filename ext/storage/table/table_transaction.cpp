#include "storage/table/table_transaction.h"

#include <algorithm>
#include <utility>

namespace foresee {

TableTransaction::TableTransaction(sqlite3* db, ChangingTable& table, const std::string& name, bool is_new)
    : db_(db), table_(table), name_(journal_, name), is_new_(is_new) {
  if (is_new_) journal_.begin();
}

void TableTransaction::settle() {
  if (gone_)
    throw StoreError(SQLITE_SCHEMA, name_.get() + ": the table is dropped; prepare the statement again");
  resolve_doubt();
  if (torn_) throw StoreError(SQLITE_ABORT, name_.get() + ": a write failed half-way; roll back");
}

// --- begin and end

void TableTransaction::begin() {
  if (journal_.is_open() || gone_) return;
  table_.revalidate_at_begin();
  journal_.begin();
  version_.begin();
}

void TableTransaction::end(Journal::Ended how) {
  give_up_savepoints(0);
  journal_.end(how);
  version_.end(how);
  torn_ = in_doubt_ = false;
  table_.note_end();
}

void TableTransaction::commit() {
  if (gone_) return;
  end(Journal::Ended::committed);
  is_new_ = false;
}

void TableTransaction::rollback() {
  if (own_statements_ > 0) {
    rolled_back_ = true;
    return;
  }
  if (gone_) return;
  if (is_new_) return close();
  end(Journal::Ended::rolled_back);
  in_doubt_ = true;  // if this fails, the next access repeats it
  table_.use_name(name_.get());
  in_doubt_ = false;
}

void TableTransaction::close() {
  end(Journal::Ended::rolled_back);
  table_.forget_rows();
  gone_ = true;
}

void TableTransaction::restart() {
  end(Journal::Ended::rolled_back);
  journal_.begin();
  version_.note_change();
  table_.use_name(name_.get());
}

void TableTransaction::undo() {
  if (is_new_ && version_.written_here()) return close();
  restart();
}

// A table that was created after a savepoint gets no callback when SQLite rolls back to it. Then the stamp
// that this transaction wrote is gone, or all its tables are. A torn table answers too.
bool TableTransaction::was_rolled_back() {
  if (!version_.written_here()) return false;
  if (gone_) return true;
  try {
    return table_.read_stamp() != version_.seen();
  } catch (const StoreError& error) {
    if (error.primary() != SQLITE_ERROR) throw;
    return true;
  }
}

void TableTransaction::settle_doubt() {
  if (was_rolled_back())
    undo();
  else
    table_.use_name(name_.get());
  in_doubt_ = false;
}

// --- savepoints

void TableTransaction::savepoint(int level) {
  if (own_statements_ > 0 || gone_ || !journal_.is_open()) return;
  require_usable();
  // Two virtual tables that share one store both get the callback.
  if (!savepoints_.empty() && savepoints_.back().level >= level) return;
  // Reserve first, by doubling: once the mark is set nothing may throw.
  if (savepoints_.size() == savepoints_.capacity())
    savepoints_.reserve(std::max<std::size_t>(8, 2 * savepoints_.size()));
  const bool has_unwritten = table_.has_unwritten_changes();
  savepoints_.push_back({level, journal_.set_mark(), has_unwritten});
}

void TableTransaction::give_up_savepoints(std::size_t from) noexcept {
  if (from >= savepoints_.size()) return;
  journal_.forget(savepoints_[from].mark);
  savepoints_.resize(from);
}

/// The number of savepoints older than this level.
std::size_t TableTransaction::savepoints_before(int level) const noexcept {
  const auto first = std::lower_bound(savepoints_.begin(), savepoints_.end(), level,
                                      [](const Savepoint& one, int other) { return one.level < other; });
  return static_cast<std::size_t>(first - savepoints_.begin());
}

void TableTransaction::release(int level) {
  if (own_statements_ > 0 || gone_ || !journal_.is_open()) return;
  give_up_savepoints(savepoints_before(level));
}

// SQLite has rolled the rows back already, and calls no further table once one fails. So this does not fail: a table
// that cannot follow is torn; one that cannot read the stamp is in doubt until it is used.
bool TableTransaction::rollback_to(int level) noexcept {
  if (own_statements_ > 0) return false;
  if (gone_ || !journal_.is_open()) return true;
  bool went_back = true;
  const std::size_t first = savepoints_before(level);
  const bool is_marked = first < savepoints_.size() && savepoints_[first].level == level;
  try {
    if (is_marked || first > 0) {
      went_back = first < savepoints_.size() && restore(savepoints_[first]);
    } else if (level < 0 || !version_.written_here()) {  // -1: the savepoint that has opened the transaction
      undo();
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
  return went_back;
}

bool TableTransaction::restore(const Savepoint& savepoint) {
  const bool was_torn = std::exchange(torn_, true);  // until it is done
  if (!journal_.is_whole()) return true;
  const bool went_back = journal_.rewind(savepoint.mark) || was_torn;
  if (went_back) {
    table_.use_name(name_.get());
    version_.note_change();
  }
  torn_ = false;
  return went_back;
}

// --- the table itself

void TableTransaction::rename(const std::string& new_name) {
  name_.change() = new_name;
  table_.use_name(new_name);
  version_.note_change();
}

void TableTransaction::require_droppable() const {
  for (std::size_t i = 0; i + 1 < savepoints_.size(); ++i)
    if (savepoints_[i].has_unwritten)
      throw StoreError(SQLITE_LOCKED,
                       name_.get() +
                           " has changes from before an open savepoint: RELEASE it, or COMMIT, "
                           "and then DROP the table");
}

}  // namespace foresee
