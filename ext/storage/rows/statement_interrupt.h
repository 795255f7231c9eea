// Has sqlite3_interrupt been called? Asked from inside a long computation, on every version of SQLite.
//
// sqlite3_is_interrupted came with 3.41. Stepping a statement notices an interrupt on all versions and also
// drives the application's progress handler. The clock is read at each check, the statement stepped about
// once a millisecond: some 30 ns a check.
//
// A connection refuses to be closed while a statement is left. Whoever may have asked must call finalize()
// before that, at the latest when SQLite disconnects its table.
#pragma once

#include <chrono>

#include "base/error.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

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
    ask();
  }

  /// Lets go of the statement; the next check makes a new one.
  void finalize() noexcept;

 private:
  void ask();

  sqlite3* db_;
  sqlite3_stmt* statement_ = nullptr;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace foresee
