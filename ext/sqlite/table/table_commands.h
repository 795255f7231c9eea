// Commands of a moving_objects table, in the style of FTS5: INSERT INTO ships(ships) VALUES('rebuild').
//
//   rebuild           writes the map and the leaves again, from the objects
//   optimize          repacks the leaves so that spatial neighbours share one
//   integrity-check   fails with SQLITE_CORRUPT_VTAB and the first findings if stored bytes are damaged
#pragma once

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

/// Throws Error for an unknown command; the message lists the known ones.
void run_command(MovingObjectsTable& table, sqlite3_value* command);

/// Throws StoreError with the first findings of the integrity check, if it has any.
void require_integrity(MovingObjectsTable& table);

}  // namespace foresee
