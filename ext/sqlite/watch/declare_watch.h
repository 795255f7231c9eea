// What does CREATE VIRTUAL TABLE … USING predictive_watch(ships, horizon = 600, within = 926) declare?
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "storage/rows/shadow_tables.h"
#include "storage/watch/watch_state.h"

namespace foresee {

/// Throws Error that names the watch, quotes the argument and says what would be right.
WatchDeclaration parse_watch(std::string_view watch, const std::vector<std::string_view>& arguments);

/// Throws Error where a declared table is no moving_objects table of the watch's own schema.
void require_tables(sqlite3* db, const QualifiedName& watch, const WatchDeclaration& declaration);

/// The nine columns of predictive_join, and hidden ones: now, the column for commands, the key. SQLite takes
/// commands only where the key is one column.
std::string declared_watch(std::string_view watch);

}  // namespace foresee
