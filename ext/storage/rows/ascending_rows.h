// Rows whose first column is a number, each larger than the one before it.
//
//   read_ascending(statement, {"ships", "map"}, [&](std::int64_t id, Statement::Run& run) { … });
//
// Anything else is SQLITE_CORRUPT_VTAB: pages of a damaged file may lead back to one another, and a reader
// that believes them never ends.
#pragma once

#include <optional>

#include "storage/rows/statement.h"

namespace foresee {

/// For messages: the virtual table, and what stands behind `<table>_`.
struct RowsOf {
  const std::string& table;
  const char* suffix;
};

/// The number of the row on which `run` stands, behind the row `last` if there was one.
std::int64_t number_after(std::optional<std::int64_t> last, Statement::Run& run, const RowsOf& rows);

/// Calls read(number, run) with every row of a statement.
template <class Read>
void read_ascending(Statement& statement, const RowsOf& rows, Read read) {
  Statement::Run run(statement);
  for (std::optional<std::int64_t> last; run.step(); read(*last, run)) last = number_after(last, run, rows);
}

}  // namespace foresee
