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
              ": latitudes lie between -90 and 90; write NULL if it is unknown, as nullif(lat, 91) does for "
              "AIS");
}

std::optional<LatLon> place_input(const FunctionCall& call, int lat) {
  const auto lat_value = finite_number(call, lat), lon_value = finite_number(call, lat + 1);
  if (!lat_value || !lon_value) return std::nullopt;
  require_latitude(*lat_value, call.name_of(lat));
  return LatLon{*lat_value, *lon_value};
}

LatLon origin_of(const FunctionCall& call, int lat0) {
  call.required_number(lat0);
  call.required_number(lat0 + 1);
  return *place_input(call, lat0);
}

std::optional<Course> course_input(const FunctionCall& call, int speed) {
  const auto speed_value = finite_number(call, speed), degrees = finite_number(call, speed + 1);
  if (!speed_value || !degrees) return std::nullopt;
  return Course{*speed_value, *degrees};
}

CallEstimate estimate_one_row(const CallSizes&) {
  return {1, 1};
}

}  // namespace foresee
