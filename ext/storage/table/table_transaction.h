// Transaction of one table as SQLite's callbacks report it: savepoints, changes, and rollbacks without a callback.
//
//   TableTransaction transaction(db, table, "ships", is_new);           // table: what it restores, a ChangingTable
//   transaction.begin();
//   transaction.savepoint(0);
//   TableTransaction::AtomicChange change(transaction);                 // if what follows throws, memory is as it was
//   use(table);
//   change.done();
//   transaction.rollback_to(0);                                         // as before the change
//
// Savepoints and changes are marks of one journal (journal.h). SQLite restores the rows itself. It makes no callback
// for a table that it has created after the savepoint; the stored stamp then shows it. What cannot follow a rollback is
// torn: it refuses everything until the transaction is rolled back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/statement.h"
#include "storage/table/version.h"

namespace foresee {

/// What a transaction needs of its table: TableContents implements most of it, TableWriter and Store the rest.
class ChangingTable {
 public:
  /// The stored stamp, as this connection sees it now; nothing if it is missing.
  virtual std::optional<std::int64_t> read_stamp() = 0;
  /// A transaction starts, and no other connection can write from here on: memory must be valid for what is stored.
  virtual void revalidate_at_begin() = 0;
  /// True if changes are in memory only.
  virtual bool has_unwritten_changes() const = 0;
  /// Reads and writes rows under this name from now on.
  virtual void use_name(const std::string& table) = 0;
  /// The journal has ended: a COMMIT, a ROLLBACK, or a rollback after which the transaction goes on.
  virtual void note_end() noexcept = 0;
  /// Forgets what was read of rows. The table is gone, and an old prepared statement may keep this object.
  virtual void forget_rows() = 0;

 protected:
  ~ChangingTable() = default;
};

class TableTransaction {
 public:
  /// `is_new`: the table is created now. SQLite does that inside a write transaction and does not call begin() for it.
  TableTransaction(sqlite3* db, ChangingTable& table, const std::string& name, bool is_new);

  sqlite3* db() const { return db_; }
  Journal& journal() { return journal_; }
  Version& version() { return version_; }
  const Version& version() const { return version_; }
  bool is_open() const { return journal_.is_open(); }
  /// True if the table was dropped, or its creation was rolled back: then every callback does nothing.
  bool is_gone() const { return gone_; }
  bool is_torn() const { return torn_; }
  bool runs_own_statements() const { return own_statements_ > 0; }
  /// True once SQLite has rolled everything back during own statements. The reference stays valid, for a
  /// change that reads it while it writes.
  const bool& rolled_back_within() const { return rolled_back_; }

  /// Throws SQLITE_ABORT if the table is torn, until SQLite rolls back; SQLITE_SCHEMA if it is gone, so that SQLite
  /// prepares the statement again.
  void require_usable() {
    if (gone_ || in_doubt_ || torn_) settle();
  }
  /// Finds out by the stored stamp whether SQLite has rolled back all that this transaction wrote, if in doubt. What
  /// reads changes in memory calls it first.
  void resolve_doubt() {
    if (in_doubt_) settle_doubt();
  }
  /// True if SQLite has rolled back all that this transaction wrote, without a callback.
  bool was_rolled_back();
  /// Forgets what this transaction has changed. It goes on.
  void restart();
  /// Ends the transaction of a table that is dropped or was never created.
  void close();

  // --- callbacks of the virtual table, named as SQLite names them
  void begin();
  void commit();
  void rollback();
  void savepoint(int level);
  void release(int level);
  /// Returns whether the contents in memory may have gone back: false if nothing has changed since that savepoint.
  bool rollback_to(int level) noexcept;
  /// The shadow tables have this name now. Requires: in own statements.
  void rename(const std::string& new_name);
  /// Throws SQLITE_LOCKED if changes would be lost with this object, although SQLite may roll back to a savepoint that
  /// is older than the newest one, which belongs to the DROP.
  void require_droppable() const;

  class OwnStatements;
  class AtomicChange;

 private:
  struct Savepoint {
    int level;
    Journal::Mark mark;
    bool has_unwritten;  ///< it has unwritten changes
  };

  /// require_usable() and resolve_doubt(), where there is something to do.
  void settle();
  void settle_doubt();
  void end(Journal::Ended how);
  bool restore(const Savepoint& savepoint);  ///< returns as rollback_to()
  /// restart(), but closes a table that this transaction has created.
  void undo();
  std::size_t savepoints_before(int level) const noexcept;
  void give_up_savepoints(std::size_t from) noexcept;

  sqlite3* db_;
  ChangingTable& table_;
  Journal journal_;
  Version version_{journal_};
  Journaled<std::string> name_;  ///< of the table, which use_name() gives it again after a rollback
  std::vector<Savepoint> savepoints_;
  bool is_new_;               ///< this transaction has created the table
  bool gone_ = false;         ///< the table is dropped, or its creation was rolled back
  bool torn_ = false;         ///< a change failed after it wrote rows: only a rollback helps
  bool in_doubt_ = false;     ///< after a rollback: the next access checks the name and the stamp
  int own_statements_ = 0;    ///< own statements in progress: callbacks now are due to them
  bool rolled_back_ = false;  ///< … during which SQLite rolled everything back
};

/// Own SQL statements inside a callback. SQLite may call the table back for them: while this object exists
/// their savepoints are ignored, and a complete rollback (after a disk error) is deferred until it ends.
/// Nests; costs two calls of SQLite.
class TableTransaction::OwnStatements {
 public:
  explicit OwnStatements(TableTransaction& transaction) : transaction_(transaction), kept_(transaction.db_) {
    ++transaction_.own_statements_;
  }
  ~OwnStatements() {
    if (--transaction_.own_statements_ > 0 || !transaction_.rolled_back_) return;
    transaction_.rolled_back_ = false;
    try {
      transaction_.rollback();
    } catch (...) {  // without memory: the table is in doubt until its next access
    }
  }
  OwnStatements(const OwnStatements&) = delete;
  OwnStatements& operator=(const OwnStatements&) = delete;

 private:
  TableTransaction& transaction_;
  KeptInsertRowid kept_;
};

/// One change, including its own statements. Unless it is done(), its end restores all state in memory. If rows
/// were written during the change, the table is torn. At its end participants of Scope::marks drop what they have kept,
/// unless an older savepoint needs it; those of Scope::transaction keep it until the transaction ends. Cost: a mark in
/// the journal; a node is copied when it is changed, not before.
class TableTransaction::AtomicChange {
 public:
  explicit AtomicChange(TableTransaction& transaction)
      : own_(transaction), transaction_(transaction), mark_(transaction.journal_.set_mark()) {}
  ~AtomicChange() {
    if (!done_) cancel();
    transaction_.journal_.forget(mark_);
  }

  /// The change is valid. Only a savepoint or the start of the transaction can be restored from now on.
  void done() {
    transaction_.version_.note_change();
    done_ = true;
  }
  /// done() for a change after which every query has the same answer.
  void done_with_same_contents() { done_ = true; }

 private:
  void cancel() noexcept try {
    transaction_.torn_ |= transaction_.journal_.is_abandoned(mark_);
    transaction_.journal_.rewind(mark_);
  } catch (...) {
    transaction_.torn_ = true;
  }

  OwnStatements own_;
  TableTransaction& transaction_;
  Journal::Mark mark_;
  bool done_ = false;
};

}  // namespace foresee
