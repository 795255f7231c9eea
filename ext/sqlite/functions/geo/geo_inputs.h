// What the geographic functions are asked: places, courses, speeds.
//
// A place that is NULL gives a row of NULLs, a speed or course that is NULL gives a place without velocity:
// reports lack both, and what AIS sends for "not available" is to be written as NULL. Numbers that are none
// of the Earth are an Error.
#pragma once

#include <optional>

#include "geography/ellipsoid.h"
#include "sqlite/functions/call_estimate.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

/// Nothing where one of the two is NULL. `lat`: the input; its longitude follows it.
std::optional<LatLon> place_input(const FunctionCall& call, int lat);

/// Where a plane touches the Earth: both must be there.
LatLon origin_of(const FunctionCall& call, int lat0);

/// Nothing where one of the two is NULL. `speed`: the input; the course follows it.
std::optional<Course> course_input(const FunctionCall& call, int speed);

/// A number that is not infinite.
std::optional<double> finite_number(const FunctionCall& call, int input);

/// Throws Error unless it is a latitude. `name`: of the input, for the message.
void require_latitude(double lat, const char* name);

/// One row of numbers from numbers.
CallEstimate estimate_one_row(const CallSizes& sizes);

}  // namespace foresee
