// INSERT, UPDATE and DELETE on a moving_objects table: the body of xUpdate.
//
// A row is refused before its first change, so conflict clauses act as for an ordinary table. OR IGNORE skips
// the row; OR REPLACE deletes the object that has the id.
#pragma once

#include <cstdint>

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

/// Inserts, updates or deletes one row. `count`, `arguments`: those of xUpdate. Writes the new row's id to `*rowid`.
void write_row(MovingObjectsTable& table, int count, sqlite3_value** arguments, sqlite3_int64* rowid);

// Commands of a moving_objects table, in the style of FTS5: INSERT INTO ships(ships) VALUES('rebuild').
//
//   rebuild           writes the map and the leaves again, from the objects
//   optimize          repacks the leaves so that spatial neighbours share one
//   integrity-check   fails with SQLITE_CORRUPT_VTAB and the first findings if stored bytes are damaged

/// Throws Error for an unknown command; the message lists the known ones.
void run_command(MovingObjectsTable& table, sqlite3_value* command);

/// Throws StoreError with the first findings of the integrity check, if it has any.
void require_integrity(MovingObjectsTable& table);

}  // namespace foresee
