#include "sqlite/functions/geo/geo_inputs.h"

#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "sqlite/functions/table_function.h"

namespace foresee {

std::optional<double> finite_number(const FunctionCall& call, int input) {
  const auto given = call.number(input);
  if (given && !std::isfinite(*given)) throw Error(std::string(call.name_of(input)) + " is infinite");
  return given;
}

void require_latitude(double lat, const char* name) {
  if (std::abs(lat) <= 90) return;
  throw Error(std::string(name) + " is " + shown(lat) +
              ": latitudes lie between -90 and 90; write NULL if it is unknown, as nullif(" + name +
              ", 91) does for AIS");
}

std::optional<LatLon> place_input(const FunctionCall& call, int lat) {
  const auto north = finite_number(call, lat), east = finite_number(call, lat + 1);
  if (!north || !east) return std::nullopt;
  require_latitude(*north, call.name_of(lat));
  return LatLon{*north, *east};
}

LatLon origin_of(const FunctionCall& call, int lat0) {
  call.required_number(lat0);
  call.required_number(lat0 + 1);
  return *place_input(call, lat0);
}

std::optional<Course> course_input(const FunctionCall& call, int speed) {
  const auto fast = finite_number(call, speed), degrees = finite_number(call, speed + 1);
  if (!fast || !degrees) return std::nullopt;
  return Course{*fast, *degrees};
}

CallEstimate estimate_one_row(const CallSizes&) {
  return {1, 1};
}

}  // namespace foresee
