// SQL that the extension runs on its own: text with quoted names, and prepared statements that never stay
// open.
//
//   Statement find(db, format_sql("SELECT leaf FROM \"%w\".\"%w_map\" WHERE id = ?", schema, table));
//   Statement::Run run(find);
//   run.bind(1, id);
//   if (run.step()) use(run.integer(0));
//
// Guarantee: a statement is compiled at its first use and reset at the end of every run, whatever happens, so
// that none holds a read lock or stands in the way of VACUUM and DROP. Failures are StoreError with SQLite's
// code and message.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

/// SQL text by the rules of sqlite3_mprintf: "%w" for a name, %Q for a string.
std::string format_sql(const char* format, ...);

/// A name as SQL writes it whatever is in it: "my ships".
std::string quoted_name(const std::string& name);

/// Runs statements that give no rows.
void execute(sqlite3* db, const std::string& sql);

/// Throws the connection's last error as StoreError.
[[noreturn]] void throw_sqlite_error(sqlite3* db, int code);

class Statement {
 public:
  /// A name of ours may have become a virtual table's, which would run what it likes: such a statement fails
  /// unless it says that it wants them.
  enum class Reads : std::uint8_t { tables, virtual_tables_too };

  Statement() = default;
  Statement(sqlite3* db, std::string sql, Reads reads = Reads::tables)
      : db_(db), sql_(std::move(sql)), reads_(reads) {}
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&& other) noexcept;
  ~Statement();

  class Run;

  /// Compiles it if that has not been done.
  sqlite3_stmt* prepare();
  /// A schema that it reads, or all of them, changed between two of its runs or before the first.
  bool was_compiled_anew() const {
    return statement_ && sqlite3_stmt_status(statement_, SQLITE_STMTSTATUS_REPREPARE, 0) > 0;
  }

 private:
  sqlite3* db_ = nullptr;
  std::string sql_;
  Reads reads_ = Reads::tables;
  sqlite3_stmt* statement_ = nullptr;
  bool running_ = false;
};

/// One execution, from compiling the statement if need be until its reset in the destructor. Any call may
/// throw StoreError. Bound texts and blobs, and the blobs that a row shows, are not copied: they must live
/// until the run or the row ends.
class Statement::Run {
 public:
  /// SQLITE_LOCKED_VTAB if the statement is running: a trigger on a shadow table may lead back to us.
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
  /// Of a longer text only the beginning, at most so many bytes and no part of a character.
  std::string text(int column, std::size_t limit = std::string::npos);
  /// Empty if the column is no blob.
  std::span<const std::byte> blob(int column);
  sqlite3_value* value(int column) { return sqlite3_column_value(statement_, column); }

 private:
  void require_ok(int code);

  Statement& owner_;
  sqlite3_stmt* statement_;
};

// Has sqlite3_interrupt been called? Asked from inside a long computation, on every version of SQLite.
//
// sqlite3_is_interrupted came with 3.41. Stepping a statement notices an interrupt on all versions and also
// drives the application's progress handler. The clock is read at each check, the statement stepped about
// once a millisecond: some 30 ns a check.
//
// A connection refuses to be closed while a statement is left. Whoever may have asked must call finalize()
// before that, at the latest when SQLite disconnects its table.

class StatementInterrupt final : public Interrupt {
 public:
  explicit StatementInterrupt(sqlite3* db) : db_(db) {}
  ~StatementInterrupt() override { finalize(); }
  StatementInterrupt(const StatementInterrupt&) = delete;
  StatementInterrupt& operator=(const StatementInterrupt&) = delete;

  /// Requires: called on the thread that runs the statement, while it runs.
  void check() override {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(1);
    poll();
  }

  /// Lets go of the statement; the next check makes a new one.
  void finalize() noexcept;

 private:
  void poll();

  sqlite3* db_;
  sqlite3_stmt* statement_ = nullptr;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace foresee
