// predictive_position(at, …) in SQL: the position of each object, or of the object of one id.
#include "query/position/positions.h"
#include "sqlite/functions/place_output.h"
#include "sqlite/functions/table_functions.h"
#include "sqlite/names/open_table.h"

namespace foresee {
namespace {

constexpr ColumnList position_outputs{"id INTEGER", "x REAL",      "y REAL",    "z REAL",   "vx REAL",
                                      "vy REAL",    "vz REAL",     "lat REAL",  "lon REAL", "height REAL",
                                      "speed REAL", "course REAL", "climb REAL"};
constexpr int out_id = position_outputs["id"], out_x = position_outputs["x"], out_vx = position_outputs["vx"],
              out_lat = position_outputs["lat"];
constexpr ColumnList position_inputs{"at", "tbl", "schema"};
constexpr int in_at = position_inputs["at"], in_tbl = position_inputs["tbl"],
              in_schema = position_inputs["schema"];

class PositionRows final : public FunctionRows {
 public:
  PositionRows(std::shared_ptr<const Scene> scene, double time, const Frame& frame, Interrupt& interrupt)
      : axes_(scene->layout.axes),
        positions_(std::move(scene), time),
        place_(frame, axes_),
        interrupt_(interrupt) {}

  bool next() override {
    interrupt_.check();
    row_ = positions_.next();
    place_.next_row();
    return row_.has_value();
  }

  void output(sqlite3_context* context, int output) const override {
    if (output == out_id) return sqlite3_result_int64(context, row_->id);
    if (output >= out_lat) return place_.output(context, geo_column_of(output - out_lat), *row_);
    const int axis = (output - out_x) % 3;
    if (axis >= axes_) return;
    const auto& values = output < out_vx ? row_->x : row_->v;
    sqlite3_result_double(context, values[static_cast<std::size_t>(axis)]);
  }

 private:
  int axes_;
  Positions positions_;
  PlaceOutput place_;
  Interrupt& interrupt_;
  std::optional<PositionRow> row_;
};

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  const double at = call.required_number(in_at);
  Connection& connection = call.connection();
  const auto table = open_table(connection, {call.text(in_tbl), call.text(in_schema)});
  call.reads_back_as(in_tbl, table.table);
  call.reads_back_as(in_schema, table.schema);
  auto scene = connection.load_queried(table, call.only(out_id), {at, at});
  return std::make_unique<PositionRows>(std::move(scene), at, table.store->frame(), connection.interrupt());
}

}  // namespace

const TableFunction& predictive_position() {
  static const TableFunction function = {.name = "predictive_position",
                                         .outputs = position_outputs,
                                         .inputs = position_inputs,
                                         .key = "id",
                                         .hinted = 1u << out_id,
                                         .estimate = estimate_positions,
                                         .start = start,
                                         .probed = 1u << out_id,
                                         .estimate_probe = estimate_object};
  return function;
}

}  // namespace foresee
