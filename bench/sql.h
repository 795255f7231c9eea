// SQLite for benchmarks: connections and statements that clean up after themselves and throw Error.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <string>

#include "base/error.h"

namespace foresee::bench {

class Database {
 public:
  explicit Database(const std::string& path) { require_ok(sqlite3_open(path.c_str(), &db_)); }
  ~Database() { sqlite3_close(db_); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(const std::string& sql) { require_ok(sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr)); }
  void require_ok(int code) {
    if (code != SQLITE_OK) throw Error(sqlite3_errmsg(db_));
  }
  /// Pages that this connection has written to the file or to the WAL since the last call.
  int pages_written() {
    int pages = 0, unused = 0;
    require_ok(sqlite3_db_status(db_, SQLITE_DBSTATUS_CACHE_WRITE, &pages, &unused, 1));
    return pages;
  }
  sqlite3* handle() { return db_; }

 private:
  sqlite3* db_ = nullptr;
};

class Statement {
 public:
  Statement(Database& db, const std::string& sql) : db_(db) {
    db.require_ok(sqlite3_prepare_v2(db.handle(), sql.c_str(), -1, &statement_, nullptr));
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(int place, std::int64_t value) { sqlite3_bind_int64(statement_, place, value); }
  void bind(int place, double value) { sqlite3_bind_double(statement_, place, value); }
  /// True for a row; at the end the statement is reset and can be run again.
  bool step() {
    const int code = sqlite3_step(statement_);
    if (code == SQLITE_ROW) return true;
    db_.require_ok(sqlite3_reset(statement_));
    return false;
  }
  /// Steps through all rows; how many they were.
  std::int64_t step_all() {
    std::int64_t rows = 0;
    while (step()) ++rows;
    return rows;
  }
  int columns() { return sqlite3_column_count(statement_); }
  std::int64_t integer(int column) { return sqlite3_column_int64(statement_, column); }
  double number(int column) { return sqlite3_column_double(statement_, column); }
  sqlite3_stmt* handle() { return statement_; }

 private:
  Database& db_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace foresee::bench
