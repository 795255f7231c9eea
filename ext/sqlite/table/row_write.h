// INSERT, UPDATE and DELETE on a moving_objects table: the body of xUpdate.
//
// A row is refused before its first change, so conflict clauses act as for an ordinary table. OR IGNORE skips
// the row; OR REPLACE deletes the object that has the id.
#pragma once

#include <cstdint>

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

/// `count`, `arguments`: those of xUpdate. Writes the new row's id to `*rowid`.
void write_table(MovingObjectsTable& table, int count, sqlite3_value** arguments, sqlite3_int64* rowid);

}  // namespace foresee
