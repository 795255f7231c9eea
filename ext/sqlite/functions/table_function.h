// Table-valued functions: the virtual table that predictive_join and the other functions share.
//
//   const TableFunction positions = {
//       .name = "predictive_position",
//       .outputs = {"id INTEGER", "x REAL"},
//       .inputs = {"at", "tbl"},                // hidden columns, in call order; the first one is required
//       .key = "id",
//       .hinted = 0,
//       .estimate = estimate_positions,
//       .start = [](const FunctionCall& call) -> std::unique_ptr<FunctionRows> { … }};
//
// All functions are read-only, need no CREATE, and may be used in views and untrusted triggers.
// An input can be given by place or by name in WHERE. Rows are pulled one at a time; whatever start() or
// next() throws becomes the statement's error, led by the function's name.
//
// The key is declared as WITHOUT ROWID does: SQLite uses it to drop the rows that `a = ? OR b = ?` finds
// twice. The inputs belong to it, because rows of different calls are different rows.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sqlite/functions/call_estimate.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

/// The rows of one call, and the tables as they were when it started.
class FunctionRows {
 public:
  virtual ~FunctionRows() = default;
  /// Steps to the first or next row; false at the end.
  virtual bool next() = 0;
  /// Hands an output of the current row to `context`; leaves it alone for NULL.
  virtual void output(sqlite3_context* context, int output) const = 0;
};

struct TableFunction {
  const char* name;
  std::vector<const char*> outputs;  ///< name and type
  std::vector<const char*> inputs;   ///< names
  const char*
      key;  ///< the outputs that tell the rows of one call apart, never NULL; null: a call has one row
  std::uint32_t hinted;  ///< bit set: constraints on these outputs may make the call cheaper
  CallEstimate (*estimate)(const CallSizes& sizes);  ///< of a whole call
  std::unique_ptr<FunctionRows> (*start)(const FunctionCall& call);
  std::uint32_t probed = 0;  ///< of those: one value of them makes the call much cheaper
  /// Of a call with such a value: of the first output, or of another.
  CallEstimate (*estimate_probe)(const CallSizes& sizes, bool by_first) = nullptr;
  std::vector<std::vector<int>> orders = {};  ///< outputs by which rows can come, rising
};

/// The function with its inputs, as messages show it: predictive_position(at, tbl).
std::string usage(const TableFunction& function);

/// `function` must live as long as the program.
int register_table_function(sqlite3* db, const TableFunction& function,
                            std::shared_ptr<Connection> connection);

}  // namespace foresee
