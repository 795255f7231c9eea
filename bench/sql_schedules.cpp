// Schedules through SQL: movers whose legs are rows (t … until) or plans, beside a table of the legs of one minute.
//
//   bench_sql_schedules [--quick] [--one-by-one]
//
//   10,000 movers between random way-points, one per 100 m², 100 legs of 10 s each at 0.5 to 1.5 m/s, r = 1 m,
//   in one table; one row per mover with a column plan in the second; the third holds the legs that live in
//   [500, 620]. Queries start at 500 to 560, with h = 0, 10 and 60: windows of 33 m, the 10 nearest, and all that
//   meets one leg, or one mover (a = ?).
//   --one-by-one: the legs arrive shuffled, a row per transaction; else shuffled in one transaction.
//   --quick: 1,000 movers.
//
// In memory; processor time per query, medians of repetitions; the ratio is within a repetition. Fails if the
// tables give different rows: of plans, the first contact of each mover in a window, and the distance of the nearest.
#include <bit>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "measure.h"
#include "plans/schedule.h"
#include "program.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

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

/// The rows of each query, one after the other; `plans`: of a table with a row per mover.
template <class Use>
void for_each_row(Statement& statement, const Schedule& schedule, Question question, double h, int queries,
                  bool plans, Use use) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> place(0, schedule.side - 33), start(500, 560);
  for (int i = 0; i < queries; ++i) {
    const double now = start(random);
    statement.bind(1, h), statement.bind(2, now);
    if (question == Question::partners) {
      const auto mover = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(schedule.movers));
      const auto leg = static_cast<std::int64_t>(now / leg_seconds);
      statement.bind(5, plans ? mover : mover * ids_per_mover + leg);
    } else {
      statement.bind(3, place(random)), statement.bind(4, place(random));
    }
    while (statement.step()) use(i, statement.integer(0), statement.number(1));
  }
}

Run run(Statement& statement, const Schedule& schedule, Question question, double h, int queries,
        bool plans = false) {
  Run run{0, 0, 0};
  run.seconds = seconds_of([&] {
    for_each_row(statement, schedule, question, h, queries, plans, [&](int, std::int64_t id, double number) {
      run.sum += static_cast<std::uint64_t>(id) * std::bit_cast<std::uint64_t>(number), ++run.rows;
    });
  });
  return run;
}

/// Whether plans and the legs of that minute have the same first contacts in windows, or the same smallest distances.
bool agree(Statement& plans, Statement& few, const Schedule& schedule, Question question, double h,
           int queries) {
  if (question == Question::partners) return true;  // of a leg, and of a mover
  std::map<std::pair<int, std::int64_t>, double> ours, theirs;
  const auto keep_min = [&](auto& smallest, std::int64_t ids) {
    return [&smallest, ids, question](int query, std::int64_t id, double number) {
      const auto key = std::pair(query, question == Question::window ? id / ids : 0);
      const auto [found, is_new] = smallest.try_emplace(key, number);
      if (!is_new) found->second = std::min(found->second, number);
    };
  };
  for_each_row(plans, schedule, question, h, queries, true, keep_min(ours, 1));
  for_each_row(few, schedule, question, h, queries, false, keep_min(theirs, ids_per_mover));
  return ours == theirs;
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick"), one_by_one = options.has("--one-by-one");
  const Schedule schedule = make_schedule(quick ? 1000 : 10000, 100);
  const int repetitions = quick ? 3 : 7, queries = 200;
  Database db(":memory:");
  register_foresee(db);
  const double all = load_legs(db, "legs", schedule, -1e9, 1e9, one_by_one);
  std::printf("%zu legs, %s: %.0f ns per leg\n", schedule.legs.size(),
              one_by_one ? "a row per transaction" : "one transaction", all);
  load_legs(db, "minutes", schedule, 500, 620, one_by_one);
  load_plans(db, "movers", schedule);
  for (const Question question : all_questions)
    for (const double h : {0.0, 10.0, 60.0}) {
      Statement ours(db, sql_of(question, "legs")), few(db, sql_of(question, "minutes")),
          plans(db, sql_of(question, "movers"));
      Comparison times, plan_times;
      if (!agree(plans, few, schedule, question, h, queries)) {
        std::fprintf(stderr, "%s, h = %g: plans and legs differ\n", names[static_cast<int>(question)], h);
        return 1;
      }
      for (int i = 0; i < repetitions; ++i) {
        const Run whole = run(ours, schedule, question, h, queries),
                  part = run(few, schedule, question, h, queries);
        if (whole.rows != part.rows || whole.sum != part.sum) {
          std::fprintf(stderr, "%s, h = %g: the tables give different rows\n",
                       names[static_cast<int>(question)], h);
          return 1;
        }
        times.add(whole.seconds / queries, part.seconds / queries);
        plan_times.add(run(plans, schedule, question, h, queries, true).seconds / queries,
                       part.seconds / queries);
        if (i == 0)
          std::printf("%-11s h = %2g  %6.1f rows", names[static_cast<int>(question)], h,
                      static_cast<double>(whole.rows) / queries);
      }
      std::printf("   those of two minutes %8.1f us   all legs %8.1f us %6.2fx   plans %8.1f us %6.2fx\n",
                  median(times.rivals) * 1e6, median(times.ours) * 1e6, 1 / median(times.ratios),
                  median(plan_times.ours) * 1e6, 1 / median(plan_times.ratios));
      std::fflush(stdout);
    }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
