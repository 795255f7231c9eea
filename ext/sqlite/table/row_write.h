// INSERT, UPDATE and DELETE on a moving_objects table: the body of xUpdate.
//
// Every refusal comes before the first change, so the conflict clauses act as for an ordinary table. OR IGNORE
// skips the row, and OR REPLACE deletes the object that has the id.
#pragma once

#include <cstdint>

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

/// `arguments` as xUpdate gets them; the new row's id goes to `*rowid`.
void write_table(MovingObjectsTable& table, int count, sqlite3_value** arguments, sqlite3_int64* rowid);

}  // namespace foresee
