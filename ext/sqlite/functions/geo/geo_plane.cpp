// geo_to_plane(lat, lon, …) and plane_to_geo(x, y, …) in SQL.
#include <cmath>

#include "base/float_environment.h"
#include "geography/plane.h"
#include "sqlite/functions/geo/geo_inputs.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

constexpr ColumnList to_plane_inputs{"in_lat", "in_lon", "in_speed", "in_course", "lat0", "lon0"};
constexpr ColumnList to_geo_inputs{"in_x", "in_y", "in_vx", "in_vy", "lat0", "lon0"};

std::unique_ptr<FunctionRows> start_to_plane(const FunctionCall& call) {
  const FloatEnvironment environment;
  constexpr int in_lat = to_plane_inputs["in_lat"], in_speed = to_plane_inputs["in_speed"],
                in_lat0 = to_plane_inputs["lat0"];
  const LatLon origin = origin_of(call, in_lat0);
  const auto place = place_input(call, in_lat);
  if (!place) return std::make_unique<OneRow>(std::vector<std::optional<double>>{});
  const OnPlane point = to_plane({*place, course_input(call, in_speed)}, origin);
  std::vector<std::optional<double>> row{point.x, point.y};
  if (point.v) row.insert(row.end(), point.v->begin(), point.v->end());
  return std::make_unique<OneRow>(std::move(row));
}

std::unique_ptr<FunctionRows> start_to_geo(const FunctionCall& call) {
  const FloatEnvironment environment;
  constexpr int in_x = to_geo_inputs["in_x"], in_y = to_geo_inputs["in_y"], in_vx = to_geo_inputs["in_vx"],
                in_vy = to_geo_inputs["in_vy"], in_lat0 = to_geo_inputs["lat0"];
  const LatLon origin = origin_of(call, in_lat0);
  const auto x = finite_number(call, in_x), y = finite_number(call, in_y);
  if (!x || !y) return std::make_unique<OneRow>(std::vector<std::optional<double>>{});
  OnPlane point{*x, *y, {}};
  const auto vx = finite_number(call, in_vx), vy = finite_number(call, in_vy);
  if (vx && vy) point.v = {*vx, *vy};
  const Fix fix = from_plane(point, origin);
  std::vector<std::optional<double>> row{fix.place.lat, fix.place.lon};
  if (fix.course) row.emplace_back(fix.course->speed);
  if (fix.course && !std::isnan(fix.course->degrees)) row.emplace_back(fix.course->degrees);
  return std::make_unique<OneRow>(std::move(row));
}

}  // namespace

const TableFunction& geo_to_plane() {
  static const TableFunction function = {.name = "geo_to_plane",
                                         .outputs = {"x REAL", "y REAL", "vx REAL", "vy REAL"},
                                         .inputs = to_plane_inputs,
                                         .key = nullptr,
                                         .hinted = 0,
                                         .estimate = estimate_one_row,
                                         .start = start_to_plane};
  return function;
}

const TableFunction& plane_to_geo() {
  static const TableFunction function = {.name = "plane_to_geo",
                                         .outputs = {"lat REAL", "lon REAL", "speed REAL", "course REAL"},
                                         .inputs = to_geo_inputs,
                                         .key = nullptr,
                                         .hinted = 0,
                                         .estimate = estimate_one_row,
                                         .start = start_to_geo};
  return function;
}

}  // namespace foresee
