// How will SQLite find rows of a moving_objects table? The plans of xBestIndex.
//
//   idxNum   argument        plan
//     0                      every object, leaf by leaf
//     1      id              the object of this id
//     2      'foresee-handle'  one row: the number by which Connection::find knows the table
//
// The last one is how table-valued functions reach a table by name: `WHERE "ships" MATCH 'foresee-handle'`.
#pragma once

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

enum class TablePlan : int { scan = 0, one_object = 1, handle = 2 };

constexpr const char* handle_word = "foresee-handle";

/// xBestIndex, by the number of objects that memory knows (Store::likely_objects): the handle where MATCH
/// asks for it, one object where its id is given, else all. A result code: SQLITE_CONSTRAINT where the word
/// to MATCH is not there yet.
int plan_table(const MovingObjectsTable& table, sqlite3_index_info* info);

}  // namespace foresee
