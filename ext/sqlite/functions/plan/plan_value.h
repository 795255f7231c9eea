// Plans as SQL values: well-known text or a blob, in and out.
//
//   const std::optional<Plan> plan = plan_of(value);             // nothing for NULL and ''
//   if (plan) result_plan(context, *plan, sqlite3_value_type(value) == SQLITE_TEXT);
//
// Throws Error for a value that is no plan; the message says what to write instead.
#pragma once

#include <optional>

#include "motion/plan/plan.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

std::optional<Plan> plan_of(sqlite3_value* value);

/// Requires for a text: PlanKind::knots on two or three axes, as plan_of() reads from one.
void result_plan(sqlite3_context* context, const Plan& plan, bool as_text);

}  // namespace foresee
