// SQL functions of plans: plan_shift, plan_cut, plan_turn, and the aggregates plan_points, plan_uniform and
// plan_accelerated.
//
//   report_by_name(context, "plan_shift", [&] { sqlite3_result_double(context, *plan_number(value, "seconds")); });
//
// An error has the function's name in front. plan_rows is a table-valued function (table_functions.h).
#pragma once

#include <optional>
#include <utility>

#include "sqlite/callback.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

/// Each returns an SQLite result code.
int register_plan_functions(sqlite3* db);
int register_plan_aggregates(sqlite3* db);  // plan_aggregates.cpp

/// Nothing for NULL and ''. Throws Error for a value that is not a number.
std::optional<double> plan_number(sqlite3_value* value, const char* name);

/// Runs the body of a function; an exception becomes its error.
template <class Body>
void report_by_name(sqlite3_context* context, const char* name, Body&& body) noexcept {
  char* message = nullptr;
  const int rc = guarded(&message, std::forward<Body>(body));
  if (rc == SQLITE_OK) return;
  if (message != nullptr) message = sqlite3_mprintf("%s: %z", name, message);
  if (rc == SQLITE_NOMEM || (message == nullptr && rc != SQLITE_INTERRUPT))
    sqlite3_result_error_nomem(context);
  else if (message != nullptr)
    sqlite3_result_error(context, message, -1);
  if (rc == SQLITE_INTERRUPT) sqlite3_result_error_code(context, rc);
  sqlite3_free(message);
}

}  // namespace foresee
