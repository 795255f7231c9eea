// Compatibility with the host's SQLite: the minimum version, and newer functions with their fallbacks.
//
//   require_version(sqlite3_libversion_number(), sqlite3_libversion());     // before all else
//   if (may_be_list(info, i)) return;
//
// An older SQLite passes a loadable extension a shorter table of functions; nothing beyond its end may be
// called. 3.31 is the oldest supported version: the first with INNOCUOUS, without which untrusted views could
// not be distinguished from trusted ones. Functions that SQLite added later are called only here, each with a
// fallback.
#pragma once

#include <string>
#include <vector>

#include "database/sqlite_api.h"

namespace foresee {

/// Throws Error if this version of SQLite is too old; the message names it and foresee's version.
void require_version(int number, const char* host);

/// Whether constraint `i` may be a list, `column IN (…)`. Always true before 3.38, which does not report it.
bool may_be_list(sqlite3_index_info& info, int i);

/// Whether the list of constraint `i` is better compared by SQLite, beside an equality `other` of another id: each
/// combination of two lists would be a call.
bool is_spare_list(sqlite3_index_info& info, int i, int other);

/// The statement that SQLite is preparing, to be compared alone; null outside of a preparation.
sqlite3_stmt* statement_in_preparation(sqlite3* db);

/// The value that constraint `i` compares with, if it is a literal in the statement; else, and before 3.38,
/// null.
sqlite3_value* written_value(sqlite3_index_info& info, int i);

/// The schemas of a connection in the order in which SQLite resolves an unqualified name: temp, main, the
/// attached ones. Before 3.39 an authorizer may forbid this query: StoreError.
std::vector<std::string> schema_names(sqlite3* db);

}  // namespace foresee
