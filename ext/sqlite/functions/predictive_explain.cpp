// predictive_explain(h, …) in SQL: the stages of a join, one per row.
#include "query/join/explain.h"
#include "sqlite/functions/join_inputs.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

constexpr ColumnList explain_outputs{"stage TEXT",       "n_before INTEGER", "n_after INTEGER",
                                     "prune_power REAL", "seconds REAL",     "detail TEXT"};
constexpr int out_stage = explain_outputs["stage"], out_n_before = explain_outputs["n_before"],
              out_n_after = explain_outputs["n_after"], out_prune_power = explain_outputs["prune_power"],
              out_seconds = explain_outputs["seconds"];

class ExplainRows final : public FunctionRows {
 public:
  explicit ExplainRows(std::vector<ExplainRow> rows) : rows_(std::move(rows)) {}

  bool next() override { return ++next_ <= rows_.size(); }

  void output(sqlite3_context* context, int output) const override {
    const ExplainRow& row = rows_[next_ - 1];
    switch (output) {
      case out_stage:
        return sqlite3_result_text(context, row.stage, -1, SQLITE_STATIC);
      case out_n_before:
        return sqlite3_result_int64(context, static_cast<sqlite3_int64>(row.before));
      case out_n_after:
        return sqlite3_result_int64(context, static_cast<sqlite3_int64>(row.after));
      case out_prune_power:
        if (const auto power = row.prune_power()) sqlite3_result_double(context, *power);
        return;
      case out_seconds:
        return sqlite3_result_double(context, row.seconds);
      default:
        return sqlite3_result_text(context, row.detail.c_str(), -1, SQLITE_TRANSIENT);
    }
  }

 private:
  std::vector<ExplainRow> rows_;
  std::size_t next_ = 0;
};

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  Connection& connection = call.connection();
  JoinQuestion question;
  const JoinedTables tables = read_join_inputs(call, question);
  load_scenes(tables, question, connection.interrupt(), InertObjects::counted);
  return std::make_unique<ExplainRows>(explain_join(question, connection.interrupt()));
}

}  // namespace

const TableFunction& predictive_explain() {
  static const TableFunction function = {.name = "predictive_explain",
                                         .outputs = explain_outputs,
                                         .inputs = join_input_names(),
                                         .key = "stage",
                                         .hinted = 0,
                                         .estimate = estimate_stages,
                                         .start = start,
                                         .unread_if_left_out = unread_join_inputs()};
  return function;
}

}  // namespace foresee
