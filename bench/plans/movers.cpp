// --movers: a table with a row per mover beside a table with a row per leg.
#include <cstdio>
#include <map>
#include <random>

#include "measure.h"
#include "plans/modes.h"
#include "plans/schedule.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

using MoverPair = std::pair<std::int64_t, std::int64_t>;

/// The first t of each pair; rows of legs by their movers.
std::map<MoverPair, double> first_contacts(Statement& join, std::int64_t ids) {
  std::map<MoverPair, double> first;
  while (join.step()) {
    const std::int64_t a = join.integer(0) / ids, b = join.integer(1) / ids;
    if (a == b) continue;
    const auto [found, is_new] = first.try_emplace(std::minmax(a, b), join.number(2));
    if (!is_new) found->second = std::min(found->second, join.number(2));
  }
  return first;
}

std::string join_of(const std::string& table, double h, bool with_ends) {
  return std::string("SELECT a, b, t") + (with_ends ? ", t_end" : "") +
         " FROM predictive_join WHERE tbl = '" + table + "' AND now = 0 AND h = " + std::to_string(h);
}

void compare_joins(Database& db, const Schedule& schedule, const char* plans, const char* rows, double h,
                   int repetitions) {
  for (const bool with_ends : {false, true}) {
    Statement ours(db, join_of(plans, h, with_ends)), theirs(db, join_of(rows, h, with_ends));
    const auto found = first_contacts(ours, 1);
    if (found != first_contacts(theirs, ids_per_mover)) throw Error("plans and rows give different pairs");
    Comparison times;
    std::int64_t our_rows = 0, their_rows = 0;
    for (int i = 0; i < repetitions; ++i)
      times.add(seconds_of([&] { our_rows = ours.step_all(); }),
                seconds_of([&] { their_rows = theirs.step_all(); }));
    const double legs = static_cast<double>(schedule.legs.size());
    std::printf(
        "  join, h = %3g, %-14s plans %5.0f ns per leg, %7lld rows   legs as rows %5.0f ns, %8lld rows   "
        "%5.2fx\n",
        h, with_ends ? "with ends" : "starts", 1e9 * median(times.ours) / legs,
        static_cast<long long>(our_rows), 1e9 * median(times.rivals) / legs,
        static_cast<long long>(their_rows), 1 / median(times.ratios));
    std::fflush(stdout);
  }
}

/// Microseconds per transaction that gives one mover its plan one second later, or the plan of another mover, replaces
/// its rows, or updates a plain row.
void compare_commits(Database& db, const Schedule& schedule, int repetitions) {
  constexpr int movers = 100;
  db.run(
      "CREATE TABLE new_plans(id INTEGER PRIMARY KEY, plan);"
      "CREATE VIRTUAL TABLE plain USING moving_objects(id, t, x, y, vx, vy, r, until);"
      "INSERT INTO plain SELECT id, t, x, y, vx, vy, r, until FROM legs");
  std::vector<double> of_later, of_others, of_rows, of_plain;
  Statement plan(db, "UPDATE movers SET plan = (SELECT plan FROM new_plans WHERE id = ?1) WHERE id = ?1"),
      plain(db, "UPDATE plain SET t = t + 1 WHERE id = ?1"),
      remove(db, "DELETE FROM legs WHERE id BETWEEN ?1 * 1000 AND ?1 * 1000 + 999"),
      insert(db,
             "INSERT INTO legs SELECT ?1 * 1000 + p.leg - 1, p.t, p.x, p.y, p.vx, p.vy, 1, p.until "
             "FROM new_plans AS n, plan_rows(n.plan) AS p WHERE n.id = ?1"),
      later(db, "REPLACE INTO new_plans SELECT id, plan_shift(plan, 1) FROM movers WHERE id < 100"),
      other(db, "REPLACE INTO new_plans SELECT id % 100, plan FROM movers WHERE id / 100 = ?1");
  const auto each = [&](Statement& statement, std::int64_t ids) {
    for (std::int64_t i = 0; i < movers; ++i) statement.bind(1, i * ids), statement.step_all();
  };
  for (int i = 0; i < repetitions; ++i) {
    later.step_all();
    of_later.push_back(seconds_of([&] { each(plan, 1); }));
    of_plain.push_back(seconds_of([&] { each(plain, ids_per_mover); }));
    of_rows.push_back(seconds_of([&] {
      for (std::int64_t mover = 0; mover < movers; ++mover) {
        db.run("BEGIN");
        remove.bind(1, mover), remove.step_all();
        insert.bind(1, mover), insert.step_all();
        db.run("COMMIT");
      }
    }));
    other.bind(1, std::int64_t{i + 1}), other.step_all();
    of_others.push_back(seconds_of([&] { each(plan, 1); }));
  }
  const auto us = [](const std::vector<double>& seconds) { return 1e6 * median(seconds) / movers; };
  std::printf(
      "  commit of a plan of %d legs: a second later %.0f us, of another mover %.0f us; rows replaced "
      "%.0f us (%.3fx, %.3fx); UPDATE of a plain row %.0f us (%.2fx, %.2fx)\n",
      schedule.legs_of_mover, us(of_later), us(of_others), us(of_rows), us(of_later) / us(of_rows),
      us(of_others) / us(of_rows), us(of_plain), us(of_later) / us(of_plain), us(of_others) / us(of_plain));
}

void compare_loads(const Schedule& schedule) {
  const double legs = static_cast<double>(schedule.legs.size());
  double ns[3] = {}, bytes[3] = {};
  for (int i = 0; i < 3; ++i) {
    Database db(":memory:");
    register_foresee(db);
    const double before = used_bytes(db);
    ns[i] = i == 0   ? load_legs(db, "legs", schedule, -1e9, 1e9, false)
            : i == 1 ? load_plans(db, "movers", schedule)
                     : load_plans(db, "movers", schedule, PlanForm::text);
    bytes[i] = (used_bytes(db) - before) / legs;
  }
  std::printf(
      "  load: legs as rows %.0f ns per leg, %.1f bytes   plans from blobs %.0f ns (%.2fx), %.1f bytes   "
      "from texts %.0f ns (%.2fx), %.1f bytes\n",
      ns[0], bytes[0], ns[1], ns[1] / ns[0], bytes[1], ns[2], ns[2] / ns[0], bytes[2]);
}

void compare_scene(int movers, int legs, double h, int repetitions) {
  const Schedule schedule = make_schedule(movers, legs);
  std::printf("%d movers of %d legs\n", movers, legs);
  compare_loads(schedule);
  Database db(":memory:");
  register_foresee(db);
  load_legs(db, "legs", schedule, -1e9, 1e9, false);
  load_plans(db, "movers", schedule);
  compare_joins(db, schedule, "movers", "legs", h, repetitions);
  if (legs == 100) compare_commits(db, schedule, repetitions);
}

}  // namespace

void measure_movers(const Options& options) {
  const bool quick = options.has("--quick");
  const int repetitions = quick ? 3 : 5;
  compare_scene(quick ? 1000 : 10000, 100, 900, repetitions);
  compare_scene(quick ? 10000 : 100000, 10, 90, repetitions);
  compare_scene(quick ? 10000 : 100000, 1, 9, repetitions);
}

}  // namespace foresee::bench
