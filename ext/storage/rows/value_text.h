// Text that comes out of SQLite, as long as it is: a NUL does not end it. And values as messages show them.
//
//   text_of(argument) == "ships"            // false for 'ships' || char(0) || 'x'
//
// A text in UTF-16 becomes UTF-8 when it is asked for, which takes memory.
#pragma once

#include <cstddef>
#include <string>

#include "storage/rows/sqlite_api.h"

namespace foresee {

/// A value as text, "" for NULL. Throws std::bad_alloc out of memory.
std::string text_of(sqlite3_value* value);
/// Of a text that is longer than `limit` bytes only the beginning, without a part of a character.
std::string text_of(sqlite3_stmt* row, int column, std::size_t limit = std::string::npos);

/// Both mean that a value was left out.
bool is_null_or_empty(sqlite3_value* value);

/// For a message, which a NUL would end: each one as \0.
std::string without_nul(std::string text);

/// A value as a message shows it: 1.5, 'text' (its beginning, if it is long), a blob of 2 bytes, NULL.
std::string shown(sqlite3_value* value);

}  // namespace foresee
