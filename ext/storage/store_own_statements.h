// The store's own writes under way: SQLite may call the table back about them (a statement's savepoint, a
// rollback of everything after a disk error), and the application's last_insert_rowid() must not see them.
#pragma once

#include "storage/store.h"

namespace foresee {

class Store::OwnStatements {
 public:
  explicit OwnStatements(Store& store) : store_(store), rowid_(sqlite3_last_insert_rowid(store.db_)) {
    ++store_.own_statements_;
  }
  ~OwnStatements() {
    sqlite3_set_last_insert_rowid(store_.db_, rowid_);
    if (--store_.own_statements_ == 0 && store_.forget_after_) store_.forget();
  }
  OwnStatements(const OwnStatements&) = delete;
  OwnStatements& operator=(const OwnStatements&) = delete;

 private:
  Store& store_;
  sqlite3_int64 rowid_;
};

}  // namespace foresee
