// Compatibility with the host's SQLite: the minimum version, and newer functions with their fallbacks.
//
//   require_version(sqlite3_libversion_number(), sqlite3_libversion());     // before all else
//   if (may_be_list(info, i)) return;
//
// An older SQLite hands a loadable extension a shorter table of functions, and what lies beyond its end must
// not be called. 3.31 is the oldest that is loaded into: it was the first to know what INNOCUOUS means,
// without which untrusted views could not be distinguished from trusted ones. Every function of SQLite that
// came later is called here and nowhere else, with what is done without it.
#pragma once

#include <string>
#include <vector>

#include "storage/rows/sqlite_api.h"

namespace foresee {

/// Throws Error, which names foresee's version and this one, if this one is too old.
void require_version(int number, const char* host);

/// Is constraint `i` a list, `column IN (…)`? Before 3.38 SQLite does not say, so it may be one.
bool may_be_list(sqlite3_index_info& info, int i);

/// Where SQLite compares a column of a function with what turns out to be NULL, does it read the column
/// first, so that the function can refuse? 3.40 does; 3.53 does not: the row is lost without an error.
/// Other versions have not been tried and count as such.
bool reads_to_compare();

/// What constraint `i` compares with, where the statement writes it out; else, and before 3.38, null.
sqlite3_value* written_value(sqlite3_index_info& info, int i);

/// The schemas of a connection in the order in which SQLite looks a bare name up: temp, main, the attached
/// ones. (Before 3.39 an authorizer may forbid this query: StoreError.)
std::vector<std::string> schema_names(sqlite3* db);

}  // namespace foresee
