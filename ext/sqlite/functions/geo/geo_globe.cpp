// geo_to_globe(lat, lon, …) and globe_to_geo(x, y, z, …) in SQL.
#include <cmath>

#include "base/float_environment.h"
#include "geography/globe.h"
#include "sqlite/functions/geo/geo_inputs.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

constexpr ColumnList to_globe_inputs{"in_lat", "in_lon", "in_height", "in_speed", "in_course", "in_climb"};
constexpr ColumnList from_globe_inputs{"in_x", "in_y", "in_z", "in_vx", "in_vy", "in_vz"};

std::unique_ptr<FunctionRows> start_to_globe(const FunctionCall& call) {
  const FloatEnvironment environment;
  constexpr int in_lat = to_globe_inputs["in_lat"], in_height = to_globe_inputs["in_height"],
                in_speed = to_globe_inputs["in_speed"], in_climb = to_globe_inputs["in_climb"];
  const auto place = place_input(call, in_lat);
  if (!place) return std::make_unique<OneRow>(std::vector<std::optional<double>>{});
  const OnGlobe point = to_globe({{*place, course_input(call, in_speed)},
                                  finite_number(call, in_height).value_or(0),
                                  finite_number(call, in_climb).value_or(0)});
  std::vector<std::optional<double>> row(point.x.begin(), point.x.end());
  if (point.motion)
    for (const auto& numbers : {point.motion->v, point.motion->a})
      row.insert(row.end(), numbers.begin(), numbers.end());
  return std::make_unique<OneRow>(std::move(row));
}

/// The three numbers that start at `input`; nothing if one is NULL.
std::optional<std::array<double, 3>> three_numbers(const FunctionCall& call, int input) {
  std::array<double, 3> numbers;
  for (int i = 0; i < 3; ++i) {
    const auto given = finite_number(call, input + i);
    if (!given) return std::nullopt;
    numbers[static_cast<std::size_t>(i)] = *given;
  }
  return numbers;
}

std::unique_ptr<FunctionRows> start_from_globe(const FunctionCall& call) {
  const FloatEnvironment environment;
  constexpr int in_x = from_globe_inputs["in_x"], in_vx = from_globe_inputs["in_vx"];
  const auto x = three_numbers(call, in_x), v = three_numbers(call, in_vx);
  if (!x) return std::make_unique<OneRow>(std::vector<std::optional<double>>{});
  OnGlobe point{*x, {}};
  if (v) point.motion = {*v, {}};
  const Flight flight = from_globe(point);
  const auto& course = flight.fix.course;
  std::vector<std::optional<double>> row{
      flight.fix.place.lat, flight.fix.place.lon, flight.height, {}, {}, {}};
  if (course) row[3] = course->speed, row[5] = flight.climb;
  if (course && !std::isnan(course->degrees)) row[4] = course->degrees;
  return std::make_unique<OneRow>(std::move(row));
}

}  // namespace

const TableFunction& geo_to_globe() {
  static const TableFunction function = {.name = "geo_to_globe",
                                         .outputs = {"x REAL", "y REAL", "z REAL", "vx REAL", "vy REAL",
                                                     "vz REAL", "ax REAL", "ay REAL", "az REAL"},
                                         .inputs = to_globe_inputs,
                                         .key = nullptr,
                                         .hinted = 0,
                                         .estimate = estimate_one_row,
                                         .start = start_to_globe};
  return function;
}

const TableFunction& globe_to_geo() {
  static const TableFunction function = {
      .name = "globe_to_geo",
      .outputs = {"lat REAL", "lon REAL", "height REAL", "speed REAL", "course REAL", "climb REAL"},
      .inputs = from_globe_inputs,
      .key = nullptr,
      .hinted = 0,
      .estimate = estimate_one_row,
      .start = start_from_globe};
  return function;
}

}  // namespace foresee
