// predictive_nearest(h, tbl, k, …) in SQL: reads the inputs, opens the table, and returns the rows.
#include <cmath>

#include "base/float_environment.h"
#include "base/number_text.h"
#include "query/nearest/nearest.h"
#include "sqlite/functions/searched_table.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

constexpr ColumnList nearest_outputs{"id INTEGER", "rank INTEGER", "distance REAL", "t REAL", "dt REAL"};
constexpr int out_id = nearest_outputs["id"], out_rank = nearest_outputs["rank"],
              out_distance = nearest_outputs["distance"], out_t = nearest_outputs["t"];
constexpr ColumnList nearest_inputs{"h",   "tbl", "k",      "x",      "y",   "z",   "now", "qvx",
                                    "qvy", "qvz", "method", "schema", "lat", "lon", "mask"};
constexpr int in_h = nearest_inputs["h"], in_tbl = nearest_inputs["tbl"], in_k = nearest_inputs["k"],
              in_x = nearest_inputs["x"], in_now = nearest_inputs["now"], in_qvx = nearest_inputs["qvx"],
              in_method = nearest_inputs["method"], in_schema = nearest_inputs["schema"],
              in_lat = nearest_inputs["lat"], in_lon = nearest_inputs["lon"],
              in_mask = nearest_inputs["mask"];

class NearestRows final : public FunctionRows {
 public:
  explicit NearestRows(std::vector<NearestRow> rows) : rows_(std::move(rows)) {}

  bool next() override { return ++rank_ <= rows_.size(); }

  void output(sqlite3_context* context, int output) const override {
    const NearestRow& row = rows_[rank_ - 1];
    switch (output) {
      case out_id:
        return sqlite3_result_int64(context, row.id);
      case out_rank:
        return sqlite3_result_int64(context, static_cast<sqlite3_int64>(rank_));
      case out_distance:
        return sqlite3_result_double(context, row.distance);
      case out_t:
        return sqlite3_result_double(context, row.t);
      default:
        return sqlite3_result_double(context, row.dt);
    }
  }

 private:
  std::vector<NearestRow> rows_;
  std::size_t rank_ = 0;
};

double degrees_input(const FunctionCall& call, int input, const std::string& table, double limit) {
  const std::string name = call.name_of(input);
  const auto given = call.number(input);
  if (!given)
    throw Error(table + " has lat, lon, and " + name + " is missing; write WHERE lat = ... AND lon = ...");
  if (std::abs(*given) <= limit) return *given;
  throw Error(name + " is " + shown(*given) + ", beyond " + shown(limit) + "; write " +
              (input == in_lon ? shown(std::remainder(*given, 360)) : "degrees"));
}

/// z is metres above the ellipsoid, 0 if it is not given.
void take_place_on_globe(const LatLon& place, NearestQuestion& question) {
  const FloatEnvironment environment;
  const OnGlobe point = to_globe({{place, {}}, question.point[2].value_or(0)});
  for (std::size_t axis = 0; axis < 3; ++axis) question.point[axis] = point.x[axis];
}

/// Sets the point from lat and lon, for a table in degrees.
void take_place(const FunctionCall& call, const SearchedTable& table, NearestQuestion& question) {
  const std::string& name = table.objects.name;
  if (!table.frame.in_degrees()) {
    for (const int input : {in_lat, in_lon})
      if (call.number(input))
        throw Error(name + " has no lat, lon; write x, y in place of " + call.name_of(input));
    return;
  }
  for (const std::size_t axis : {0u, 1u})
    if (question.point[axis])
      throw Error(name + " has lat, lon; write WHERE lat = ... AND lon = ... in place of " +
                  call.name_of(in_x + static_cast<int>(axis)));
  const LatLon place{degrees_input(call, in_lat, name, 90), degrees_input(call, in_lon, name, 180)};
  if (table.frame.on_globe()) return take_place_on_globe(place, question);
  const LatLon origin = table.frame.origin.value_or(place);  // without an origin the table is empty
  const FloatEnvironment environment;
  const OnPlane point = to_plane({place, {}}, origin);
  const double distance = std::hypot(point.x, point.y);
  if (distance > max_distance_from_origin)
    throw Error("lat, lon are " + shown(std::ceil(distance / 1000)) + " km from the origin '" +
                origin_text(origin) + "' of " + name + "; write a place within 1500 km");
  question.point[0] = point.x, question.point[1] = point.y;
}

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  NearestQuestion question;
  question.h = call.required_number(in_h);
  question.k = call.required_integer(in_k);
  for (int axis = 0; axis < 3; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    question.point[j] = call.number(in_x + axis);
    question.velocity[j] = call.number(in_qvx + axis).value_or(0);
    call.reads_back_as(in_qvx + axis, 0.0);
  }
  question.mask = call.bits(in_mask);
  SearchedTable table = searched_table(call, {in_tbl, in_now, in_method, in_schema});
  take_place(call, table, question);
  question.objects = std::move(table.objects);
  question.now = table.now;
  return std::make_unique<NearestRows>(nearest(question, call.connection().interrupt()));
}

}  // namespace

const TableFunction& predictive_nearest() {
  static const TableFunction function = {
      .name = "predictive_nearest",
      .outputs = nearest_outputs,
      .inputs = nearest_inputs,
      .key = "id",
      .hinted = 0,
      .estimate = estimate_nearest,
      .start = start,
      .unread_if_left_out = 0x7u << in_x | 1u << in_lat | 1u << in_lon | 1u << in_mask};
  return function;
}

}  // namespace foresee
