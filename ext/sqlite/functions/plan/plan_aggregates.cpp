// The aggregates plan_points, plan_uniform and plan_accelerated: rows of a GROUP BY, in any order, become a plan.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "base/number_text.h"
#include "database/statement.h"
#include "database/value_text.h"
#include "motion/plan/plan_legs.h"
#include "sqlite/callback.h"
#include "sqlite/functions/plan/plan_functions.h"

namespace foresee {
namespace {

struct AggregateRules {
  const char* name;
  PlanKind kind;
};

constexpr AggregateRules points_rules{"plan_points", PlanKind::knots};
constexpr AggregateRules uniform_rules{"plan_uniform", PlanKind::uniform};
constexpr AggregateRules accelerated_rules{"plan_accelerated", PlanKind::accelerated};

/// One row: a leg, or for plan_points a knot.
struct PlanRow {
  Leg leg;
  bool is_gap = false;         ///< of a knot: its position is NULL
  bool lasts_to_next = false;  ///< of a leg: its until is NULL
};

/// What one group has collected. SQLite keeps a pointer to it.
struct Collected {
  int axes = 0;
  std::vector<PlanRow> rows;
};

constexpr const char* vector_names[3][3] = {{"x", "y", "z"}, {"vx", "vy", "vz"}, {"ax", "ay", "az"}};

/// " at (3, 4)", for the user to find the row
std::string shown_place(const PlanRow& row, int axes) {
  if (row.is_gap) return " without a position";
  std::string text;
  for (int j = 0; j < axes; ++j)
    text += (j == 0 ? " at (" : ", ") + shown(row.leg.x[static_cast<std::size_t>(j)]);
  return text + ")";
}

double finite_number(double number, const char* name) {
  if (!std::isfinite(number)) throw Error(std::string(name) + " is infinite: write a finite number");
  return number;
}

/// Reads the numbers of one vector; false if one of them is NULL.
bool read_vector(sqlite3_value** values, int axes, int which, std::array<double, 3>& vector) {
  bool is_known = true;
  for (int j = 0; j < axes; ++j) {
    const char* name = vector_names[which][j];
    const std::optional<double> number = plan_number(values[j], name);
    if (number) vector[static_cast<std::size_t>(j)] = finite_number(*number, name);
    is_known &= number.has_value();
  }
  return is_known;
}

void read_leg(const AggregateRules& rules, int axes, sqlite3_value** values, PlanRow& row) {
  const std::optional<double> until = plan_number(values[0], "until");
  row.lasts_to_next = !until;
  if (until) row.leg.until = *until == no_end ? no_end : finite_number(*until, "until");
  bool is_known = true;
  const int vectors = rules.kind == PlanKind::uniform ? 2 : 3;
  for (int i = 0; i < vectors; ++i)
    is_known &= read_vector(values + 1 + i * axes, axes, i,
                            i == 0   ? row.leg.x
                            : i == 1 ? row.leg.v
                                     : row.leg.a);
  if (!is_known) throw Error("a number of the leg is NULL: write 0, or leave the row out");
}

/// Nothing for a row of NULLs, as an outer join gives.
std::optional<PlanRow> read_row(const AggregateRules& rules, int axes, int count, sqlite3_value** values) {
  const bool is_null = std::all_of(values, values + count, is_null_or_empty);
  if (is_null) return std::nullopt;
  PlanRow row;
  const std::optional<double> t = plan_number(values[0], "t");
  if (!t) throw Error("t is NULL in a row with other values: write a time, or leave the row out");
  const bool is_knot = rules.kind == PlanKind::knots;
  row.leg.t = *t == no_end && is_knot ? *t : finite_number(*t, "t");
  try {
    if (is_knot)
      row.is_gap = !read_vector(values + 1, axes, 0, row.leg.x);
    else
      read_leg(rules, axes, values + 1, row);
  } catch (const Error& error) {
    throw Error("at t = " + shown(*t) + ": " + error.what());
  }
  return row;
}

int axes_of(const AggregateRules& rules, int count) {
  switch (rules.kind) {
    case PlanKind::knots:
      return count - 1;
    case PlanKind::uniform:
      return (count - 2) / 2;
    case PlanKind::accelerated:
      return (count - 2) / 3;
  }
  return 0;
}

/// Knots between gaps are the parts of the plan.
Plan plan_of_points(const Collected& collected) {
  Plan plan{.kind = PlanKind::knots, .axes = collected.axes};
  bool after_gap = false;
  const auto check_part = [&plan](std::size_t start) {
    if (plan.knots.size() - start == 1)
      throw Error("one knot at t = " + shown(plan.knots.back().t) +
                  ": a leg needs two; leave it out, or write a plain row");
  };
  const PlanRow* before = nullptr;
  for (const PlanRow& row : collected.rows) {
    if (before && before->leg.t == row.leg.t)
      throw Error("t is " + shown(row.leg.t) + " in two rows," + shown_place(*before, plan.axes) + " and" +
                  shown_place(row, plan.axes) + ": times must rise; leave one out");
    before = &row;
    after_gap |= row.is_gap;
    if (row.is_gap) continue;
    if (after_gap && !plan.knots.empty()) {
      check_part(plan.part_starts.back());
      plan.part_starts.push_back(plan.knots.size());
    }
    after_gap = false;
    plan.knots.push_back({row.leg.t, row.leg.x});
  }
  check_part(plan.part_starts.back());
  return plan;
}

/// A NULL until is the t of the next leg; behind the last leg the plan has no end.
Plan plan_of_legs(const Collected& collected, PlanKind kind) {
  Plan plan{.kind = kind, .axes = collected.axes};
  for (std::size_t i = 0; i < collected.rows.size(); ++i) {
    Leg leg = collected.rows[i].leg;
    const bool is_last = i + 1 == collected.rows.size();
    if (collected.rows[i].lasts_to_next) {
      leg.until = is_last ? no_end : collected.rows[i + 1].leg.t;
      if (leg.until == leg.t)
        throw Error("t is " + shown(leg.t) + " in two rows," + shown_place(collected.rows[i], plan.axes) +
                    " and" + shown_place(collected.rows[i + 1], plan.axes) +
                    ": times must rise; write until, or leave one out");
    }
    plan.legs.push_back(leg);
  }
  return plan;
}

void collect(const AggregateRules& rules, sqlite3_context* context, int count, sqlite3_value** values) {
  report_by_name(context, rules.name, [&] {
    auto** const slot = static_cast<Collected**>(sqlite3_aggregate_context(context, sizeof(Collected*)));
    if (slot == nullptr) throw std::bad_alloc();
    const int axes = axes_of(rules, count);
    const std::optional<PlanRow> row = read_row(rules, axes, count, values);
    if (!row) return;
    if (*slot == nullptr) *slot = new Collected{axes, {}};
    (*slot)->rows.push_back(*row);
  });
}

void finish(const AggregateRules& rules, sqlite3_context* context) {
  auto** const slot = static_cast<Collected**>(sqlite3_aggregate_context(context, 0));
  if (slot == nullptr || *slot == nullptr) return;
  const std::unique_ptr<Collected> collected(*slot);
  *slot = nullptr;
  report_by_name(context, rules.name, [&] {
    const FloatEnvironment environment;
    StatementInterrupt interrupt(sqlite3_context_db_handle(context));
    Steps steps(interrupt);
    // By t, then by until: a leg of no duration comes before the one that starts with it. All numbers count, so that
    // the order of the rows has no influence.
    std::sort(collected->rows.begin(), collected->rows.end(), [&](const PlanRow& a, const PlanRow& b) {
      steps();
      return std::tie(a.leg.t, a.leg.until, a.leg.x, a.leg.v, a.leg.a) <
             std::tie(b.leg.t, b.leg.until, b.leg.x, b.leg.v, b.leg.a);
    });
    // Feeds deliver twice: a row that is there again says nothing new.
    const auto is_same = [](const PlanRow& a, const PlanRow& b) {
      return std::tie(a.leg.t, a.leg.until, a.leg.x, a.leg.v, a.leg.a, a.is_gap, a.lasts_to_next) ==
             std::tie(b.leg.t, b.leg.until, b.leg.x, b.leg.v, b.leg.a, b.is_gap, b.lasts_to_next);
    };
    collected->rows.erase(std::unique(collected->rows.begin(), collected->rows.end(), is_same),
                          collected->rows.end());
    const Plan plan =
        rules.kind == PlanKind::knots ? plan_of_points(*collected) : plan_of_legs(*collected, rules.kind);
    if (leg_count(plan) == 0) return;
    check_plan(plan);
    result_plan(context, plan, false, interrupt);
  });
}

template <const AggregateRules& rules>
int register_aggregate(sqlite3* db, int count) {
  return sqlite3_create_function(
      db, rules.name, count, SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS, nullptr, nullptr,
      [](sqlite3_context* context, int given, sqlite3_value** values) {
        collect(rules, context, given, values);
      },
      [](sqlite3_context* context) { finish(rules, context); });
}

}  // namespace

int register_plan_aggregates(sqlite3* db) {
  int rc = SQLITE_OK;
  for (int axes = 1; axes <= 3 && rc == SQLITE_OK; ++axes) {
    rc = register_aggregate<points_rules>(db, 1 + axes);
    if (rc == SQLITE_OK) rc = register_aggregate<uniform_rules>(db, 2 + 2 * axes);
    if (rc == SQLITE_OK) rc = register_aggregate<accelerated_rules>(db, 2 + 3 * axes);
  }
  return rc;
}

}  // namespace foresee
