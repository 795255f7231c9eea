// SQL functions of plans: plan_shift, plan_cut, plan_turn, and the aggregates plan_points, plan_uniform and
// plan_accelerated.
//
//   const std::optional<double> seconds = plan_number(value, "seconds");
//
// plan_rows is a table-valued function (table_functions.h).
#pragma once

#include <optional>

#include "database/sqlite_api.h"
#include "sqlite/plan_values.h"

namespace foresee {

/// Each returns an SQLite result code.
int register_plan_functions(sqlite3* db);
int register_plan_aggregates(sqlite3* db);  // plan_aggregates.cpp

/// Nothing for NULL and ''. Throws Error for a value that is not a number.
std::optional<double> plan_number(sqlite3_value* value, const char* name);
}  // namespace foresee
