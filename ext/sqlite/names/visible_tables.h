// List of the tables that a connection sees, with those that hold moving objects marked.
//
// Read from each schema's sqlite_master in the order in which SQLite resolves an unqualified name: temp,
// main, then the attached databases. Cost: one scan of each schema.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "database/sqlite_api.h"

namespace foresee {

struct VisibleTable {
  std::string schema, name;
  bool holds_moving_objects;
  bool is_watch;  ///< CREATE VIRTUAL TABLE … USING predictive_watch
};

/// All tables and views of all schemas.
std::vector<VisibleTable> visible_tables(sqlite3* db);
/// Those of one schema; none if it does not exist. Reads no other schema: if another connection has changed that,
/// SQLite reloads every schema, also the one in which a CREATE VIRTUAL TABLE is under way.
std::vector<VisibleTable> visible_tables(sqlite3* db, const std::string& schema);

/// Whether this is a CREATE VIRTUAL TABLE … USING this module, as sqlite_master stores it.
bool uses_module(const std::string& sql, std::string_view module);
inline bool uses_moving_objects(const std::string& sql) {
  return uses_module(sql, "moving_objects");
}

}  // namespace foresee
