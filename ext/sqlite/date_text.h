// Recognizes date texts. Times are numbers, so the error message for a date says how to convert it.
#pragma once

#include <optional>
#include <string>

#include "storage/rows/sqlite_api.h"

namespace foresee {

/// "unixepoch('2026-11-21 12:00')" for a text that starts with a date, or is 'now'; nothing for another value.
std::optional<std::string> as_unixepoch(sqlite3_value* value);

}  // namespace foresee
