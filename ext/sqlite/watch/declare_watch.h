// Parser of CREATE VIRTUAL TABLE … USING predictive_watch(ships, horizon = 600, within = 926).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "database/shadow_tables.h"
#include "query/watch/watch_state.h"
#include "sqlite/connection.h"

namespace foresee {

/// Throws Error; the message names the watch, quotes the argument and says what to write instead.
WatchDeclaration parse_watch(std::string_view watch, const std::vector<std::string_view>& arguments);

/// Throws Error if a declared table is not a moving_objects table in the schema of the watch. Reads no other
/// schema.
void require_tables(Connection& connection, const QualifiedName& watch, const WatchDeclaration& declaration);

/// The CREATE TABLE statement for sqlite3_declare_vtab: the nine columns of predictive_join, then hidden ones
/// for now, commands and the key. SQLite accepts commands only if the key is a single column.
std::string declared_watch(std::string_view watch);

}  // namespace foresee
