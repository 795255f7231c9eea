#include "storage/rows/statement_interrupt.h"

#include <new>
#include <string>
#include <utility>

#include "storage/rows/store_error.h"

namespace foresee::storage {

namespace {

/// SQLite calls a progress handler every so many instructions of its own, of which a thousand is a usual number. A check
/// about once a millisecond runs as many, in some ten microseconds.
std::string thousand_instructions() {
  std::string sql = "SELECT count(*) FROM (VALUES(0)";
  for (int i = 1; i < 200; ++i) sql += ",(0)";
  return sql + ")";
}

}  // namespace

void StatementInterrupt::finalize() noexcept {
  sqlite3_finalize(statement_);
  statement_ = nullptr;
}

// While the statement runs it is nobody's but this function's: SQLite may compile it anew and before that
// disconnect tables, which finalizes what is kept.
void StatementInterrupt::ask() {
  sqlite3_stmt* statement = std::exchange(statement_, nullptr);
  int rc = SQLITE_OK;
  const auto prepare = [&](const std::string& sql) {
    return sqlite3_prepare_v3(db_, sql.c_str(), -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  };
  if (statement == nullptr) rc = prepare(thousand_instructions());
  if (rc == SQLITE_ERROR || rc == SQLITE_AUTH || rc == SQLITE_TOOBIG)
    rc = prepare("SELECT 1");  // limits of the host
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

}  // namespace foresee::storage
