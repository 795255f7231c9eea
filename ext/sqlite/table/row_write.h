// What does INSERT, UPDATE or DELETE do to a moving_objects table? The body of xUpdate.
//
// Everything that can be refused is refused before the first change, so the conflict clauses mean what they
// mean for an ordinary table: OR IGNORE passes over the row, OR REPLACE deletes the object that has the id.
#pragma once

#include <cstdint>

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

/// `arguments` as xUpdate gets them; the new row's id goes to `*rowid`.
void write_table(MovingObjectsTable& table, int count, sqlite3_value** arguments, sqlite3_int64* rowid);

}  // namespace foresee
