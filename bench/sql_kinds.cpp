// What inert objects cost a join: half of the objects have category 1 and mask 0, and meet none of the others, which
// have 2 and 2. The rival is the join of a table of the other half alone, without kinds.
//
//   bench_sql_kinds [--quick] [workload ...]               usually S-100000
//
//   warm    SELECT a, b, t FROM predictive_join(h), all rows stepped; queried before
//   count   SELECT count(*) of the same
//   tree    as warm, method = 'tree'
//   cold    as warm, from opening the file to the last row
//   plain   as warm, of all objects in a table with kinds that are all the default, beside one without kinds
//
// Processor time, medians; a ratio is the time with kinds over the other in the same repetition. Goal for the first
// two: at most 1.2. Fails if the pairs differ.
#include <cstdio>

#include "files.h"
#include "measure.h"
#include "program.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

/// The workload in one file: `halved` with kinds, `half` without, `defaults` with kinds, and `ships` without.
void build(Database& db, const Workload& w) {
  create_ours(db, w);
  load_ours(db, w);
  const std::string columns = columns_of(w);
  const auto table = [&](const std::string& name, const std::string& kinds, const std::string& values) {
    db.run("CREATE VIRTUAL TABLE " + name + " USING moving_objects(id, " + columns + kinds + ")");
    db.run("INSERT INTO " + name + " SELECT id, " + columns + values);
  };
  table("halved", ", category, mask", ", iif(id % 2, 2, 1), iif(id % 2, 2, 0) FROM ships");
  table("half", "", " FROM ships WHERE id % 2");
  table("defaults", ", category, mask", ", NULL, NULL FROM ships");
}

std::string join(const Workload& w, const std::string& table) {
  return "predictive_join WHERE h = " + std::to_string(w.h) + " AND now = 0 AND tbl = '" + table + "'";
}

double seconds_to_step(Database& db, const std::string& sql) {
  Statement statement(db, sql);
  return seconds_of([&] {
    while (statement.step()) {
    }
  });
}

/// Medians of both times and of their ratio.
struct Sides {
  std::vector<double> kinds = {}, other = {}, ratios = {};

  void add(double with_kinds, double without) {
    kinds.push_back(with_kinds), other.push_back(without), ratios.push_back(with_kinds / without);
  }
  void print(const Workload& w, const char* what) const {
    std::printf("%-12s %-6s with kinds %8.2f ms   without %8.2f ms   %5.2fx\n", w.name.c_str(), what,
                median(kinds) * 1e3, median(other) * 1e3, median(ratios));
    std::fflush(stdout);
  }
};

std::int64_t checksum(Database& db, const Workload& w, const std::string& table) {
  Statement sum(db, "SELECT sum(a * 31 + b) FROM " + join(w, table));
  return sum.step() ? sum.integer(0) : 0;
}

bool compare(const Workload& w, int repetitions) {
  const TwoFiles files;
  Database db(files.ours);
  build(db, w);
  const auto pair = [&](const char* what, const std::string& select, const std::string& more,
                        const char* kinds, const char* without) {
    Sides sides;
    for (int i = 0; i <= repetitions; ++i) {
      const double with_kinds = seconds_to_step(db, select + join(w, kinds) + more);
      const double other = seconds_to_step(db, select + join(w, without) + more);
      if (i > 0) sides.add(with_kinds, other);
    }
    sides.print(w, what);
  };
  pair("warm", "SELECT a, b, t FROM ", "", "halved", "half");
  pair("count", "SELECT count(*) FROM ", "", "halved", "half");
  pair("tree", "SELECT a, b, t FROM ", " AND method = 'tree'", "halved", "half");
  Sides cold;
  const auto from_file = [&](const char* table) {
    return seconds_of([&] {
      Database fresh(files.ours);
      register_foresee(fresh);
      seconds_to_step(fresh, "SELECT a, b, t FROM " + join(w, table));
    });
  };
  for (int i = 0; i <= repetitions; ++i) {
    const double with_kinds = from_file("halved"), other = from_file("half");
    if (i > 0) cold.add(with_kinds, other);
  }
  cold.print(w, "cold");
  pair("plain", "SELECT a, b, t FROM ", "", "defaults", "ships");
  return checksum(db, w, "halved") == checksum(db, w, "half") &&
         checksum(db, w, "defaults") == checksum(db, w, "ships");
}

int main_of(const Options& options) {
  for (const std::string& name : options.names({"S-100000"}))
    if (!compare(make_workload(name), options.has("--quick") ? 5 : 21)) {
      std::fprintf(stderr, "%s: the pairs differ\n", name.c_str());
      return 1;
    }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
