// Result of a call that computes a single row of numbers from its inputs.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sqlite/functions/table_function.h"

namespace foresee {

class OneRow final : public FunctionRows {
 public:
  /// An output without a number, or beyond the last one, is NULL.
  explicit OneRow(std::vector<std::optional<double>> numbers) : numbers_(std::move(numbers)) {}

  bool next() override { return std::exchange(left_, false); }
  void output(sqlite3_context* context, int output) const override {
    const auto place = static_cast<std::size_t>(output);
    if (place < numbers_.size() && numbers_[place]) sqlite3_result_double(context, *numbers_[place]);
  }

 private:
  std::vector<std::optional<double>> numbers_;
  bool left_ = true;
};

}  // namespace foresee
