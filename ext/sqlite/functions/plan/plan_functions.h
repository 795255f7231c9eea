// SQL functions of plans: plan_shift, plan_cut, plan_turn, and the aggregates plan_points, plan_uniform and
// plan_accelerated.
//
//   report_by_name(context, "plan_shift", [&] { sqlite3_result_double(context, *plan_number(value, "seconds")); });
//
// An error has the function's name in front. plan_rows is a table-valued function (table_functions.h).
#pragma once

#include <optional>
#include <utility>

#include "motion/plan/plan.h"
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

// Plans as SQL values: well-known text or a blob, in and out.
//
//   const std::optional<Plan> plan = plan_of(value);             // nothing for NULL and ''
//   if (plan) result_plan(context, *plan, sqlite3_value_type(value) == SQLITE_TEXT);
//
// Throws Error for a value that is no plan; the message says what to write instead.

std::optional<Plan> plan_of(sqlite3_value* value);

/// Requires for a text: PlanKind::knots on two or three axes, as plan_of() reads from one.
void result_plan(sqlite3_context* context, const Plan& plan, bool as_text);

}  // namespace foresee
