// Schedules through SQL: movers whose legs are rows (t … until), beside a table of the legs of one minute only.
//
//   bench_sql_schedules [--quick] [--one-by-one]
//
//   10,000 movers between random way-points, one per 100 m², 100 legs of 10 s each at 0.5 to 1.5 m/s, r = 1 m,
//   in one table; the other holds the legs that live in [500, 620]. Queries start at 500 to 560, with h = 0,
//   10 and 60: windows of 33 m, the 10 nearest, and all that meets one leg (a = ?).
//   --one-by-one: the legs arrive shuffled, a row per transaction; else shuffled in one transaction.
//   --quick: 1,000 movers.
//
// In memory; processor time per query, medians of repetitions; the ratio is within a repetition. Fails if the
// tables give different rows.
#include <bit>
#include <cmath>
#include <cstdio>
#include <random>

#include "measure.h"
#include "program.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

struct Leg {
  std::int64_t id;
  double t, x, y, vx, vy, until;
};

struct Schedule {
  std::vector<Leg> legs;  ///< shuffled
  double side;
};

Schedule make_schedule(int movers) {
  constexpr int legs_of_mover = 100;
  constexpr double duration = 10;
  Schedule schedule{{}, std::sqrt(100.0 * movers)};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int mover = 0; mover < movers; ++mover) {
    double x = unit(random) * schedule.side, y = unit(random) * schedule.side, t = -unit(random) * duration;
    for (int leg = 0; leg < legs_of_mover; ++leg, t += duration) {
      const double course = 2 * 3.141592653589793 * unit(random), speed = 0.5 + unit(random);
      double vx = speed * std::cos(course), vy = speed * std::sin(course);
      if (x + vx * duration < 0 || x + vx * duration > schedule.side) vx = -vx;
      if (y + vy * duration < 0 || y + vy * duration > schedule.side) vy = -vy;
      schedule.legs.push_back({mover * 1000LL + leg, t, x, y, vx, vy, t + duration});
      x += vx * duration, y += vy * duration;
    }
  }
  std::shuffle(schedule.legs.begin(), schedule.legs.end(), random);
  return schedule;
}

/// Loads the legs that live in [from, to]; returns nanoseconds per leg.
double load(Database& db, const char* table, const Schedule& schedule, double from, double to,
            bool one_by_one) {
  db.run("CREATE VIRTUAL TABLE " + std::string(table) +
         " USING moving_objects(id, t, x, y, vx, vy, r, until)");
  Statement insert(db, "INSERT INTO " + std::string(table) + " VALUES(?, ?, ?, ?, ?, ?, 1, ?)");
  std::size_t rows = 0;
  const double seconds = seconds_of([&] {
    if (!one_by_one) db.run("BEGIN");
    for (const Leg& leg : schedule.legs) {
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

enum class Question { window, nearest, partners };
constexpr Question all_questions[] = {Question::window, Question::nearest, Question::partners};
constexpr const char* names[] = {"window", "10 nearest", "a = ?"};

std::string sql_of(Question question, const std::string& table) {
  if (question == Question::window)
    return "SELECT id, t FROM predictive_window WHERE h = ?1 AND tbl = '" + table +
           "' AND x0 = ?3 AND x1 = ?3 + 33 AND y0 = ?4 AND y1 = ?4 + 33 AND now = ?2";
  if (question == Question::nearest)
    return "SELECT id, distance FROM predictive_nearest WHERE h = ?1 AND tbl = '" + table +
           "' AND k = 10 AND x = ?3 AND y = ?4 AND now = ?2";
  return "SELECT b, t FROM predictive_join WHERE h = ?1 AND tbl = '" + table + "' AND now = ?2 AND a = ?5";
}

struct Run {
  double seconds;
  std::uint64_t sum;  ///< of the bits of all rows, in any order, to compare tables
  std::int64_t rows;
};

Run run(Statement& statement, const Schedule& schedule, Question question, double h, int queries) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> place(0, schedule.side - 33), start(500, 560);
  Run run{0, 0, 0};
  run.seconds = seconds_of([&] {
    for (int i = 0; i < queries; ++i) {
      const double now = start(random);
      statement.bind(1, h), statement.bind(2, now);
      if (question == Question::partners) {
        const auto mover = static_cast<std::int64_t>(random() % (schedule.legs.size() / 100));
        statement.bind(5, mover * 1000 + static_cast<std::int64_t>(now / 10));
      } else {
        statement.bind(3, place(random)), statement.bind(4, place(random));
      }
      for (; statement.step(); ++run.rows)
        run.sum += static_cast<std::uint64_t>(statement.integer(0)) *
                   std::bit_cast<std::uint64_t>(statement.number(1));
    }
  });
  return run;
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick"), one_by_one = options.has("--one-by-one");
  const Schedule schedule = make_schedule(quick ? 1000 : 10000);
  const int repetitions = quick ? 3 : 7, queries = 200;
  Database db(":memory:");
  register_foresee(db);
  const double all = load(db, "legs", schedule, -1e9, 1e9, one_by_one);
  std::printf("%zu legs, %s: %.0f ns per leg\n", schedule.legs.size(),
              one_by_one ? "a row per transaction" : "one transaction", all);
  load(db, "minutes", schedule, 500, 620, one_by_one);
  for (const Question question : all_questions)
    for (const double h : {0.0, 10.0, 60.0}) {
      Statement ours(db, sql_of(question, "legs")), few(db, sql_of(question, "minutes"));
      Comparison times;
      for (int i = 0; i < repetitions; ++i) {
        const Run whole = run(ours, schedule, question, h, queries),
                  part = run(few, schedule, question, h, queries);
        if (whole.rows != part.rows || whole.sum != part.sum) {
          std::fprintf(stderr, "%s, h = %g: the tables give different rows\n",
                       names[static_cast<int>(question)], h);
          return 1;
        }
        times.add(whole.seconds / queries, part.seconds / queries);
        if (i == 0)
          std::printf("%-11s h = %2g  %6.1f rows", names[static_cast<int>(question)], h,
                      static_cast<double>(whole.rows) / queries);
      }
      std::vector<double> ratios;
      for (const double ratio : times.ratios) ratios.push_back(1 / ratio);
      std::printf("   all legs %8.1f us   those of two minutes %8.1f us   %6.2fx\n", median(times.ours) * 1e6,
                  median(times.rivals) * 1e6, median(ratios));
      std::fflush(stdout);
    }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
