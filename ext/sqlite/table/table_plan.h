// Query plans of a moving_objects table, as xBestIndex chooses them.
//
//   idxNum   argument        plan
//     0                      every object, leaf by leaf
//     1      id              the object with this id
//     2      'foresee-handle'  one row: the table's number, the key of Connection::find
//
// Table-valued functions use plan 2 to find a table by name: `WHERE "ships" MATCH 'foresee-handle'`.
#pragma once

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

enum class TablePlan : int { scan = 0, one_object = 1, handle = 2 };

constexpr const char* handle_word = "foresee-handle";

/// xBestIndex: plan `handle` for MATCH, `one_object` if the id is given, else `scan`. Costs follow from
/// Store::likely_objects. Returns SQLITE_CONSTRAINT if the operand of MATCH is not available in this plan.
int plan_table(const MovingObjectsTable& table, sqlite3_index_info* info);

}  // namespace foresee
