#include "storage/rows/statement_interrupt.h"

#include <new>
#include <string>
#include <utility>

#include "storage/rows/store_error.h"

namespace foresee {

void StatementInterrupt::finalize() noexcept {
  sqlite3_finalize(statement_);
  statement_ = nullptr;
}

// While the statement runs it is nobody's but this function's: SQLite may compile it anew and before that
// disconnect tables, which finalizes what is kept.
void StatementInterrupt::ask() {
  sqlite3_stmt* statement = std::exchange(statement_, nullptr);
  int rc = SQLITE_OK;
  if (statement == nullptr)
    rc = sqlite3_prepare_v3(db_, "SELECT 1", -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (rc == SQLITE_OK) {
    sqlite3_step(statement);
    rc = sqlite3_reset(statement);
  }
  statement_ = statement;
  if (rc == SQLITE_OK) return;
  next_ = {};  // an answer that nobody heeds is given again
  if (rc == SQLITE_INTERRUPT) throw Interrupted();
  if (rc == SQLITE_NOMEM) throw std::bad_alloc();
  throw StoreError(rc, sqlite3_errmsg(db_));
}

}  // namespace foresee
