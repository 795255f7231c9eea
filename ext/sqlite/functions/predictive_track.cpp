// predictive_track(t0, t1, step, …) in SQL: positions at several instants, of all objects or of one id.
#include "query/position/tracks.h"
#include "sqlite/functions/place_output.h"
#include "sqlite/functions/table_functions.h"
#include "sqlite/names/open_table.h"

namespace foresee {
namespace {

constexpr ColumnList track_outputs{"id INTEGER", "t REAL",      "x REAL",    "y REAL",
                                   "z REAL",     "lat REAL",    "lon REAL",  "height REAL",
                                   "speed REAL", "course REAL", "climb REAL"};
constexpr int out_id = track_outputs["id"], out_t = track_outputs["t"], out_x = track_outputs["x"],
              out_lat = track_outputs["lat"];
constexpr ColumnList track_inputs{"t0", "t1", "step", "tbl", "schema"};
constexpr int in_t0 = track_inputs["t0"], in_t1 = track_inputs["t1"], in_step = track_inputs["step"],
              in_tbl = track_inputs["tbl"], in_schema = track_inputs["schema"];

class TrackRows final : public FunctionRows {
 public:
  TrackRows(const std::shared_ptr<const Scene>& scene, const TrackTimes& instants, const Frame& frame,
            Interrupt& interrupt)
      : axes_(scene->layout.axes), tracks_(scene, instants, interrupt), place_(frame, axes_) {}

  bool next() override {
    row_ = tracks_.next();
    place_.next_row();
    return row_.has_value();
  }

  void output(sqlite3_context* context, int output) const override {
    if (output == out_id) return sqlite3_result_int64(context, row_->at.id);
    if (output == out_t) return sqlite3_result_double(context, row_->t);
    if (output >= out_lat) return place_.output(context, geo_column_of(output - out_lat), row_->at);
    const int axis = output - out_x;
    if (axis < axes_) sqlite3_result_double(context, row_->at.x[static_cast<std::size_t>(axis)]);
  }

 private:
  int axes_;
  Tracks tracks_;
  PlaceOutput place_;
  std::optional<TrackRow> row_;
};

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  const TrackTimes instants{call.required_number(in_t0), call.required_number(in_t1),
                            call.required_number(in_step)};
  Connection& connection = call.connection();
  const auto table = open_table(connection, {call.text(in_tbl), call.text(in_schema)});
  call.reads_back_as(in_tbl, table.table);
  call.reads_back_as(in_schema, table.schema);
  const auto scene = connection.load_queried(table, call.only(out_id), {instants.t0, instants.t1});
  return std::make_unique<TrackRows>(scene, instants, table.store->frame(), connection.interrupt());
}

}  // namespace

const TableFunction& predictive_track() {
  static const TableFunction function = {.name = "predictive_track",
                                         .outputs = track_outputs,
                                         .inputs = track_inputs,
                                         .key = "id, t",
                                         .hinted = 1u << out_id,
                                         .estimate = estimate_tracks,
                                         .start = start,
                                         .probed = 1u << out_id,
                                         .estimate_probe = estimate_track,
                                         .orders = {{out_t, out_id}}};
  return function;
}

}  // namespace foresee
