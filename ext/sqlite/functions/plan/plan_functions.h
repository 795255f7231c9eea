// SQL functions of plans: plan_shift, plan_cut, plan_turn, and the aggregates plan_points, plan_uniform and
// plan_accelerated.
//
//   const std::optional<double> seconds = plan_number(value, "seconds");
//
// plan_rows is a table-valued function (table_functions.h).
#pragma once

#include <optional>

#include "motion/plan/plan.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

/// Each returns an SQLite result code.
int register_plan_functions(sqlite3* db);
int register_plan_aggregates(sqlite3* db);  // plan_aggregates.cpp

/// Nothing for NULL and ''. Throws Error for a value that is not a number.
std::optional<double> plan_number(sqlite3_value* value, const char* name);

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
