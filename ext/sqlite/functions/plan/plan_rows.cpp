// plan_rows in SQL: the legs of a plan as rows.
#include <vector>

#include "motion/plan/plan_legs.h"
#include "sqlite/functions/plan/plan_functions.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

constexpr ColumnList leg_outputs{"leg INTEGER", "t REAL",  "until REAL", "x REAL",  "y REAL",  "z REAL",
                                 "vx REAL",     "vy REAL", "vz REAL",    "ax REAL", "ay REAL", "az REAL"};
constexpr ColumnList leg_inputs{"in_plan"};
constexpr int out_leg = leg_outputs["leg"], out_t = leg_outputs["t"], out_until = leg_outputs["until"],
              out_x = leg_outputs["x"];

class LegRows final : public FunctionRows {
 public:
  LegRows(std::vector<Leg> legs, int axes) : legs_(std::move(legs)), axes_(axes) {}

  bool next() override { return ++row_ < legs_.size(); }

  void output(sqlite3_context* context, int output) const override {
    const Leg& leg = legs_[row_];
    if (output == out_leg) return sqlite3_result_int64(context, static_cast<std::int64_t>(row_) + 1);
    if (output == out_t) return sqlite3_result_double(context, leg.t);
    if (output == out_until) {
      if (leg.until != no_end) sqlite3_result_double(context, leg.until);
      return;
    }
    const int place = output - out_x, axis = place % 3;
    if (axis >= axes_) return;
    const std::array<double, 3>& vector = place < 3 ? leg.x : place < 6 ? leg.v : leg.a;
    sqlite3_result_double(context, vector[static_cast<std::size_t>(axis)]);
  }

 private:
  std::vector<Leg> legs_;
  int axes_;
  std::size_t row_ = static_cast<std::size_t>(-1);
};

std::unique_ptr<FunctionRows> start_plan_rows(const FunctionCall& call) {
  sqlite3_value* value = call.value(leg_inputs["in_plan"]);
  const std::optional<Plan> plan = value ? plan_of(value, call.connection().interrupt()) : std::nullopt;
  if (!plan) return std::make_unique<LegRows>(std::vector<Leg>(), 0);
  check_size(*plan);
  return std::make_unique<LegRows>(legs_of(*plan), plan->axes);
}

}  // namespace

const TableFunction& plan_rows() {
  static const TableFunction function = {.name = "plan_rows",
                                         .outputs = leg_outputs,
                                         .inputs = leg_inputs,
                                         .key = "leg",
                                         .hinted = 0,
                                         .estimate =
                                             [](const CallSizes&) {
                                               return CallEstimate{50, 20};
                                             },
                                         .start = start_plan_rows,
                                         .orders = {{out_leg}}};
  return function;
}

}  // namespace foresee
