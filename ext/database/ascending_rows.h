// Reads rows whose first column is an integer that ascends strictly; any other order is damage.
//
//   read_ascending(statement, {"ships", "map"}, [&](std::int64_t id, Statement::Run& run) { … });
//
// Other rows are SQLITE_CORRUPT_VTAB: in a damaged file pages may refer back to one another, and a scan
// without this check would never end. compare_ascending() merges such rows with a sorted list.
#pragma once

#include <functional>
#include <optional>

#include "database/sqlite_api.h"
#include "database/statement.h"

namespace foresee {

/// For messages: the virtual table, and the suffix after `<table>_`.
struct RowsOf {
  const std::string& table;
  const char* suffix;
};

/// The number of the current row of `run`. Throws unless it is larger than `last`, the previous one, if any.
std::int64_t number_after(std::optional<std::int64_t> last, Statement::Run& run, const RowsOf& rows);

/// Calls read(number, run) for every row of a statement.
template <class Read>
void read_ascending(Statement& statement, const RowsOf& rows, Read read) {
  Statement::Run run(statement);
  for (std::optional<std::int64_t> last; run.step(); read(*last, run)) last = number_after(last, run, rows);
}

inline std::int64_t number_after(std::optional<std::int64_t> last, Statement::Run& run, const RowsOf& rows) {
  const auto damaged = [&](const std::string& what) {
    throw StoreError(SQLITE_CORRUPT_VTAB,
                     rows.table + ": " + rows.table + "_" + rows.suffix + " is damaged: " + what);
  };
  if (!run.is_integer(0)) damaged("the number of a row is not an integer");
  const std::int64_t number = run.integer(0);
  if (last && number <= *last)
    damaged("row " + std::to_string(number) + " comes after row " + std::to_string(*last));
  return number;
}

/// Calls only_left(item) for the items without a row, only_right(id, …) for the rows without an item, and
/// both(item, …) for the rest, ids ascending. `read` calls its argument with (id, …) for each row. Requires: the ids of
/// `items` ascend.
template <class Items, class Id, class Read, class OnlyLeft, class OnlyRight, class Both>
void compare_ascending(const Items& items, Id id_of, Read read, OnlyLeft only_left, OnlyRight only_right,
                       Both both) {
  auto next = items.begin();
  read([&](std::int64_t id, auto... columns) {
    for (; next != items.end() && std::invoke(id_of, *next) < id; ++next) only_left(*next);
    if (next != items.end() && std::invoke(id_of, *next) == id)
      both(*next++, columns...);
    else
      only_right(id, columns...);
  });
  for (; next != items.end(); ++next) only_left(*next);
}

}  // namespace foresee
