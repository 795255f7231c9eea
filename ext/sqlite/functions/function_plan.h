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

#include <cstddef>
#include <cstdint>
#include <span>

#include "sqlite/functions/table_function.h"

namespace foresee {

/// What earlier plans of the same statement have shown. SQLite does not say where a statement starts: what a statement
/// has shown that was planned and not run may make the next plan slower, or a NULL refused.
struct EarlierPlans {
  bool or_loses_rows = false;         ///< the plan of one side of an OR would
  bool one_side_was_planned = false;  ///< one side of an OR was planned separately
};

/// The work of xBestIndex: fills in `info`. Returns SQLITE_OK, SQLITE_NOMEM, or SQLITE_CONSTRAINT if an input
/// comes from a table that this plan reads later.
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
/// The outputs by which rows must ascend; empty: in any order.
std::span<const int> planned_order(const TableFunction& function, int order);

}  // namespace foresee
