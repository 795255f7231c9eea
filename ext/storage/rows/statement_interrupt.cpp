#include "storage/rows/statement_interrupt.h"

#include <new>
#include <string>

#include "storage/rows/store_error.h"

namespace foresee {

void StatementInterrupt::finalize() noexcept {
  sqlite3_finalize(statement_);
  statement_ = nullptr;
}

void StatementInterrupt::ask() {
  int rc = SQLITE_OK;
  if (statement_ == nullptr)
    rc = sqlite3_prepare_v3(db_, "SELECT 1", -1, SQLITE_PREPARE_PERSISTENT, &statement_, nullptr);
  if (rc == SQLITE_OK) {
    sqlite3_step(statement_);
    rc = sqlite3_reset(statement_);
  }
  if (rc == SQLITE_OK) return;
  next_ = {};  // an answer that nobody heeds is given again
  if (rc == SQLITE_INTERRUPT) throw Interrupted();
  if (rc == SQLITE_NOMEM) throw std::bad_alloc();
  throw StoreError(rc, sqlite3_errmsg(db_));
}

}  // namespace foresee
