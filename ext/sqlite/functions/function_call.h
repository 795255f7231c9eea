// One call of a table-valued function as SQLite hands it over: which inputs were given, which outputs are
// read, and what the query asks of them.
//
//   const double h = call.required_number(in_h);
//   const std::string method = call.text(in_method).value_or("auto");
//
// A NULL input counts as left out. An input of the wrong kind is an Error that says what to write.
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

#include "sqlite/connection.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

// What does a call use for its inputs that were left out? So that SELECT now, tbl FROM predictive_join(60)
// tells.
//
//   used.keep(in_now, 100.0);       // by the call, once it knows
//   used.output(in_now, context);   // for who reads the hidden column
//
// An input that was given is not asked for here: it reads back as given, since SQLite may compare it once
// more. Cost: some bytes an input, as many calls as there are.

class UsedInputs {
 public:
  using Value = std::variant<std::monostate, double, std::string>;

  void clear() { values_.clear(); }

  void keep(int input, Value value) { values_.emplace_back(input, std::move(value)); }

  /// Leaves `context` alone, which is NULL, where nothing stands for the input.
  void output(int input, sqlite3_context* context) const {
    for (const auto& [place, value] : values_) {
      if (place != input) continue;
      if (const auto* number = std::get_if<double>(&value)) sqlite3_result_double(context, *number);
      if (const auto* text = std::get_if<std::string>(&value))
        sqlite3_result_text(context, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
    }
  }

 private:
  std::vector<std::pair<int, Value>> values_;
};

// How many rows of a call will be read? LIMIT and OFFSET on their way from xBestIndex to xFilter.
//
// SQLite offers them also where conditions remain that it checks itself. So they are taken only where the
// call leaves out what does not meet a condition: inputs, `a = 42`, bounds on times. Even then they are no
// more than a hint, and SQLite applies them: a call that is asked for more rows gives them.

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
    double min, max;
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
