// predictive_sweep(h, …) in SQL: the swept boxes from which own_x0 to own_y1 select pairs (join_inputs.h).
#include "index/tpr_tree/tpr_tree.h"
#include "query/sweep/sweep.h"
#include "sqlite/functions/table_functions.h"
#include "sqlite/names/open_table.h"

namespace foresee {
namespace {

constexpr ColumnList sweep_outputs{"id INTEGER", "x0 REAL", "x1 REAL", "y0 REAL",
                                   "y1 REAL",    "z0 REAL", "z1 REAL"};
constexpr int out_id = sweep_outputs["id"], out_x0 = sweep_outputs["x0"];
constexpr ColumnList sweep_inputs{"h", "tbl", "within", "now", "within_z", "schema"};
constexpr int in_h = sweep_inputs["h"], in_tbl = sweep_inputs["tbl"], in_within = sweep_inputs["within"],
              in_now = sweep_inputs["now"], in_within_z = sweep_inputs["within_z"],
              in_schema = sweep_inputs["schema"];

class SweepRows final : public FunctionRows {
 public:
  SweepRows(SweepQuestion question, Interrupt& interrupt)
      : axes_(question.tree->layout().axes), sweep_(std::move(question), interrupt) {}

  bool next() override {
    if (++row_ >= batch_.size()) {
      batch_ = sweep_.next();
      row_ = 0;
    }
    return !batch_.empty();
  }

  void output(sqlite3_context* context, int output) const override {
    const SweepRow& row = batch_[row_];
    if (output == out_id) return sqlite3_result_int64(context, row.id);
    const int axis = (output - out_x0) / 2;
    if (axis >= axes_) return;
    const auto& corner = (output - out_x0) % 2 == 0 ? row.lower : row.upper;
    sqlite3_result_double(context, corner[static_cast<std::size_t>(axis)]);
  }

 private:
  int axes_;
  Sweep sweep_;
  std::span<const SweepRow> batch_;
  std::size_t row_ = 0;
};

QueriedCorners queried_corners(const FunctionCall& call, int axis) {
  const FunctionCall::Bounds lower = call.bounds(out_x0 + 2 * axis),
                             upper = call.bounds(out_x0 + 2 * axis + 1);
  return {lower.min, lower.max, upper.min, upper.max};
}

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  SweepQuestion question;
  question.h = call.required_number(in_h);
  question.within = call.number(in_within).value_or(question.within);
  question.within_z = call.number(in_within_z);
  const auto now = call.number(in_now);
  Connection& connection = call.connection();
  const auto table = open_table(connection, {call.text(in_tbl), call.text(in_schema)});
  require_upright(table, question.within_z);
  question.tree = table.store->take_snapshot();
  question.chunks = table.store->chunks();
  question.now = now ? *now : read_newest_t(*question.tree);
  call.reads_back_as(in_tbl, table.table);
  call.reads_back_as(in_schema, table.schema);
  call.reads_back_as(in_now, question.now);
  call.reads_back_as(in_within, question.within);
  question.queried = {queried_corners(call, 0), queried_corners(call, 1)};
  return std::make_unique<SweepRows>(std::move(question), connection.interrupt());
}

}  // namespace

const TableFunction& predictive_sweep() {
  static const TableFunction function = {.name = "predictive_sweep",
                                         .outputs = sweep_outputs,
                                         .inputs = sweep_inputs,
                                         .key = "id",
                                         .hinted = 0xf << out_x0,
                                         .estimate = estimate_positions,
                                         .start = start,
                                         .unread_if_left_out = 1u << in_within_z};
  return function;
}

}  // namespace foresee
