// Does SQLite's planner find the way? A join's pairs beside their objects, as one writes it, and in both
// orders that CROSS JOIN can prescribe.
#include <cstdio>

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

}  // namespace

void measure_planner(const Options& options) {
  for (const std::string& name : options.names({"S-100000"})) {
    const Workload w = make_workload(name);
    Table table(Table::foresee, w, Medium::memory, "");
    table.insert_all(writes_of(w));
    double planned = 0;
    std::int64_t rows = 0;
    std::printf("planner, %s: SELECT count(*) … WHERE s.x < 100\n", name.c_str());
    for (const Way& way : ways) {
      Statement question(table.db(), std::string("SELECT count(*) ") + way.sql + " WHERE s.x < 100");
      std::int64_t found = 0;
      const double seconds = seconds_of([&] {
        question.step();
        found = question.integer(0);
        question.step();
      });
      if (planned == 0) planned = seconds, rows = found;
      if (found != rows) throw Error(name + ": the ways through the join give different numbers of rows");
      std::printf("  %-16s %10.3f s, the planner's %6.2f times that (mark: 2), %lld rows\n", way.what,
                  seconds, planned / seconds, static_cast<long long>(found));
      std::fflush(stdout);
    }
  }
}

}  // namespace foresee::bench
