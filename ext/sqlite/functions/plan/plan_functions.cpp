// The scalar functions plan_shift, plan_cut and plan_turn, and the registration of all functions of plans.
#include "sqlite/functions/plan/plan_functions.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/number_text.h"
#include "database/statement.h"
#include "database/value_text.h"
#include "motion/plan/arc.h"
#include "motion/plan/plan_legs.h"
#include "sqlite/callback.h"

namespace foresee {

std::optional<double> plan_number(sqlite3_value* value, const char* name) {
  if (is_null_or_empty(value)) return std::nullopt;
  const int type = sqlite3_value_numeric_type(value);
  if (type != SQLITE_INTEGER && type != SQLITE_FLOAT)
    throw Error(std::string(name) + " must be a number, not " + shown(value) +
                (as_unixepoch(value) ? ": write " + *as_unixepoch(value) : ""));
  if (is_inexact(value))
    throw Error(std::string(name) + " must be a number that a double holds exactly, not " + shown(value));
  return sqlite3_value_double(value);
}

namespace {

double required(sqlite3_value* value, const char* name) {
  const std::optional<double> number = plan_number(value, name);
  if (!number) throw Error(std::string(name) + " is NULL: write a number");
  if (!std::isfinite(*number)) throw Error(std::string(name) + " is infinite: write a finite number");
  return *number;
}

void plan_shift(sqlite3_context* context, int, sqlite3_value** values) {
  report_by_name(context, "plan_shift", [&] {
    StatementInterrupt interrupt(sqlite3_context_db_handle(context));
    const std::optional<Plan> plan = plan_of(values[0], interrupt);
    const std::optional<double> seconds = plan_number(values[1], "seconds");
    if (!plan || !seconds) return;
    check_size(*plan);
    if (!std::isfinite(*seconds)) throw Error("seconds is infinite: write a finite number");
    const Plan shifted = shifted_plan(*plan, *seconds);
    interrupt.check();  // a million legs take some ten milliseconds
    result_plan(context, shifted, sqlite3_value_type(values[0]) == SQLITE_TEXT, interrupt);
  });
}

/// The frame of a plan in degrees; nothing for NULL and ''.
std::optional<Frame> frame_about(sqlite3_value* origin) {
  if (is_null_or_empty(origin)) return std::nullopt;
  const std::optional<LatLon> place =
      sqlite3_value_type(origin) == SQLITE_TEXT ? parse_origin(text_of(origin)) : std::nullopt;
  if (!place)
    throw Error("origin is " + shown(origin) +
                ": write latitude and longitude, as in '53.9 7.9', or NULL for metres");
  return Frame{.kind = FrameKind::degrees, .origin = place};
}

/// A leg in degrees is straight on the plane of its table.
KnotBetween knot_on_leg(const std::optional<Frame>& frame) {
  if (!frame) return knot_between;
  return [&frame](const Plan& plan, std::size_t after, double time) {
    const Plan leg{.kind = PlanKind::knots,
                   .axes = plan.axes,
                   .knots = {knot_on_plane(plan, after - 1, *frame), knot_on_plane(plan, after, *frame)}};
    return knot_in_degrees(knot_between(leg, 1, time), *frame);
  };
}

void plan_cut(sqlite3_context* context, int count, sqlite3_value** values) {
  report_by_name(context, "plan_cut", [&] {
    StatementInterrupt interrupt(sqlite3_context_db_handle(context));
    const std::optional<Frame> frame = count > 3 ? frame_about(values[3]) : std::nullopt;
    const std::optional<Plan> plan =
        plan_of(values[0], interrupt, frame ? WktUnit::degrees : WktUnit::metres);
    const double from = plan_number(values[1], "from").value_or(-no_end);
    const double to = plan_number(values[2], "to").value_or(no_end);
    if (!plan) return;
    if (frame) require_places(*plan);
    if (from > to)
      throw Error("from is " + shown(from) + ", later than to, which is " + shown(to) + ": exchange them");
    if (const std::optional<Plan> part = cut_plan(*plan, from, to, knot_on_leg(frame)))
      result_plan(context, *part, sqlite3_value_type(values[0]) == SQLITE_TEXT, interrupt);
  });
}

void plan_turn(sqlite3_context* context, int, sqlite3_value** values) {
  report_by_name(context, "plan_turn", [&] {
    TurnManoeuvre turn;
    turn.t = required(values[0], "t");
    turn.x = {required(values[1], "x"), required(values[2], "y")};
    turn.v = {required(values[3], "vx"), required(values[4], "vy")};
    turn.rate = required(values[5], "rate"), turn.duration = required(values[6], "duration");
    turn.until = plan_number(values[7], "until").value_or(no_end);
    const double error = required(values[8], "error");
    if (!(error > 0)) throw Error("error is " + shown(error) + ": write a distance greater than 0");
    StatementInterrupt interrupt(sqlite3_context_db_handle(context));
    result_plan(context, turn_plan(turn, error), false, interrupt);
  });
}

}  // namespace

int register_plan_functions(sqlite3* db) {
  constexpr int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS;
  const auto scalar = [db](const char* name, int count, auto function) {
    return sqlite3_create_function(db, name, count, flags, nullptr, function, nullptr, nullptr);
  };
  int rc = scalar("plan_shift", 2, plan_shift);
  if (rc == SQLITE_OK) rc = scalar("plan_cut", 3, plan_cut);
  if (rc == SQLITE_OK) rc = scalar("plan_cut", 4, plan_cut);
  if (rc == SQLITE_OK) rc = scalar("plan_turn", 9, plan_turn);
  if (rc == SQLITE_OK) rc = register_plan_aggregates(db);
  return rc;
}

}  // namespace foresee
