// Does SQLite's planner find the way? A join's pairs beside their objects, as one writes it, and in both
// orders that CROSS JOIN can prescribe.
#include <cmath>
#include <cstdio>
#include <optional>

#include "measure.h"
#include "reports/modes.h"
#include "reports/table.h"

namespace foresee::bench {
namespace {

struct Way {
  const char* what;
  const char* sql;
};

/// The first leaves the order to the planner.
constexpr Way ways[] = {
    {"s JOIN j", "FROM ships s JOIN predictive_join(60, 'ships') j ON j.a = s.id"},
    {"s CROSS JOIN j", "FROM ships s CROSS JOIN predictive_join(60, 'ships') j ON j.a = s.id"},
    {"j CROSS JOIN s", "FROM predictive_join(60, 'ships') j CROSS JOIN ships s ON s.id = j.a"},
};

/// Stops what takes longer than that many seconds of processor time.
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
  std::optional<std::int64_t> rows = std::nullopt;  ///< none: not within the limit
};

Answer ask(Database& db, const Way& way, double limit) {
  Statement question(db, std::string("SELECT count(*) ") + way.sql + " WHERE s.x < 100");
  const Deadline deadline(db, limit);
  Answer answer;
  answer.seconds = seconds_of([&] {
    if (sqlite3_step(question.handle()) == SQLITE_ROW) answer.rows = question.integer(0);
  });
  if (!answer.rows && sqlite3_errcode(db.handle()) != SQLITE_INTERRUPT)
    db.require_ok(sqlite3_errcode(db.handle()));
  return answer;
}

}  // namespace

void measure_planner(const Options& options) {
  const bool quick = options.has("--quick");
  const std::vector<std::string> few = {"S-10000", "L-30"}, all = {"S-100000", "L-30"};
  for (const std::string& name : options.names(quick ? few : all)) {
    const Workload w = make_workload(name);
    Table table(Table::foresee, w, Medium::memory, "");
    table.insert_all(writes_of(w));
    std::printf("planner, %s: SELECT count(*) … WHERE s.x < 100\n", name.c_str());
    Answer planned;
    for (const Way& way : ways) {
      const bool first = !planned.rows;
      const Answer answer = ask(table.db(), way, first ? HUGE_VAL : 1 + 2 * planned.seconds);
      if (first) planned = answer;
      if (answer.rows && answer.rows != planned.rows)
        throw Error(name + ": the ways through the join give different numbers of rows");
      std::printf("  %-16s %10.3f s%s, the planner's way %6.2f times that (mark: 2)\n", way.what,
                  answer.seconds, answer.rows ? "" : " and more", planned.seconds / answer.seconds);
      std::fflush(stdout);
    }
    std::printf("  %lld rows\n", static_cast<long long>(*planned.rows));
  }
}

}  // namespace foresee::bench
