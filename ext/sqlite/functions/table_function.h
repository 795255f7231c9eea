// Table-valued functions: the virtual table that predictive_join and the other functions share.
//
//   const TableFunction positions = {
//       .name = "predictive_position",
//       .outputs = {"id INTEGER", "x REAL"},    // ColumnList (columns.h), where a place is needed
//       .inputs = {"at", "tbl"},                // hidden columns, in call order; the first one is required
//       .key = "id",
//       .hinted = 0,
//       .estimate = estimate_positions,
//       .start = [](const FunctionCall& call) -> std::unique_ptr<FunctionRows> { … }};
//
// All functions are read-only, need no CREATE, and may be used in views and untrusted triggers. An input can be given
// by position, or by name in WHERE. Rows are given one at a time; a function may compute them in batches. An exception
// of start() or next() becomes the statement's error, prefixed by the function's name.
//
// The key is declared as the primary key of a WITHOUT ROWID table: by it SQLite drops the rows that `a = ? OR
// b = ?` finds twice. A last hidden column, `call`, is part of it, because rows of different calls are different rows:
// it holds all inputs, or a hash of long ones. The inputs themselves are not, because SQLite 3.53 says of a key that
// every statement reads it.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "sqlite/functions/call_estimate.h"
#include "sqlite/functions/columns.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

/// The rows of one call, computed from the tables as they were at its start.
class FunctionRows {
 public:
  virtual ~FunctionRows() = default;
  /// Steps to the first or next row; false at the end.
  virtual bool next() = 0;
  /// Sets the result of `context` to an output of the current row; leaves it unset for NULL.
  virtual void output(sqlite3_context* context, int output) const = 0;
};

struct TableFunction {
  const char* name;
  std::vector<const char*> outputs;  ///< name and type; ColumnList, where their places are used (columns.h)
  std::vector<const char*> inputs;   ///< names, likewise
  /// The outputs that identify a row of a call; a time that the statement does not read is NULL in all rows. Null: a
  /// call has one row.
  const char* key;
  std::uint32_t hinted;  ///< bit set: constraints on this output may reduce the cost of a call
  CallEstimate (*estimate)(const CallSizes& sizes);  ///< of a whole call
  std::unique_ptr<FunctionRows> (*start)(const FunctionCall& call);
  std::uint32_t probed = 0;  ///< bit set: equality with this hinted output makes a call much cheaper
  /// The estimate of a call with such an equality. `by_first`: on the first output, else on another one.
  CallEstimate (*estimate_probe)(const CallSizes& sizes, bool by_first) = nullptr;
  std::vector<std::vector<int>> orders = {};  ///< in which rows can come: ascending by these outputs.
  /// Bit set: an input that has no value where it is left out. A statement that reads it then compares it in a place
  /// that SQLite does not pass on, and would lose every row without an error. It is refused.
  std::uint32_t unread_if_left_out = 0;
};

/// The function with its inputs in order, as messages show it: predictive_position(at, tbl). Of more than `inputs`
/// the first ones: predictive_join(h, tbl, ...).
std::string usage(const TableFunction& function,
                  std::size_t inputs = std::numeric_limits<std::size_t>::max());

/// `function` must live as long as the program.
int register_table_function(sqlite3* db, const TableFunction& function,
                            std::shared_ptr<Connection> connection);

}  // namespace foresee
