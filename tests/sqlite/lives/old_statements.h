// A connection that keeps its statements prepared after they have run, until it closes.
//
//   KeepingDriver driver(path);
//   driver.exec("BEGIN; INSERT INTO s VALUES(1, 1); ROLLBACK");     // three statements, kept
#pragma once

#include <string>
#include <vector>

#include "sqlite/database.h"

namespace foresee::testing {

class KeepingDriver {
 public:
  explicit KeepingDriver(const std::string& path, std::size_t kept = 128) : db_(path), max_kept_(kept) {}
  ~KeepingDriver() { close_statements(0); }
  KeepingDriver(const KeepingDriver&) = delete;
  KeepingDriver& operator=(const KeepingDriver&) = delete;

  sqlite3* handle() { return db_.handle(); }
  /// The connection itself, for statements that are not kept.
  Database& database() { return db_; }

  /// Runs statements that must succeed.
  void exec(const std::string& sql) { EXPECT_EQ(error_of(sql), "") << sql; }

  /// The message of the first statement that fails, after which no other runs; "" if all succeed.
  std::string error_of(const std::string& sql) {
    const std::string rows = this->rows(sql);
    return rows.starts_with("error: ") ? rows.substr(7) : "";
  }

  /// The rows of the last statement, one per line; "error: …" if a statement fails.
  std::string rows(const std::string& sql) {
    std::string text;
    for (const char* rest = sql.c_str(); *rest != 0;) {
      sqlite3_stmt* statement = nullptr;
      if (sqlite3_prepare_v2(db_.handle(), rest, -1, &statement, &rest) != SQLITE_OK)
        return std::string("error: ") + sqlite3_errmsg(db_.handle());
      if (!statement) break;
      statements_.push_back(statement);
      text = db_.rows_of(statement);
      sqlite3_reset(statement);
      if (text.starts_with("error: ")) break;
    }
    close_statements(max_kept_);
    return text;
  }

 private:
  void close_statements(std::size_t kept) {
    while (statements_.size() > kept) {
      sqlite3_finalize(statements_.front());
      statements_.erase(statements_.begin());
    }
  }

  Database db_;
  std::size_t max_kept_;
  std::vector<sqlite3_stmt*> statements_;
};

}  // namespace foresee::testing
