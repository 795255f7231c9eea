// What does a call use for its inputs that were left out? So that SELECT now, tbl FROM predictive_join(60)
// tells.
//
//   used.keep(in_now, 100.0);       // by the call, once it knows
//   used.output(in_now, context);   // for who reads the hidden column
//
// An input that was given is not asked for here: it reads back as given, since SQLite may compare it once
// more. Cost: some bytes an input, as many calls as there are.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "storage/rows/sqlite_api.h"

namespace foresee {

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

}  // namespace foresee
