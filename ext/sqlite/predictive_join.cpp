// predictive_join(h, …) in SQL: reads the inputs, opens the tables, and hands rows on.
#include <algorithm>

#include "query/join.h"
#include "sqlite/open_table.h"
#include "sqlite/table_functions.h"

namespace foresee {
namespace {

enum Output { out_a, out_b, out_t, out_t_end, out_dt, out_dt_end, out_t_cpa, out_dt_cpa, out_d_cpa };
enum Input { in_h, in_tbl, in_within, in_other, in_now, in_method, in_within_z, in_schema };

class JoinRows final : public Rows {
 public:
  JoinRows(JoinQuestion question, Interrupt& interrupt) : join_(std::move(question), interrupt) {}

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
    else
      sqlite3_result_double(context, moment_or_distance(row, output));
  }

 private:
  static double moment_or_distance(const JoinRow& row, int output) {
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

  Join join_;
  std::span<const JoinRow> batch_;
  std::size_t row_ = 0;
};

/// The scenes of tbl and other. The same table as `other` is the same scene: pairs in both orders.
void open_scenes(const Call& call, JoinQuestion& question) {
  const auto schema = call.text(in_schema);
  const OpenScene a = open_scene(call.connection(), {call.text(in_tbl), schema});
  question.a = a.scene;
  if (const auto other = call.text(in_other)) {
    const OpenScene b = open_scene(call.connection(), {other, schema});
    question.b = b.number == a.number ? a.scene : b.scene;
  }
}

double newest_t_of(const JoinQuestion& question) {
  const double newest = newest_t(*question.a);
  return question.b ? std::max(newest, newest_t(*question.b)) : newest;
}

std::unique_ptr<Rows> start(const Call& call) {
  JoinQuestion question;
  question.h = call.required_number(in_h);
  question.within = call.number(in_within).value_or(0);
  question.within_z = call.number(in_within_z);
  if (const auto method = call.text(in_method)) question.method = join_method(*method);
  const auto now = call.number(in_now);
  open_scenes(call, question);
  question.now = now ? *now : newest_t_of(question);
  question.only_a = call.only(out_a);
  question.only_b = call.only(out_b);
  question.skip_touching = call.only_positive(out_dt);
  question.wants.ends = call.reads(out_t_end) || call.reads(out_dt_end);
  question.wants.contact = question.wants.ends || call.reads(out_t) || call.reads(out_dt);
  question.wants.approach = call.reads(out_t_cpa) || call.reads(out_dt_cpa) || call.reads(out_d_cpa);
  return std::make_unique<JoinRows>(std::move(question), call.connection().interrupt());
}

}  // namespace

const TableFunction& predictive_join() {
  static const TableFunction function = {
      .name = "predictive_join",
      .outputs = {"a INTEGER", "b INTEGER", "t REAL", "t_end REAL", "dt REAL", "dt_end REAL", "t_cpa REAL",
                  "dt_cpa REAL", "d_cpa REAL"},
      .inputs = {"h", "tbl", "within", "other", "now", "method", "within_z", "schema"},
      .key = "a, b",
      .hinted = 1u << out_a | 1u << out_b | 1u << out_dt,
      .start = start};
  return function;
}

}  // namespace foresee
