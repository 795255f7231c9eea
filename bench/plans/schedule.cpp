#include "plans/schedule.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "measure.h"

namespace foresee::bench {

Schedule make_schedule(int movers, int legs_of_mover) {
  Schedule schedule{{}, movers, legs_of_mover, std::sqrt(100.0 * movers)};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int mover = 0; mover < movers; ++mover) {
    double x = unit(random) * schedule.side, y = unit(random) * schedule.side,
           t = -unit(random) * leg_seconds;
    for (int leg = 0; leg < legs_of_mover; ++leg) {
      const double course = 2 * 3.141592653589793 * unit(random), speed = 0.5 + unit(random);
      double vx = speed * std::cos(course), vy = speed * std::sin(course);
      if (x + vx * leg_seconds < 0 || x + vx * leg_seconds > schedule.side) vx = -vx;
      if (y + vy * leg_seconds < 0 || y + vy * leg_seconds > schedule.side) vy = -vy;
      const double until = t + leg_seconds;
      schedule.legs.push_back({mover * ids_per_mover + leg, t, x, y, vx, vy, until});
      x += vx * leg_seconds, y += vy * leg_seconds, t = until;
    }
  }
  std::shuffle(schedule.legs.begin(), schedule.legs.end(), random);
  return schedule;
}

double load_legs(Database& db, const std::string& table, const Schedule& schedule, double from, double to,
                 bool one_by_one) {
  db.run("CREATE VIRTUAL TABLE " + table + " USING moving_objects(id, t, x, y, vx, vy, r, until)");
  Statement insert(db, "INSERT INTO " + table + " VALUES(?, ?, ?, ?, ?, ?, 1, ?)");
  std::size_t rows = 0;
  const double seconds = seconds_of([&] {
    if (!one_by_one) db.run("BEGIN");
    for (const ScheduledLeg& leg : schedule.legs) {
      if (leg.until < from || leg.t > to) continue;
      const double values[] = {leg.t, leg.x, leg.y, leg.vx, leg.vy, leg.until};
      insert.bind(1, leg.id);
      for (int i = 0; i < 6; ++i) insert.bind(2 + i, values[i]);
      insert.step();
      ++rows;
    }
    if (!one_by_one) db.run("COMMIT");
  });
  return seconds * 1e9 / static_cast<double>(rows);
}

namespace {

/// A table plans(mover, plan) of blobs that hold the same doubles as the rows, or of texts of their knots.
void make_plans(Database& db, const Schedule& schedule, PlanForm form) {
  db.run(
      "CREATE TEMP TABLE plan_legs(mover INTEGER, leg INTEGER, t, x, y, vx, vy, until);"
      "CREATE TEMP TABLE plans(mover INTEGER PRIMARY KEY, plan)");
  Statement insert(db, "INSERT INTO temp.plan_legs VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
  db.run("BEGIN");
  for (const ScheduledLeg& leg : schedule.legs) {
    const double values[] = {leg.t, leg.x, leg.y, leg.vx, leg.vy, leg.until};
    insert.bind(1, leg.id / ids_per_mover), insert.bind(2, leg.id % ids_per_mover);
    for (int i = 0; i < 6; ++i) insert.bind(3 + i, values[i]);
    insert.step();
  }
  // SQLite's bare columns beside max(leg) are those of the last leg, whose end is the last knot.
  const std::string plan =
      form == PlanForm::blob
          ? "plan_uniform(t, until, x, y, vx, vy)"
          : "'LINESTRING M(' || group_concat(printf('%!.17g %!.17g %!.17g', x, y, t), ', ') || "
            "printf(', %!.17g %!.17g %!.17g)', x + vx * (until - t), y + vy * (until - t), until)";
  db.run("INSERT INTO temp.plans SELECT mover, plan FROM (SELECT mover, max(leg), " + plan +
         " AS plan FROM (SELECT * FROM temp.plan_legs ORDER BY mover, leg) GROUP BY mover);"
         "DROP TABLE temp.plan_legs; COMMIT");
}

}  // namespace

double load_plans(Database& db, const std::string& table, const Schedule& schedule, PlanForm form) {
  make_plans(db, schedule, form);
  db.run("CREATE VIRTUAL TABLE " + table + " USING moving_objects(id, x, y, plan, r)");
  const double seconds = seconds_of(
      [&] { db.run("INSERT INTO " + table + "(id, plan, r) SELECT mover, plan, 1 FROM temp.plans"); });
  db.run("DROP TABLE temp.plans");
  return seconds * 1e9 / static_cast<double>(schedule.legs.size());
}

double used_bytes(Database& db) {
  Statement bytes(db,
                  "SELECT (page_count - freelist_count) * page_size "
                  "FROM pragma_page_count, pragma_freelist_count, pragma_page_size");
  bytes.step();
  return bytes.number(0);
}

}  // namespace foresee::bench
