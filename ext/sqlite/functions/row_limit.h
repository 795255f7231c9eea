// How many rows of a call will be read? LIMIT and OFFSET on their way from xBestIndex to xFilter.
//
// SQLite offers them also where conditions remain that it checks itself. So they are taken only where the
// call leaves out what does not meet a condition: inputs, `a = 42`, bounds on times. Even then they are no
// more than a hint, and SQLite applies them: a call that is asked for more rows gives them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "storage/rows/sqlite_api.h"

namespace foresee {

struct TableFunction;

struct RowLimit {
  std::int64_t rows = -1;  ///< negative: all
  std::int64_t skipped = 0;

  /// How many rows will be read at most; nothing where that is not known.
  std::optional<std::uint64_t> in_all() const {
    if (rows < 0) return {};
    return static_cast<std::uint64_t>(rows) + static_cast<std::uint64_t>(std::max<std::int64_t>(0, skipped));
  }
};

/// Has LIMIT and OFFSET handed over, two letters each behind the plan's arguments; neither where SQLite
/// checks a condition that the call does not heed itself. Requires: all other constraints have been taken.
void take_row_limit(const TableFunction& function, sqlite3_index_info& info, std::string& arguments);

/// Takes an argument by its letters into `limit`. False, and nothing is taken, if it is neither of the two.
bool read_row_limit(const char* letters, sqlite3_value* value, RowLimit& limit);

}  // namespace foresee
