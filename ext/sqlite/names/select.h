// A SELECT that the extension asks of its own connection, finalized when it goes out of scope.
//
//   Select select(db, "SELECT name FROM \"%w\".sqlite_master", schema.c_str());
//   while (select.step()) use(select.text(0));
//
// Names are quoted with %w, strings with %Q, as sqlite3_mprintf has them. A failure is a StoreError with
// SQLite's code and message.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "storage/rows/sqlite_api.h"

namespace foresee {

class Select {
 public:
  Select(sqlite3* db, const char* format, ...);
  ~Select() { sqlite3_finalize(statement_); }
  Select(const Select&) = delete;
  Select& operator=(const Select&) = delete;

  /// Steps to the first or next row; false at the end.
  bool step();
  /// Lets go of the row and of all locks: the next step begins anew.
  void rewind() { sqlite3_reset(statement_); }
  /// A schema that it reads, or all of them, changed between prepare and step.
  bool was_compiled_anew() const {
    return sqlite3_stmt_status(statement_, SQLITE_STMTSTATUS_REPREPARE, 0) > 0;
  }
  /// A column of the current row; "" for NULL.
  std::string text(int column) const;
  /// A column of the current row, if it is an integer.
  std::optional<std::int64_t> integer(int column) const;

 private:
  void check(int rc) const;

  sqlite3* db_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace foresee
