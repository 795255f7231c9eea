// Is a text a date? Moments are numbers, and who has dates is told how to make numbers of them.
#pragma once

#include <optional>
#include <string>

#include "storage/rows/sqlite_api.h"

namespace foresee {

/// "unixepoch('2026-11-21 12:00')" for such a text; nothing for another value.
std::optional<std::string> as_unixepoch(sqlite3_value* value);

}  // namespace foresee
