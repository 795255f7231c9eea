// Inputs of the geographic SQL functions: places, speeds and courses, read from a call.
//
// A NULL place gives a row of NULLs; a NULL speed or course gives a place without velocity. Position reports
// may lack either, and AIS values for "not available" must be written as NULL. A latitude outside of -90 to
// 90 and an infinite number are an Error.
//
// The hidden inputs are in_lat, in_x and so on: `FROM reports r, geo_to_plane(lat, lon, …)` would be
// ambiguous if an input had the name of the users' column.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geography/ellipsoid.h"
#include "sqlite/functions/call_estimate.h"
#include "sqlite/functions/function_call.h"
#include "sqlite/functions/table_function.h"

namespace foresee {

/// Latitude and longitude; nothing if either is NULL. `lat`: its input; the longitude is the next one.
std::optional<LatLon> place_input(const FunctionCall& call, int lat);

/// The point at which the plane touches the Earth. Throws Error if either input is NULL.
LatLon origin_of(const FunctionCall& call, int lat0);

/// Speed and course; nothing if either is NULL. `speed`: its input; the course is the next one.
std::optional<Course> course_input(const FunctionCall& call, int speed);

/// The input's number, nothing if it is NULL. Throws Error if it is infinite.
std::optional<double> finite_number(const FunctionCall& call, int input);

/// Throws Error unless `lat` is from -90 to 90. `name`: the input's name, for the message.
void require_latitude(double lat, const char* name);

/// The estimate of a call that computes one row from its inputs.
CallEstimate estimate_one_row(const CallSizes& sizes);

// Result of a call that computes a single row of numbers from its inputs.

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
