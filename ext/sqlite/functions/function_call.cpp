#include "sqlite/functions/function_call.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/integer_of.h"
#include "database/value_text.h"
#include "sqlite/functions/table_function.h"

namespace foresee {

namespace {

constexpr int inputs_by_place = 5;  // further ones are given by name, and in messages they would be too long

/// The input that a message names as an example: within, or the first one.
std::string example_input(const TableFunction& function) {
  for (const std::string_view name : function.inputs)
    if (name == "within") return "within";
  return function.inputs.front();
}

}  // namespace

void FunctionCall::reject(int input, const char* kind, const std::string& remedy) const {
  throw Error(std::string(name_of(input)) + " must be " + kind + ", not " + shown(value(input)) + remedy);
}

std::string FunctionCall::remedy_of_type(int input) const {
  const int type = sqlite3_value_type(value(input));
  if (const auto seconds = as_unixepoch(value(input))) return ": write " + *seconds;
  if (type == SQLITE_BLOB || input >= inputs_by_place) return "";
  const std::string order = ": write " + usage(function_, inputs_by_place);
  // f(300, within = 60) passes the result of a comparison, a number, in the place of the table.
  const bool may_be_comparison = std::string_view(name_of(input)) == "tbl" && type != SQLITE_TEXT;
  return may_be_comparison ? order + ", or WHERE " + example_input(function_) + " = 60" : order;
}

const char* FunctionCall::name_of(int input) const {
  return function_.inputs[static_cast<std::size_t>(input)];
}

std::optional<double> FunctionCall::number(int input) const {
  sqlite3_value* value = this->value(input);
  if (!value) return std::nullopt;
  const int type = sqlite3_value_numeric_type(value);
  if (type != SQLITE_INTEGER && type != SQLITE_FLOAT) reject(input, "a number", remedy_of_type(input));
  if (is_inexact(value)) reject(input, "a number that a double holds exactly");
  return sqlite3_value_double(value);
}

double FunctionCall::required_number(int input) const {
  if (const auto given = number(input)) return *given;
  const std::string name = name_of(input);
  throw Error(name + " is missing or NULL: write " + usage(function_));
}

std::int64_t FunctionCall::required_integer(int input) const {
  sqlite3_value* value = this->value(input);
  if (value && sqlite3_value_numeric_type(value) == SQLITE_INTEGER) return sqlite3_value_int64(value);
  if (const auto integer = integer_of(required_number(input))) return *integer;
  reject(input, "a whole number");
}

std::optional<std::uint32_t> FunctionCall::bits(int input) const {
  constexpr double max = std::numeric_limits<std::uint32_t>::max();
  if (!value(input)) return std::nullopt;
  constexpr const char* kind = "a whole number from 0 to 4294967295";
  const int type = sqlite3_value_numeric_type(value(input));
  if (type != SQLITE_INTEGER && type != SQLITE_FLOAT) reject(input, kind, remedy_of_type(input));
  const double number = sqlite3_value_double(value(input));
  if (!(0 <= number && number <= max && integer_of(number))) reject(input, kind);
  return static_cast<std::uint32_t>(number);
}

std::optional<std::string> FunctionCall::text(int input, const char* kind) const {
  sqlite3_value* value = this->value(input);
  if (!value) return std::nullopt;
  if (sqlite3_value_type(value) == SQLITE_TEXT) return text_of(value);
  if (kind) reject(input, kind);
  reject(input, "a name in quotes, or NULL to leave it out", remedy_of_type(input));
}

std::optional<std::int64_t> FunctionCall::only(int output) const {
  for (const Condition& condition : arguments_.conditions) {
    if (condition.output != output || condition.op != SQLITE_INDEX_CONSTRAINT_EQ) continue;
    const int type = sqlite3_value_numeric_type(condition.value);
    if (type == SQLITE_INTEGER) return sqlite3_value_int64(condition.value);
    if (type != SQLITE_FLOAT) continue;
    if (const auto integer = integer_of(sqlite3_value_double(condition.value))) return integer;
  }
  return std::nullopt;
}

FunctionCall::Bounds FunctionCall::bounds(int output) const {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Bounds bounds{-inf, inf};
  for (const Condition& condition : arguments_.conditions) {
    if (condition.output != output) continue;
    const int type = sqlite3_value_numeric_type(condition.value);
    if (type != SQLITE_INTEGER && type != SQLITE_FLOAT) continue;
    const double number = sqlite3_value_double(condition.value);
    const bool exact = !is_inexact(condition.value);  // else it may be on either side of its nearest double
    const double below = std::nextafter(number, -inf), above = std::nextafter(number, inf);
    if (condition.op == SQLITE_INDEX_CONSTRAINT_GT) bounds.min = std::max(bounds.min, exact ? above : below);
    if (condition.op == SQLITE_INDEX_CONSTRAINT_GE || condition.op == SQLITE_INDEX_CONSTRAINT_EQ)
      bounds.min = std::max(bounds.min, exact ? number : below);
    if (condition.op == SQLITE_INDEX_CONSTRAINT_LT) bounds.max = std::min(bounds.max, exact ? below : above);
    if (condition.op == SQLITE_INDEX_CONSTRAINT_LE || condition.op == SQLITE_INDEX_CONSTRAINT_EQ)
      bounds.max = std::min(bounds.max, exact ? number : above);
  }
  return bounds;
}

}  // namespace foresee
