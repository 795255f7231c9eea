// Text of SQLite values in full length, also with NUL characters, and values as messages show them.
//
//   text_of(argument) == "ships"            // false for 'ships' || char(0) || 'x'
//
// A text in UTF-16 is converted to UTF-8, which allocates memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "database/sqlite_api.h"

namespace foresee {

/// The value as text; "" for NULL. Throws std::bad_alloc without memory.
std::string text_of(sqlite3_value* value);
/// A column of `row` as text; a longer text is cut off after at most `limit` bytes, between characters.
std::string text_of(sqlite3_stmt* row, int column, std::size_t limit = std::string::npos);

/// True for NULL and for an empty text, which both mean that a value was left out.
bool is_null_or_empty(sqlite3_value* value);

/// True for an integer that no double equals, such as 2^53 + 1, and for the text of one.
bool is_inexact(sqlite3_value* value);

/// The first `limit` bytes at most, cut off between characters.
std::string_view cut_off(std::string_view text, std::size_t limit);

/// For messages, which a NUL would end: replaces each NUL by \0.
std::string without_nul(std::string text);

/// The value as a message shows it: 1.5, 'text' (cut off if it is long), a blob of 2 bytes, NULL.
std::string shown(sqlite3_value* value);

// Recognizes date texts. Times are numbers, so the error message for a date says how to convert it.

/// "unixepoch('2026-11-21 12:00')" for a text that starts with a date, or is 'now'; nothing for another value.
std::optional<std::string> as_unixepoch(sqlite3_value* value);

}  // namespace foresee
