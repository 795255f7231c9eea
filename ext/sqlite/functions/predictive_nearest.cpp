// predictive_nearest(h, tbl, k, …) in SQL: reads the inputs, opens the table, and returns the rows.
#include "query/nearest/nearest.h"
#include "sqlite/functions/searched_table.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

enum NearestOutput { out_id, out_rank, out_distance, out_t, out_dt };
enum NearestInput { in_h, in_tbl, in_k, in_x, in_now = in_x + 3, in_qvx, in_method = in_qvx + 3, in_schema };

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

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  NearestQuestion question;
  question.h = call.required_number(in_h);
  question.k = call.required_integer(in_k);
  for (int axis = 0; axis < 3; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    question.point[j] = call.number(in_x + axis);
    question.velocity[j] = call.number(in_qvx + axis).value_or(0);
    call.used(in_qvx + axis, 0.0);
  }
  SearchedTable table = searched_table(call, {in_tbl, in_now, in_method, in_schema});
  question.objects = std::move(table.objects);
  question.now = table.now;
  return std::make_unique<NearestRows>(nearest(question, call.connection().interrupt()));
}

}  // namespace

const TableFunction& predictive_nearest() {
  static const TableFunction function = {
      .name = "predictive_nearest",
      .outputs = {"id INTEGER", "rank INTEGER", "distance REAL", "t REAL", "dt REAL"},
      .inputs = {"h", "tbl", "k", "x", "y", "z", "now", "qvx", "qvy", "qvz", "method", "schema"},
      .key = "id",
      .hinted = 0,
      .estimate = estimate_nearest,
      .start = start};
  return function;
}

}  // namespace foresee
