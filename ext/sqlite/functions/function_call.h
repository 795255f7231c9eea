// A call of a table-valued function as xFilter passes it: the given inputs, the outputs that the statement
// reads, and the query's conditions on them.
//
//   const double h = call.required_number(in_h);
//   const std::string method = call.text(in_method).value_or("auto");
//
// A NULL input counts as left out. An input of the wrong kind is an Error that names the right one. A text in place of
// a number, or a number in place of a name, is often a wrong order: then the Error also shows the order of the inputs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "database/sqlite_api.h"
#include "sqlite/connection.h"

namespace foresee {

struct TableFunction;

// Values that a call uses for inputs that were left out, as SELECT now, tbl FROM predictive_join(60) returns
// them.
//
//   used.keep(in_now, 100.0);       // the call, when it has determined now
//   used.output(in_now, context);   // xColumn, when the statement reads the hidden column
//
// A given input is not kept here: it reads back unchanged, because SQLite may compare it again. Cost: some
// bytes per input.
class UsedInputs {
 public:
  using Value = std::variant<std::monostate, double, std::string>;

  void clear() { values_.clear(); }

  void keep(int input, Value value) { values_.emplace_back(input, std::move(value)); }

  /// Nothing if no value is kept for the input.
  Value find(int input) const {
    for (const auto& [place, value] : values_)
      if (place == input) return value;
    return {};
  }
  /// Leaves `context` at NULL if no value is kept for the input.
  void output(int input, sqlite3_context* context) const {
    const Value value = find(input);
    if (const auto* number = std::get_if<double>(&value)) sqlite3_result_double(context, *number);
    if (const auto* text = std::get_if<std::string>(&value))
      sqlite3_result_text(context, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
  }

 private:
  std::vector<std::pair<int, Value>> values_;
};

// LIMIT and OFFSET of a call, from xBestIndex to xFilter: the number of rows that will be read.
//
// SQLite offers them even if it checks further conditions itself. So they are taken only if the call applies
// all conditions: inputs, `a = 42`, bounds on times. Even then they are only a hint and SQLite applies them:
// a call returns more rows if more are read.

struct RowLimit {
  std::int64_t rows = -1;  ///< negative: all
  std::int64_t skipped = 0;

  /// The maximum number of rows that will be read; nothing if it is not known.
  std::optional<std::uint64_t> total() const {
    if (rows < 0) return {};
    return static_cast<std::uint64_t>(rows) + static_cast<std::uint64_t>(std::max<std::int64_t>(0, skipped));
  }
};

struct FreeValue {
  void operator()(sqlite3_value* value) const { sqlite3_value_free(value); }
};
using OwnedValue = std::unique_ptr<sqlite3_value, FreeValue>;

/// `output op value` from the WHERE clause. SQLite checks it again: using it is optional.
struct Condition {
  int output;
  int op;  ///< SQLITE_INDEX_CONSTRAINT_EQ, GT, GE, LT or LE
  sqlite3_value* value;
};

/// The arguments of a call, by their use.
struct Arguments {
  std::vector<sqlite3_value*> inputs = {};  ///< one per input of the function, null if it was left out
  std::vector<Condition> conditions = {};
  RowLimit limit = {};
  std::uint64_t columns_read = 0;   ///< one bit per column
  std::span<const int> order = {};  ///< the outputs by which rows must ascend
};

class FunctionCall {
 public:
  /// `used`: for the inputs that were left out. All references must outlive the call.
  FunctionCall(const TableFunction& function, Connection& connection, Arguments arguments, UsedInputs& used)
      : function_(function), connection_(connection), arguments_(std::move(arguments)), used_(used) {}

  Connection& connection() const { return connection_; }

  /// Nothing if it was left out. Throws Error for a value that is not a number, and for an integer that no
  /// double holds exactly.
  std::optional<double> number(int input) const;
  double required_number(int input) const;
  std::int64_t required_integer(int input) const;
  /// 32 bits, as a whole number from 0 to 4294967295; nothing if it was left out.
  std::optional<std::uint32_t> bits(int input) const;
  /// `kind`: the kind of text that is expected, for the message about a value that is not a text; null: a name.
  std::optional<std::string> text(int input, const char* kind = nullptr) const;

  /// The value as it was given; null if it was left out.
  sqlite3_value* value(int input) const { return arguments_.inputs[static_cast<std::size_t>(input)]; }
  /// Whether the function has an input of this number.
  bool has(int input) const { return static_cast<std::size_t>(input) < arguments_.inputs.size(); }

  const char* name_of(int input) const;

  /// Makes `input`, if it was left out, read back as this value. Requires: the same value in every call of one
  /// statement. Column `call` has it, a part of the key by which SQLite removes duplicate rows of an OR.
  void reads_back_as(int input, UsedInputs::Value of_call) const {
    if (!value(input)) used_.keep(input, std::move(of_call));
  }

  /// Whether the statement reads it; from the 64th column on, whether it reads any of them.
  bool reads(int output) const { return (arguments_.columns_read >> std::min(output, 63) & 1) != 0; }

  /// The integer that the query requires `output` to equal; nothing if it has no such condition.
  std::optional<std::int64_t> only(int output) const;
  /// The closed interval of `output` that the query's conditions allow, infinite where they set no bound. It
  /// contains every double that the query accepts.
  struct Bounds {
    double min, max;
  };
  Bounds bounds(int output) const;
  /// The outputs by which rows must ascend: one of the function's orders, or a prefix of one.
  std::span<const int> order() const { return arguments_.order; }
  const RowLimit& limit() const { return arguments_.limit; }

 private:
  [[noreturn]] void reject(int input, const char* kind, const std::string& remedy = {}) const;
  /// What to write in place of an input of the wrong type; "" for a blob and for an input far from the first ones.
  std::string remedy_of_type(int input) const;

  const TableFunction& function_;
  Connection& connection_;
  Arguments arguments_;
  UsedInputs& used_;
};

}  // namespace foresee
