// One call of a table-valued function as SQLite hands it over: which inputs were given, which outputs are
// read, and what the query asks of them.
//
//   const double h = call.required_number(in_h);
//   const std::string method = call.text(in_method).value_or("auto");
//
// A NULL input counts as left out. An input of the wrong kind is an Error that says what to write.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sqlite/connection.h"
#include "sqlite/functions/row_limit.h"
#include "sqlite/functions/used_inputs.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

struct TableFunction;

struct FreeValue {
  void operator()(sqlite3_value* value) const { sqlite3_value_free(value); }
};
using OwnedValue = std::unique_ptr<sqlite3_value, FreeValue>;

/// `output op value` from the WHERE clause. SQLite checks it again: using it is optional.
struct Hint {
  int output;
  int op;  ///< SQLITE_INDEX_CONSTRAINT_EQ, GT, GE, LT or LE
  sqlite3_value* value;
};

class FunctionCall {
 public:
  FunctionCall(const TableFunction& function, Connection& connection, std::span<sqlite3_value* const> inputs,
               std::vector<Hint> hints, std::uint32_t outputs_read, std::span<const int> order,
               const RowLimit& limit, UsedInputs& used)
      : function_(function),
        connection_(connection),
        inputs_(inputs),
        hints_(std::move(hints)),
        outputs_read_(outputs_read),
        order_(order),
        limit_(limit),
        used_(used) {}

  Connection& connection() const { return connection_; }

  /// Nothing where it was left out. Error for what is no number, and for an integer that no double holds.
  std::optional<double> number(int input) const;
  double required_number(int input) const;
  std::int64_t required_integer(int input) const;
  /// `kind`: what it must be, for the message about what is no text.
  std::optional<std::string> text(int input,
                                  const char* kind = "a name in quotes, or NULL to leave it out") const;

  const char* name_of(int input) const;

  /// Where `input` was left out it reads back as `value`. The same in every call of one statement: SQLite
  /// tells rows apart by their inputs too where it unites the two sides of an OR.
  void used(int input, UsedInputs::Value value) const {
    if (!inputs_[static_cast<std::size_t>(input)]) used_.keep(input, std::move(value));
  }

  bool reads(int output) const { return (outputs_read_ >> output & 1) != 0; }

  /// The integer that the query wants `output` to be, if it does.
  std::optional<std::int64_t> only(int output) const;
  /// What the query wants `output` to lie between, both ends included; infinite where it does not say. No
  /// double that the query takes lies outside.
  struct Bounds {
    double least, most;
  };
  Bounds bounds(int output) const;
  /// The outputs by which rows must come, rising: one of the function's orders, or its beginning.
  std::span<const int> order() const { return order_; }
  const RowLimit& limit() const { return limit_; }

 private:
  [[noreturn]] void reject(int input, const char* kind) const;

  const TableFunction& function_;
  Connection& connection_;
  std::span<sqlite3_value* const> inputs_;  ///< one per input, null where it was left out
  std::vector<Hint> hints_;
  std::uint32_t outputs_read_;
  std::span<const int> order_;
  RowLimit limit_;
  UsedInputs& used_;
};

}  // namespace foresee
