// foresee_version() and foresee_debug().
#include <exception>

#include "sqlite/modules.h"
#include "sqlite/version.h"

namespace foresee::sqlite {
namespace {

void foresee_version(sqlite3_context* context, int, sqlite3_value**) {
  sqlite3_result_text(context, version(), -1, SQLITE_STATIC);
}

void foresee_debug(sqlite3_context* context, int, sqlite3_value**) {
  try {
    const std::string report = debug_report();
    sqlite3_result_text(context, report.c_str(), static_cast<int>(report.size()), SQLITE_TRANSIENT);
  } catch (const std::exception&) {
    sqlite3_result_error_nomem(context);
  }
}

}  // namespace

int register_scalars(sqlite3* db) {
  constexpr int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS;
  int rc =
      sqlite3_create_function(db, "foresee_version", 0, flags, nullptr, foresee_version, nullptr, nullptr);
  if (rc != SQLITE_OK) return rc;
  return sqlite3_create_function(db, "foresee_debug", 0, flags, nullptr, foresee_debug, nullptr, nullptr);
}

}  // namespace foresee::sqlite
