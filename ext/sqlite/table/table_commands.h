// INSERT INTO ships(ships) VALUES('rebuild'): the commands of a table, as FTS5 has them.
//
//   rebuild           writes map and leaves anew from the objects
//   optimize          packs the leaves, neighbours in space together
//   integrity-check   fails with SQLITE_CORRUPT_VTAB and the first findings if the stored bytes are broken
#pragma once

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

/// Throws Error for an unknown command, listing the known.
void run_command(MovingObjectsTable& table, sqlite3_value* command);

/// Throws StoreError with the first findings of the integrity check, if there are any.
void require_integrity(MovingObjectsTable& table);

}  // namespace foresee
