// Name resolution: finds the connected moving_objects table that an SQL name refers to.
//
//   const auto ships = open_table(connection, {.table = call.text(in_tbl), .schema = {}});
//   connection.load_scene(ships);  ships.store->take_snapshot();         // all of it, or its tree
//
// A name resolves as SQLite resolves it (temp, main, attached) unless a schema is given; without a name the
// connection must see exactly one moving_objects table. SQLite itself looks the name up, connects the table
// and starts to read that database (table_lookups.h). Scenes and trees are snapshots, and the statement of
// the look-up has ended before open_table returns: the table can be written during a running call. Towards
// other connections SQLite holds its read lock until the calling statement ends, as for any reader.
#pragma once

#include "sqlite/connection.h"

namespace foresee {

/// The table; equal tables have equal stores. Returns a copy, because the look-up of another table may make
/// SQLite reconnect this one. Throws Error if no such table exists or the choice is ambiguous; the message
/// lists the tables.
OpenTable open_table(Connection& connection, const TableName& name);

/// Throws Error if metres of one table are not those of the other (frame_conflict()).
void require_one_frame(const OpenTable& a, const OpenTable& b);

/// Throws Error for a `within_z` if the table is on the globe, where no axis points up.
void require_upright(const OpenTable& table, const std::optional<double>& within_z);

/// 'name', as messages show it.
std::string quoted(const std::string& name);

/// Throws Error as open_table() does, unless this is a moving_objects table. Reads only the text of its
/// declaration: connects and queries no table.
void require_moving_objects(sqlite3* db, const std::string& table, const std::optional<std::string>& schema);

}  // namespace foresee
