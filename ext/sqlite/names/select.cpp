#include "sqlite/names/select.h"

#include <cstdarg>
#include <memory>
#include <new>

#include "storage/rows/store_error.h"
#include "storage/rows/text.h"

namespace foresee {

Select::Select(sqlite3* db, const char* format, ...) : db_(db) {
  va_list arguments;
  va_start(arguments, format);
  const std::unique_ptr<char, void (*)(void*)> sql(sqlite3_vmprintf(format, arguments), sqlite3_free);
  va_end(arguments);
  if (!sql) throw std::bad_alloc();
  check(sqlite3_prepare_v2(db, sql.get(), -1, &statement_, nullptr));
}

bool Select::step() {
  const int rc = sqlite3_step(statement_);
  if (rc != SQLITE_ROW && rc != SQLITE_DONE) check(rc);
  return rc == SQLITE_ROW;
}

std::string Select::text(int column) const {
  return text_of(statement_, column);
}

std::optional<std::int64_t> Select::integer(int column) const {
  if (sqlite3_column_type(statement_, column) != SQLITE_INTEGER) return std::nullopt;
  return sqlite3_column_int64(statement_, column);
}

void Select::check(int rc) const {
  if (rc == SQLITE_OK) return;
  if (rc == SQLITE_NOMEM) throw std::bad_alloc();
  throw StoreError(rc, sqlite3_errmsg(db_));
}

}  // namespace foresee
