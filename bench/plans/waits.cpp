// --waits: a wait of one mover among others, for plans of a few and of many legs.
#include <cstdio>
#include <random>

#include "measure.h"
#include "plans/modes.h"
#include "sql.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

/// Random way-points in a square of 40 m, one every 3 s.
void make_movers(Database& db, int movers, int legs) {
  register_foresee(db);
  db.run(
      "CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y, plan, r);"
      "CREATE TABLE rows(mover, t, x, y, PRIMARY KEY(mover, t))");
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(0, 40);
  Statement insert(db, "INSERT INTO rows VALUES (?1, ?2, ?3, ?4)");
  for (int mover = 1; mover <= movers; ++mover)
    for (int i = 0; i <= legs; ++i) {
      insert.bind(1, static_cast<std::int64_t>(mover));
      insert.bind(2, 3.0 * i);
      insert.bind(3, place(random));
      insert.bind(4, place(random));
      insert.step_all();
    }
  db.run("INSERT INTO robots(id, plan, r) SELECT mover, plan_points(t, x, y), 0.4 FROM rows GROUP BY mover");
}

double seconds_of_wait(int movers, int legs, int repetitions) {
  Database db(":memory:");
  make_movers(db, movers, legs);
  Statement wait(db, "SELECT clear, k_from, k_to FROM predictive_avoid(" + std::to_string(3 * legs) +
                         ", 'robots', 1, 0.5, 'wait', 0, 60, 5)");
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) seconds.push_back(seconds_of([&] { wait.step_all(); }));
  return median(seconds);
}

}  // namespace

void measure_waits(const Options& options) {
  constexpr int movers = 3;
  const int few = options.has("--quick") ? 200 : 2000, many = 10 * few;
  const double short_plans = seconds_of_wait(movers, few, 5), long_plans = seconds_of_wait(movers, many, 3);
  std::printf("wait among %d plans of %d legs %.0f us per leg, of %d legs %.0f us (%.2fx per leg)\n", movers,
              few, 1e6 * short_plans / few, many, 1e6 * long_plans / many,
              long_plans / many / (short_plans / few));
}

}  // namespace foresee::bench
