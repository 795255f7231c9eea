// Name resolution: finds the connected moving_objects table that a name of SQL means.
//
//   const auto ships = open_table(connection, {.table = call.text(in_tbl), .schema = {}});
//   connection.load_scene(ships);  ships.store->take_snapshot();         // all of it, or its tree
//
// A name resolves as SQLite resolves it (temp, main, attached) unless a schema is given; without a name the
// connection must see exactly one moving_objects table. SQLite itself looks the name up, connects the table
// and starts to read that database (table_lookups.h). Scenes and trees are snapshots, and that statement is at
// rest before open_table returns: the table can be written during a running call. Against other connections
// SQLite keeps its read lock until the calling statement ends, as for any reader.
#pragma once

#include "sqlite/connection.h"

namespace foresee {

/// Equal tables have equal stores. A copy, because the look-up of another table may make SQLite reconnect this
/// one. Throws Error if no such table exists or the choice is ambiguous; the message lists the tables.
Connection::OpenTable open_table(Connection& connection, const QueriedTable& name);

/// 'name', as messages show it.
std::string quoted(const std::string& name);

/// By the text of its declaration alone: no table is connected or queried. Throws Error as open_table does.
void require_moving_objects(sqlite3* db, const std::string& table, const std::optional<std::string>& schema);

}  // namespace foresee
