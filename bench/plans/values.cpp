// --values: the cost to make plans from rows, to read them as rows, and to store their legs in a table.
#include <cstdio>

#include "measure.h"
#include "plans/modes.h"
#include "sql.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

struct Aggregate {
  const char *name, *call;
};

constexpr Aggregate aggregates[] = {
    {"plan_points", "plan_points(t, x, y)"},
    {"plan_uniform", "plan_uniform(t, NULL, x, y, vx, vy)"},
    {"plan_accelerated", "plan_accelerated(t, NULL, x, y, vx, vy, ax, ay)"},
};

/// Rows of way-points that serve every aggregate.
void make_rows(Database& db, int movers, int legs) {
  db.run(
      "CREATE TABLE rows(mover INTEGER, t REAL, x REAL, y REAL, vx REAL, vy REAL, ax REAL, ay REAL);"
      "WITH RECURSIVE m(mover) AS (SELECT 1 UNION ALL SELECT mover + 1 FROM m WHERE mover < " +
      std::to_string(movers) + "), k(leg) AS (SELECT 0 UNION ALL SELECT leg + 1 FROM k WHERE leg < " +
      std::to_string(legs) +
      ") INSERT INTO rows SELECT mover, 10.0 * leg, mover + sin(leg), mover - cos(leg), sin(leg * 0.7), "
      "cos(leg * 0.7), 0.01 * sin(leg), 0.01 * cos(leg) FROM m, k");
}

/// Nanoseconds of processor time per leg.
void print_time(Database& db, const std::string& name, const std::string& sql, int legs, int repetitions) {
  Statement statement(db, sql);
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) seconds.push_back(seconds_of([&] { statement.step_all(); }));
  std::printf("%-24s %6.0f ns per leg\n", name.c_str(), 1e9 * median(seconds) / legs);
  std::fflush(stdout);
}

double number_of(Database& db, const std::string& sql) {
  Statement statement(db, sql);
  statement.step();
  return statement.number(0);
}

/// Loads the legs of all plans into a table, again and again.
void print_load(Database& db, int legs, int repetitions) {
  const char* const bytes = "SELECT page_count * page_size FROM pragma_page_count, pragma_page_size";
  std::vector<double> seconds;
  double added = 0;
  for (int i = 0; i < repetitions; ++i) {
    db.run(
        "DROP TABLE IF EXISTS legs; VACUUM;"
        "CREATE VIRTUAL TABLE legs USING moving_objects(id, t, x, y, vx, vy, r, until)");
    const double before = number_of(db, bytes);
    seconds.push_back(seconds_of([&] {
      db.run(
          "INSERT INTO legs(t, x, y, vx, vy, r, until) "
          "SELECT p.t, p.x, p.y, p.vx, p.vy, 0.4, p.until FROM plans, plan_rows(value) AS p");
    }));
    added = number_of(db, bytes) - before;
  }
  std::printf("%-24s %6.0f ns per leg, %.0f bytes\n", "legs into a table", 1e9 * median(seconds) / legs,
              added / legs);
}

void compare_times(int movers, int legs_of_mover, int repetitions) {
  Database db(":memory:");
  register_foresee(db);
  make_rows(db, movers, legs_of_mover);
  const int legs = movers * legs_of_mover;
  print_time(db, "the rows alone", "SELECT max(t + x + y) FROM rows GROUP BY mover", legs, repetitions);
  for (const auto& [name, call] : aggregates)
    print_time(db, name, "SELECT " + std::string(call) + " FROM rows GROUP BY mover", legs, repetitions);
  const std::string turn = "plan_turn(0, 0, 0, 0, 10, 1, 1e4, NULL, 1e-6)";
  const auto turn_legs = static_cast<int>(number_of(db, "SELECT count(*) FROM plan_rows(" + turn + ")"));
  print_time(db, "plan_turn", "SELECT " + turn, turn_legs, repetitions);
  db.run(
      "CREATE TABLE plans(mover INTEGER, value BLOB, text TEXT);"
      "INSERT INTO plans SELECT mover, plan_points(t, x, y), 'LINESTRING M(' || "
      "group_concat(printf('%!.17g %!.17g %!.17g', x, y, t)) || ')' FROM rows GROUP BY mover");
  print_time(db, "plan_rows, of a text", "SELECT count(t) FROM plans, plan_rows(text)", legs, repetitions);
  print_time(db, "plan_rows, of a blob", "SELECT count(t) FROM plans, plan_rows(value)", legs, repetitions);
  print_load(db, legs, repetitions);
}

/// In a child: what the aggregate adds to a process that holds the rows, at most.
void print_memory(int legs) {
  for (const auto& [name, call] : aggregates)
    run_in_child([&] {
      Database db(":memory:");
      register_foresee(db);
      make_rows(db, 1, legs);
      Resident::forget_peak();
      const double before = Resident::now();
      number_of(db, "SELECT length(" + std::string(call) + ") FROM rows");
      std::printf("%-24s %6.0f bytes of memory per leg\n", name, (Resident::peak() - before) / legs);
    });
}

}  // namespace

void measure_values(const Options& options) {
  const bool quick = options.has("--quick");
  print_memory(quick ? 100000 : 1000000);
  compare_times(1000, quick ? 100 : 1000, quick ? 3 : 7);
}

}  // namespace foresee::bench
