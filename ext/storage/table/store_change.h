// What a change of a store is wrapped in, so that it is all or nothing.
//
//   AtomicChange atomic_change(*this);          // from here on memory can go back
//   add(id, record);                            // may throw: then everything is as it was
//   atomic_change.done();                       // it holds
#pragma once

#include "base/float_environment.h"
#include "storage/table/store.h"

namespace foresee {

/// Our own statements inside a callback. SQLite may call the table back about them: while this lives their
/// savepoints are passed over, and a rollback of everything (after a disk error) waits until it ends. Nobody
/// sees them in last_insert_rowid(). Nests; costs two calls of SQLite.
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

/// One change, and own statements all the while. Unless it is done(), its end takes back all that memory
/// knows: nodes, map, pending objects, the log of changed objects, the largest id, the count. Where rows were
/// written during the change that does not help: the store is torn, and refuses everything until SQLite rolls
/// back. Cost: a few positions; a node is copied when it is changed, not before.
class Store::AtomicChange {
 public:
  explicit AtomicChange(Store& store)
      : own_(store),
        store_(store),
        pending_(store.pending_),
        pending_position_(store.pending_->position()),
        changes_position_(store.object_changes_.position()),
        largest_(store.largest_),
        count_(store.count_) {
    store_.cache_.begin_change();
  }
  ~AtomicChange() {
    if (done_) return;
    store_.torn_ |= store_.cache_.wrote_in_change();
    store_.cache_.cancel_change();
    store_.pending_ = std::move(pending_);
    store_.pending_->rewind(pending_position_);
    store_.object_changes_.rewind(changes_position_);
    store_.largest_ = largest_;
    store_.count_ = count_;
  }

  /// It holds. Whoever takes it back from now on goes back to a savepoint, or to the transaction's begin.
  void done() {
    store_.cache_.end_change();
    done_ = true;
    store_.note_change();
    if (store_.savepoints_.empty()) store_.pending_->forget_past();
  }

 private:
  OwnStatements own_;
  Store& store_;
  std::shared_ptr<PendingObjects> pending_;
  std::size_t pending_position_, changes_position_;
  LargestId largest_;
  ObjectCount count_;
  bool done_ = false;
};

/// Work of the tree, which rounds its bounds outward. Where nodes contradict one another it is the table's
/// error.
template <class Body>
auto Store::with_sound_tree(Body body) {
  const FloatEnvironment environment;
  try {
    return body();
  } catch (const BrokenTree& error) {
    damaged(error.what());
  }
}

}  // namespace foresee
