// Guards that make a change of a store atomic: own statements, and undo in memory.
//
//   AtomicChange atomic_change(*this);          // starts to keep old states
//   add(id, record);                            // if it throws, everything is restored
//   atomic_change.done();                       // the change is valid
#pragma once

#include "storage/table/store.h"

namespace foresee {

/// Own SQL statements inside a callback. SQLite may call the table back for them: while this object exists
/// their savepoints are ignored, and a complete rollback (after a disk error) is deferred until it ends.
/// last_insert_rowid() does not show them. Nests; costs two calls of SQLite.
class Store::OwnStatements {
 public:
  explicit OwnStatements(Store& store) : store_(store), rowid_(sqlite3_last_insert_rowid(store.db_)) {
    ++store_.own_statements_;
  }
  ~OwnStatements() {
    if (sqlite3_last_insert_rowid(store_.db_) != rowid_) sqlite3_set_last_insert_rowid(store_.db_, rowid_);
    if (--store_.own_statements_ > 0 || !store_.rolled_back_) return;
    store_.rolled_back_ = false;
    store_.rollback();
  }
  OwnStatements(const OwnStatements&) = delete;
  OwnStatements& operator=(const OwnStatements&) = delete;

 private:
  Store& store_;
  sqlite3_int64 rowid_;
};

/// One change, including its own statements. Unless it is done(), its end restores all state in memory. If rows
/// were written during the change, the store is torn and refuses everything until SQLite rolls back. At its end
/// participants of Scope::marks drop what they have kept, unless an older savepoint needs it; those of
/// Scope::transaction keep it until the transaction ends. Cost: a mark in the journal; a node is copied when it is
/// changed, not before.
class Store::AtomicChange {
 public:
  explicit AtomicChange(Store& store) : own_(store), store_(store), mark_(store.journal_.set_mark()) {}
  ~AtomicChange() {
    if (!done_) cancel();
    store_.journal_.forget(mark_);
  }

  /// The change is valid. Only a savepoint or the start of the transaction can be restored from now on.
  void done() {
    store_.version_.note_change();
    done_ = true;
  }
  /// done() for a change after which every query has the same answer.
  void done_with_same_contents() { done_ = true; }

 private:
  void cancel() noexcept try {
    store_.torn_ |= store_.journal_.is_abandoned(mark_);
    store_.journal_.rewind(mark_);
  } catch (...) {
    store_.torn_ = true;
  }

  OwnStatements own_;
  Store& store_;
  Journal::Mark mark_;
  bool done_ = false;
};

}  // namespace foresee
