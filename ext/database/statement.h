// Prepared SQL statements of the extension itself, which are reset after every run, and SQL text with quoted
// names.
//
//   Statement find(db, format_sql("SELECT leaf FROM \"%w\".\"%w_map\" WHERE id = ?", schema, table));
//   Statement::Run run(find);
//   run.bind(1, id);
//   if (run.step()) use(run.integer(0));
//
// Guarantee: a statement is compiled at its first use and reset at the end of every run, also after an error.
// So none holds a read lock or blocks VACUUM and DROP. Errors are StoreError with SQLite's code and message.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "database/sqlite_api.h"

namespace foresee {

/// Formats SQL text by the rules of sqlite3_mprintf: "%w" for a name, %Q for a string.
std::string format_sql(const char* format, ...);

/// Quotes a name for SQL, whatever its characters: "my ships".
std::string quoted_name(const std::string& name);

/// Runs statements without results.
void execute(sqlite3* db, const std::string& sql);

/// Throws the connection's last error as StoreError.
[[noreturn]] void throw_sqlite_error(sqlite3* db, int code);

/// Keeps last_insert_rowid() from showing the rows that own statements insert, while it exists.
class KeptInsertRowid {
 public:
  explicit KeptInsertRowid(sqlite3* db) : db_(db), rowid_(sqlite3_last_insert_rowid(db)) {}
  ~KeptInsertRowid() {
    if (sqlite3_last_insert_rowid(db_) != rowid_) sqlite3_set_last_insert_rowid(db_, rowid_);
  }
  KeptInsertRowid(const KeptInsertRowid&) = delete;
  KeptInsertRowid& operator=(const KeptInsertRowid&) = delete;

 private:
  sqlite3* db_;
  sqlite3_int64 rowid_;
};

class Statement {
 public:
  /// A shadow table may have been replaced by a virtual table, which would run any code. A statement fails on
  /// one unless it allows virtual tables.
  enum class Reads : std::uint8_t { tables, virtual_tables_too };

  Statement() = default;
  Statement(sqlite3* db, std::string sql, Reads reads = Reads::tables)
      : db_(db), sql_(std::move(sql)), reads_(reads) {}
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&& other) noexcept;
  ~Statement();

  class Run;

  /// Compiles the statement unless that is done.
  sqlite3_stmt* prepare();
  /// True if a schema change made SQLite recompile the statement, at its first run or between two runs.
  bool was_recompiled() const {
    return statement_ && sqlite3_stmt_status(statement_, SQLITE_STMTSTATUS_REPREPARE, 0) > 0;
  }

 private:
  sqlite3* db_ = nullptr;
  std::string sql_;
  Reads reads_ = Reads::tables;
  sqlite3_stmt* statement_ = nullptr;
  bool running_ = false;
};

/// One execution, from compiling the statement if necessary to its reset in the destructor. Any call may
/// throw StoreError. Bound texts and blobs, and the blobs of a row, are not copied: they must live until the
/// run or the row ends.
class Statement::Run {
 public:
  /// SQLITE_LOCKED_VTAB if the statement is already running: a trigger on a shadow table may call back.
  explicit Run(Statement& statement);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  void bind(int place, std::int64_t value);
  void bind(int place, double value);
  void bind(int place, std::string_view text);
  void bind(int place, std::span<const std::byte> blob);
  void bind(int place, const sqlite3_value* value);

  /// True: there is a row. False: the statement is done.
  bool step();

  bool is_integer(int column) { return sqlite3_column_type(statement_, column) == SQLITE_INTEGER; }
  bool is_blob(int column) { return sqlite3_column_type(statement_, column) == SQLITE_BLOB; }
  bool is_null(int column) { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
  std::int64_t integer(int column) { return sqlite3_column_int64(statement_, column); }
  /// The text; a longer one is cut off after at most `limit` bytes, between characters.
  std::string text(int column, std::size_t limit = std::string::npos);
  /// Empty if the column is not a blob.
  std::span<const std::byte> blob(int column);
  sqlite3_value* value(int column) { return sqlite3_column_value(statement_, column); }

 private:
  void require_ok(int code);

  Statement& owner_;
  sqlite3_stmt* statement_;
};

// Polls for sqlite3_interrupt() during a long computation, on every version of SQLite.
//
// sqlite3_is_interrupted() needs SQLite 3.41. Stepping a statement reports an interrupt on all versions and
// also calls the application's progress handler: a handler for every N instructions of SQLite about once per
// N microseconds. Each check reads the clock; the statement is stepped about once per millisecond. Cost: about
// 30 ns per check.
//
// A connection cannot be closed while a statement exists. The owner calls finalize() before that, at the
// latest when SQLite disconnects its table.
class StatementInterrupt final : public Interrupt {
 public:
  explicit StatementInterrupt(sqlite3* db) : db_(db) {}
  ~StatementInterrupt() override { finalize(); }
  StatementInterrupt(const StatementInterrupt&) = delete;
  StatementInterrupt& operator=(const StatementInterrupt&) = delete;

  /// Requires: called on the thread that runs the SQL statement, while it runs.
  void check() override {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(1);
    poll();
  }

  /// Destroys the statement; the next check makes a new one.
  void finalize() noexcept;

 private:
  void poll();

  sqlite3* db_;
  sqlite3_stmt* statement_ = nullptr;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace foresee
