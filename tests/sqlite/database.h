// A database for tests: foresee linked statically, in memory or in a file that is removed after the test.
//
//   Database db;
//   db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y)");
//   EXPECT_EQ(db.rows("SELECT id, x FROM ships"), "1|0.5\n2|NULL");
//   EXPECT_EQ(db.error_of("SELECT nonsense"), "no such column: nonsense");
//
// rows() prints one line per row, with '|' between columns. Doubles have their shortest form that reads back
// exactly, with a dot or an exponent, so that 1.0 and 1 differ. NULL is NULL, and a blob is x'0aff'.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <string>

#include "sqlite/foresee.h"

namespace foresee::testing {

/// A path in a new folder of its own, which the destructor removes with all other files in it (journal, WAL).
class TemporaryFile {
 public:
  TemporaryFile() {
    std::string pattern = (std::filesystem::temp_directory_path() / "foresee-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path(const std::string& name = "test.db") const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

inline std::string printable(sqlite3_value* value) {
  switch (sqlite3_value_type(value)) {
    case SQLITE_NULL:
      return "NULL";
    case SQLITE_FLOAT: {
      char digits[40];
      const double number = sqlite3_value_double(value);
      std::string text(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
      return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
    }
    case SQLITE_BLOB: {
      std::string text = "x'";
      const auto* bytes = static_cast<const unsigned char*>(sqlite3_value_blob(value));
      for (int i = 0; i < sqlite3_value_bytes(value); ++i) {
        text += "0123456789abcdef"[bytes[i] >> 4];
        text += "0123456789abcdef"[bytes[i] & 15];
      }
      return text + "'";
    }
    default: {
      const int size = sqlite3_value_bytes(value);
      return {reinterpret_cast<const char*>(sqlite3_value_text(value)), static_cast<std::size_t>(size)};
    }
  }
}

class Database {
 public:
  explicit Database(const std::string& path = ":memory:",
                    int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_URI) {
    EXPECT_EQ(sqlite3_open_v2(path.c_str(), &db_, flags, nullptr), SQLITE_OK) << sqlite3_errmsg(db_);
    char* message = nullptr;
    EXPECT_EQ(sqlite3_foresee_init(db_, &message, nullptr), SQLITE_OK) << message;
    sqlite3_free(message);
  }
  /// No statement or table of foresee may keep the connection open.
  ~Database() { EXPECT_EQ(sqlite3_close(db_), SQLITE_OK) << sqlite3_errmsg(db_); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  sqlite3* handle() { return db_; }

  /// Runs statements that must succeed.
  void exec(const std::string& sql) { EXPECT_EQ(error_of(sql), "") << sql; }

  /// The message with which the statements fail; "" if they succeed.
  std::string error_of(const std::string& sql) {
    char* message = nullptr;
    if (sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, &message) == SQLITE_OK) return "";
    const std::string text = message != nullptr ? message : sqlite3_errmsg(db_);
    sqlite3_free(message);
    return text;
  }

  /// The extended result code of the statements: SQLITE_OK, SQLITE_CONSTRAINT_VTAB, …
  int code_of(const std::string& sql) {
    const int rc = sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr);
    return rc == SQLITE_OK ? rc : sqlite3_extended_errcode(db_);
  }

  /// All rows of one statement, one per line; "error: …" if it fails.
  std::string rows(const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(db_, sql.c_str(), -1, &statement, nullptr) != SQLITE_OK)
      return std::string("error: ") + sqlite3_errmsg(db_);
    const std::string text = rows_of(statement);
    sqlite3_finalize(statement);
    return text;
  }

  /// The rows of a statement that is already prepared and bound.
  std::string rows_of(sqlite3_stmt* statement) {
    std::string text;
    int rc;
    for (int row = 0; (rc = sqlite3_step(statement)) == SQLITE_ROW; ++row) {
      if (row > 0) text += '\n';
      for (int column = 0; column < sqlite3_column_count(statement); ++column) {
        if (column > 0) text += '|';
        text += printable(sqlite3_column_value(statement, column));
      }
    }
    return rc == SQLITE_DONE ? text : std::string("error: ") + sqlite3_errmsg(db_);
  }

 private:
  sqlite3* db_ = nullptr;
};

}  // namespace foresee::testing
