// In what way will SQLite call a table-valued function? From xBestIndex to xFilter.
//
//   idxNum   the outputs that the statement reads, one bit each; of a function with orders from bit 16 on
//            the one that rows must come in: how many of its outputs, and from bit 20 on which of them
//   idxStr   two letters per argument: 'A' + column, then the comparison ('=' '>' 'G' '<' 'L'), or '!' for an
//            input that SQLite compares once more, or '@' and 'n' or 'o': function_call.h
//
// Constraints on inputs are consumed; those on outputs are hints that SQLite checks again. Where it does so
// with an input, a NULL would lose every row, since no comparison with NULL is true: such a call must be
// refused. LIMIT and OFFSET are hints too (function_call.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "sqlite/functions/table_function.h"

namespace foresee {

/// What SQLite was told before, in planning the same statement.
struct PlansBefore {
  bool or_loses_rows = false;
  bool one_side_was_planned = false;  ///< of an OR, by itself
};

/// xBestIndex: fills in `info`. A result code: SQLITE_CONSTRAINT where an input comes from a row that is not
/// there yet, SQLITE_NOMEM.
int plan_call(const TableFunction& function, const Connection& connection, PlansBefore& before,
              sqlite3_index_info& info);

// What a plan says.
struct PlannedArgument {
  const char* letters;  ///< its two in idxStr
  int column;
  int op;               ///< of an output: SQLITE_INDEX_CONSTRAINT_EQ, GT, GE, LT or LE
  bool compared_again;  ///< an input, by SQLite
};
/// Requires: `argument` is less than the number of arguments that xFilter is given.
PlannedArgument planned_argument(const char* plan, std::size_t argument);
/// Bit set: the statement reads this output.
std::uint32_t planned_outputs(const TableFunction& function, int plan);
/// The outputs by which rows must come, rising; none: in any order.
std::span<const int> planned_order(const TableFunction& function, int plan);

}  // namespace foresee
