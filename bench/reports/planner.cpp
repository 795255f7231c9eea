// Plans of SQLite's query planner: statements as a user writes them, and each in the orders that CROSS JOIN
// can prescribe.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "measure.h"
#include "reports/modes.h"
#include "reports/table.h"

namespace foresee::bench {
namespace {

/// {h} stands for the horizon. All orders of a query give the same rows.
struct Question {
  const char* what;
  const char* planned;                  ///< leaves the order to the planner
  std::vector<const char*> prescribed;  ///< empty: only one order exists
  const char* where = "";
};

const Question questions[] = {
    {"table first, by x",
     "ships s JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
     {"ships s CROSS JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
      "predictive_join({h}, 'ships') j CROSS JOIN ships s ON s.id = j.a"},
     "s.x < 100"},
    {"function first, by x",
     "predictive_join({h}, 'ships') j JOIN ships s ON s.id = j.a",
     {"ships s CROSS JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
      "predictive_join({h}, 'ships') j CROSS JOIN ships s ON s.id = j.a"},
     "s.x < 100"},
    {"by a box",
     "ships s JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
     {"ships s CROSS JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
      "predictive_join({h}, 'ships') j CROSS JOIN ships s ON s.id = j.a"},
     "s.x BETWEEN 0 AND 50 AND s.y BETWEEN 0 AND 50"},
    {"by id",
     "ships s JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
     {"ships s CROSS JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
      "predictive_join({h}, 'ships') j CROSS JOIN ships s ON s.id = j.a"},
     "s.id < 1000"},
    {"by one id",
     "ships s JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
     {"ships s CROSS JOIN predictive_join({h}, 'ships') j ON j.a = s.id",
      "predictive_join({h}, 'ships') j CROSS JOIN ships s ON s.id = j.a"},
     "s.id = 1000"},
    {"both sides",
     "ships s JOIN predictive_join({h}, 'ships') j ON j.a = s.id JOIN ships o ON o.id = j.b",
     {"ships s CROSS JOIN predictive_join({h}, 'ships') j ON j.a = s.id CROSS JOIN ships o ON o.id = j.b",
      "predictive_join({h}, 'ships') j CROSS JOIN ships s ON s.id = j.a CROSS JOIN ships o ON o.id = j.b"}},
    {"LEFT JOIN", "ships s LEFT JOIN predictive_join({h}, 'ships') j ON j.a = s.id", {}, "s.x < 100"},
    {"a window per zone",
     "ships s JOIN zones z JOIN predictive_window({h}, 'ships', z.x0, z.x0 + 20, z.y0, z.y0 + 20) w ON w.id "
     "= s.id",
     {"zones z CROSS JOIN predictive_window({h}, 'ships', z.x0, z.x0 + 20, z.y0, z.y0 + 20) w CROSS JOIN "
      "ships s ON s.id = w.id"}},
};

/// Stops a statement that takes longer than that many seconds of processor time.
class Deadline {
 public:
  Deadline(Database& db, double seconds) : db_(db), end_(cpu_seconds() + seconds) {
    sqlite3_progress_handler(
        db.handle(), 1000, [](void* end) -> int { return cpu_seconds() > *static_cast<double*>(end); },
        &end_);
  }
  ~Deadline() { sqlite3_progress_handler(db_.handle(), 0, nullptr, nullptr); }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  Database& db_;
  double end_;
};

struct Answer {
  double seconds = 0;
  std::optional<std::int64_t> rows = std::nullopt;  ///< empty: not within the limit
};

std::string statement_of(const Question& question, std::string from, double h) {
  for (std::size_t at; (at = from.find("{h}")) != std::string::npos;) from.replace(at, 3, std::to_string(h));
  return "SELECT count(*) FROM " + from + (*question.where ? " WHERE " : "") + question.where;
}

/// Runs a long statement once, else five times and takes the fastest.
Answer answer_of(Database& db, const std::string& sql, double limit) {
  Statement question(db, sql);
  const Deadline deadline(db, limit);
  Answer answer{.seconds = HUGE_VAL};
  for (int times = 0; times < (answer.seconds < 0.1 ? 5 : 1); ++times) {
    const double seconds = seconds_of([&] {
      if (sqlite3_step(question.handle()) == SQLITE_ROW) answer.rows = question.integer(0);
    });
    answer.seconds = std::min(answer.seconds, seconds);
    if (!answer.rows && sqlite3_errcode(db.handle()) != SQLITE_INTERRUPT)
      db.require_ok(sqlite3_errcode(db.handle()));
    sqlite3_reset(question.handle());
  }
  return answer;
}

void compare(Database& db, const Question& question, double h) {
  const Answer planned = answer_of(db, statement_of(question, question.planned, h), HUGE_VAL);
  std::printf("  %-22s h = %-4g %9.4f s, %lld rows", question.what, h, planned.seconds,
              static_cast<long long>(*planned.rows));
  double best = HUGE_VAL;
  for (const char* order : question.prescribed) {
    const Answer answer = answer_of(db, statement_of(question, order, h), 1 + 2 * planned.seconds);
    if (answer.rows && answer.rows != planned.rows)
      throw Error(std::string(question.what) + ": two orders give different numbers of rows");
    best = std::min(best, answer.seconds);
    std::printf(", %.4f s%s", answer.seconds, answer.rows ? "" : " and more");
    std::fflush(stdout);
  }
  if (question.prescribed.empty())
    std::printf(", the only order\n");
  else
    std::printf(": %.2f times the best (mark: 2)\n", planned.seconds / best);
  std::fflush(stdout);
}

/// A thousand corners, spread over the scene as its objects are.
void make_zones(Database& db) {
  db.run("CREATE TABLE zones(x0, y0)");
  db.run("INSERT INTO zones SELECT x, y FROM ships WHERE id % (SELECT 1 + count(*) / 1000 FROM ships) = 0");
}

}  // namespace

void measure_planner(const Options& options) {
  const bool quick = options.has("--quick");
  const std::vector<std::string> few = {"S-10000", "L-30"}, all = {"S-100000", "S-1000000", "L-30"};
  for (const std::string& name : options.names(quick ? few : all)) {
    const Workload w = make_workload(name);
    Table table(Table::foresee, w, Medium::memory, "");
    table.insert_all(writes_of(w));
    make_zones(table.db());
    std::printf("planner, %s: SELECT count(*) as one writes it, and in the orders of CROSS JOIN\n",
                name.c_str());
    answer_of(table.db(), "SELECT count(*) FROM predictive_join(0, 'ships')",
              HUGE_VAL);  // the scene is cached
    compare(table.db(), questions[0], 60);
    for (const Question& question : questions) compare(table.db(), question, w.h);
  }
}

}  // namespace foresee::bench
