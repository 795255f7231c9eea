// predictive_join(h, …) in SQL: reads the inputs, requests only the outputs that are read, and returns the
// rows.
#include "query/join/join.h"
#include "sqlite/functions/join_inputs.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

constexpr ColumnList join_outputs{"a INTEGER",   "b INTEGER",  "t REAL",      "t_end REAL", "dt REAL",
                                  "dt_end REAL", "t_cpa REAL", "dt_cpa REAL", "d_cpa REAL"};
constexpr int out_a = join_outputs["a"], out_b = join_outputs["b"], out_t = join_outputs["t"],
              out_t_end = join_outputs["t_end"], out_dt = join_outputs["dt"],
              out_dt_end = join_outputs["dt_end"], out_t_cpa = join_outputs["t_cpa"],
              out_dt_cpa = join_outputs["dt_cpa"], out_d_cpa = join_outputs["d_cpa"];

class JoinRows final : public FunctionRows {
 public:
  JoinRows(JoinQuestion question, Interrupt& interrupt)
      : has_starts_(question.wants.contact || may_repeat_pairs(question)),
        has_ends_(question.wants.ends || may_repeat_pairs(question)),
        join_(std::move(question), interrupt) {}

  bool next() override {
    if (++row_ >= batch_.size()) {
      batch_ = join_.next();
      row_ = 0;
    }
    return !batch_.empty();
  }

  void output(sqlite3_context* context, int output) const override {
    const JoinRow& row = batch_[row_];
    if (output <= out_b)
      sqlite3_result_int64(context, output == out_a ? row.a : row.b);
    else if (is_computed(output))
      sqlite3_result_double(context, time_or_distance(row, output));
  }

 private:
  /// FULL JOIN of SQLite 3.40 compares the whole key, also times that the statement does not read. Those are NULL: they
  /// may differ between two calls.
  bool is_computed(int output) const {
    if (output == out_t || output == out_dt) return has_starts_;
    return has_ends_ || (output != out_t_end && output != out_dt_end);
  }
  static double time_or_distance(const JoinRow& row, int output) {
    switch (output) {
      case out_t:
        return row.contact.t;
      case out_t_end:
        return row.contact.t_end;
      case out_dt:
        return row.contact.dt;
      case out_dt_end:
        return row.contact.dt_end;
      case out_t_cpa:
        return row.approach.t;
      case out_dt_cpa:
        return row.approach.dt;
      default:
        return row.approach.d;
    }
  }

  bool has_starts_, has_ends_;
  Join join_;
  std::span<const JoinRow> batch_;
  std::size_t row_ = 0;
};

/// `outputs`: one of predictive_join's `orders`, or a prefix of one.
JoinOrder order_of(std::span<const int> outputs) {
  if (outputs.empty()) return JoinOrder::any;
  if (outputs[0] == out_dt) return JoinOrder::by_dt;
  return outputs.size() > 1 ? JoinOrder::by_t_and_ids : JoinOrder::by_t;
}

QueriedTimes queried(const FunctionCall::Bounds& bounds) {
  return {bounds.min, bounds.max};
}

/// What the outputs that are read, and the conditions on them, determine of the query.
JoinQuestion question_of_outputs(const FunctionCall& call) {
  JoinQuestion question;
  question.only_a = call.only(out_a);
  question.only_b = call.only(out_b);
  JoinWants& wants = question.wants;
  wants.ends = call.reads(out_t_end) || call.reads(out_dt_end);
  wants.contact = wants.ends || call.reads(out_t) || call.reads(out_dt);
  wants.approach = call.reads(out_t_cpa) || call.reads(out_dt_cpa) || call.reads(out_d_cpa);
  question.queried_t = queried(call.bounds(out_t));
  question.queried_dt = queried(call.bounds(out_dt));
  question.order = order_of(call.order());
  question.likely_rows = call.limit().total().value_or(all_rows);
  return question;
}

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  Connection& connection = call.connection();
  JoinQuestion question = question_of_outputs(call);
  question.helpers = connection.helper_threads();
  const JoinedTables tables = read_join_inputs(call, question);
  load_scenes(tables, question, connection.interrupt());
  return std::make_unique<JoinRows>(std::move(question), connection.interrupt());
}

}  // namespace

const TableFunction& predictive_join() {
  static const TableFunction function = {
      .name = "predictive_join",
      .outputs = join_outputs,
      .inputs = join_input_names(true),
      .key = "a, b, t, t_end",  // with contacts = 'all' a pair may come again
      .hinted = 1u << out_a | 1u << out_b | 1u << out_t | 1u << out_dt,
      .estimate = estimate_join,
      .start = start,
      .probed = 1u << out_a | 1u << out_b,  // one id: through the tree
      .estimate_probe = estimate_pairs_of_one,
      .orders = {{out_t, out_a, out_b}, {out_dt}},
      .unread_if_left_out = unread_join_inputs()};
  return function;
}

}  // namespace foresee
