// Query plan of a call of a table-valued function: xBestIndex encodes it in idxNum and idxStr, xFilter
// decodes it.
//
//   idxNum   the order in which rows must come: bits 0 to 3 hold its number of outputs, 0 for any order, and bit 4
//            upwards its index
//   idxStr   SQLite's colUsed in 16 hexadecimal digits, one bit per column that the statement reads; then two letters
//            per argument: 'A' + column, then the comparison ('=' '>' 'G' '<' 'L'), or '!' for an input that SQLite
//            compares again; or '@' and then 'n' (LIMIT) or 'o' (OFFSET)
//
// Constraints on inputs are consumed; those on outputs are conditions, which SQLite checks again. If SQLite
// compares an input again and it is NULL, no row would pass: such a call must be refused. LIMIT and OFFSET are
// hints (function_call.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "database/sqlite_api.h"
#include "sqlite/functions/table_function.h"

namespace foresee {

/// What the plans of a statement have shown. SQLite may give a later statement the same address: what is left of one
/// that was prepared and never run may make its plan slower, or a NULL refused.
struct EarlierPlans {
  using Condition = sqlite3_index_info::sqlite3_index_constraint;

  sqlite3_stmt* statement = nullptr;
  std::vector<Condition> call;    ///< all of the last call that was not a side of an OR
  bool null_inputs = false;       ///< one of its inputs is, or may be, NULL
  bool side_was_planned = false;  ///< of an OR
};

/// The work of xBestIndex: fills in `info`. Returns SQLITE_OK, SQLITE_NOMEM, or SQLITE_CONSTRAINT if an input
/// comes from a table that this plan reads later. Throws Error if an input is compared with <, <=, > or >=.
int plan_call(const TableFunction& function, const Connection& connection, EarlierPlans& earlier,
              sqlite3_index_info& info);

// Decoding of a plan.
struct PlannedArgument {
  int column;
  int op;               ///< of an output: SQLITE_INDEX_CONSTRAINT_EQ, GT, GE, LT or LE
  bool compared_again;  ///< an input, by SQLite
};
/// Requires: `argument` is less than the number of xFilter's arguments.
PlannedArgument planned_argument(const char* plan, std::size_t argument);
/// Stores an argument in `limit` if it is LIMIT or OFFSET; else false.
bool read_row_limit(const char* plan, std::size_t argument, sqlite3_value* value, RowLimit& limit);
/// One bit per column, set if the statement reads it; the last one for all further columns too.
std::uint64_t planned_columns(const char* plan);
/// One bit per input, set if the statement reads it.
inline std::uint32_t inputs_read(const TableFunction& function, std::uint64_t columns_read) {
  const std::uint64_t all = (std::uint64_t{1} << function.inputs.size()) - 1;
  return static_cast<std::uint32_t>(columns_read >> std::min<std::size_t>(function.outputs.size(), 63) & all);
}
/// The outputs by which rows must ascend; empty: in any order.
std::span<const int> planned_order(const TableFunction& function, int order);

}  // namespace foresee
