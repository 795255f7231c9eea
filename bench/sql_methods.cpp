// Choice of the method by 'auto': the join through SQL by each method, queried before, all rows stepped.
//
//   bench_sql_methods [--quick] [--csv FILE] [workload ...]
//
// Prints nanoseconds of processor time per object (medians), and the ratio of 'auto' to the fastest of grid,
// tree and scan, as the median over the rounds. In a round every method answers once, or as often as makes a
// millisecond. The scan is left out where it would take minutes. Fails if methods differ in the number of
// rows.
#include <cstdio>
#include <cstring>
#include <memory>

#include "measure.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

constexpr std::size_t max_scanned = 10000;
constexpr double enough_seconds = 1e-3;

struct Method {
  const char* name;
  std::unique_ptr<Statement> statement = {};
  std::size_t runs = 1, rows = 0;
  std::vector<double> seconds = {};

  /// Seconds of one run, after one that is not counted, because other methods have used the caches.
  double measure() {
    while (statement->step()) {
    }
    const double all = seconds_of([&] {
      for (std::size_t run = 0; run < runs; ++run)
        for (rows = 0; statement->step();) ++rows;
    });
    return all / static_cast<double>(runs);
  }
};

/// False if the methods differ.
bool compare(const std::string& name, int rounds, std::FILE* csv) {
  const Workload w = make_workload(name);
  Database db(":memory:");
  create_ours(db, w);
  load_ours(db, w);
  std::vector<Method> methods(w.count <= max_scanned ? 4 : 3);
  const char* names[] = {"auto", "grid", "tree", "scan"};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    Method& method = methods[i];
    method.name = names[i];
    method.statement =
        std::make_unique<Statement>(db, "SELECT a, b, t FROM predictive_join(" + std::to_string(w.h) +
                                            ") WHERE method = '" + method.name + "'");
    const double once = method.measure();
    method.runs = static_cast<std::size_t>(std::max(1.0, enough_seconds / once));
  }
  std::vector<double> ratios;
  for (int round = 0; round < rounds; ++round) {
    for (Method& method : methods) method.seconds.push_back(method.measure());
    double best = methods[1].seconds.back();
    for (const Method& method : methods)
      if (&method != &methods[0]) best = std::min(best, method.seconds.back());
    ratios.push_back(methods[0].seconds.back() / best);
  }
  std::printf("%-16s", name.c_str());
  if (csv) std::fprintf(csv, "%s", name.c_str());
  for (const Method& method : methods) {
    const double ns = median(method.seconds) * 1e9 / static_cast<double>(w.count);
    std::printf("  %s %9.0f", method.name, ns);
    if (csv) std::fprintf(csv, ",%.1f", ns);
    if (method.rows != methods[0].rows) return false;
  }
  std::printf("%s  auto / best %.2f\n", methods.size() < 4 ? "                " : "", median(ratios));
  if (csv) std::fprintf(csv, "%s,%.3f\n", methods.size() < 4 ? "," : "", median(ratios));
  std::fflush(stdout);
  return true;
}

int main_of(int count, char** arguments) {
  bool quick = false;
  std::FILE* csv = nullptr;
  std::vector<std::string> names;
  for (int i = 1; i < count; ++i) {
    if (std::strcmp(arguments[i], "--quick") == 0)
      quick = true;
    else if (std::strcmp(arguments[i], "--csv") == 0 && i + 1 < count)
      csv = std::fopen(arguments[++i], "w");
    else
      names.push_back(arguments[i]);
  }
  if (names.empty()) {
    names = {"S-10",        "S-30",        "S-100",        "S-300",   "S-1000",  "S-10000", "P-uniform-2000",
             "P-zipf-5000", "P-city-5000", "P-cube-10000", "M-10000", "D-10000", "C-10000", "S-100000"};
    if (!quick) names.insert(names.end(), {"K-100000", "L-30", "L-300", "M-100000", "S-1000000"});
  }
  if (csv) std::fprintf(csv, "workload,auto,grid,tree,scan,auto_to_best\n");
  for (const std::string& name : names) {
    if (compare(name, quick ? 3 : 5, csv)) continue;
    std::fprintf(stderr, "%s: the methods differ\n", name.c_str());
    return 1;
  }
  if (csv) std::fclose(csv);
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  try {
    return foresee::bench::main_of(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
