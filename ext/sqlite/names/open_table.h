// Which table is meant?
//
//   const auto ships = open_table(connection, {.table = call.text(in_tbl), .schema = {}});
//   connection.load_scene(ships);  ships.store->take_snapshot();         // all of it, or its tree
//
// A name resolves as SQLite resolves it (temp, main, attached) unless a schema is given; without a name the
// connection must see exactly one moving_objects table. SQLite itself looks the name up, connects the table
// and begins to read that database (table_lookups.h). Scenes and trees are snapshots and that statement is at
// rest before open_table returns, so the table can be written under a running call; against other connections
// SQLite keeps its read lock until the statement that calls ends, as for any reader.
#pragma once

#include "sqlite/connection.h"

namespace foresee {

/// Equal tables have equal stores. A copy, because to look up another table may make SQLite connect this one
/// anew. Throws Error where no such table is to be found or where the choice is not
/// clear; it lists what there is.
Connection::OpenTable open_table(Connection& connection, const QueriedTable& name);

/// 'name', as messages show it.
std::string quoted(const std::string& name);

/// By the text of its declaration alone: nothing is connected or asked. Throws Error as open_table does.
void require_moving_objects(sqlite3* db, const std::string& table, const std::optional<std::string>& schema);

}  // namespace foresee
