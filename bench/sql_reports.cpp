// Storage at the speed of a feed: reports, loads and look-ups through SQL.
//
//   bench_sql_reports [--quick] [--updates] [scene ...]
//
// The objects of a scene (workloads.h) report where they are and how they move on: reports/feed.h says how a
// report is made. Ours is a moving_objects table with t; the rival an ordinary table of the same columns with
// SQLite's R*Tree of the boxes swept over the scene's horizon beside it, of which a report updates both. All
// statements are prepared; a report is one single-row UPDATE, by id, of t, position, speed and acceleration
// (where the scene has one). Tables are in memory, in a file with the default journal, or in one with WAL.
//
//   --updates  S-100000, S-1000000, P-zipf-5000, L-30, M-100000, each in every medium:
//              100,000 reports of random objects in one transaction, against the R*Tree;
//              one report of every object in one transaction, against a load of the same rows in memory, and
//              against the ordinary table alone;
//              one report a transaction, against the R*Tree.
//              (--quick: S-100000 and P-zipf-5000, in memory.)
//
// Processor time, medians; a ratio is the other side's time over ours in the same repetition. Fails if two
// sides that must agree hold other rows or give other answers.
#include "reports/modes.h"

namespace foresee::bench {
namespace {

int main_of(const Options& options) {
  const std::pair<const char*, void (*)(const Options&)> modes[] = {
      {"--updates", measure_updates}, {"--commits", measure_commits}, {"--loads", measure_loads},
      {"--lookups", measure_lookups}, {"--after", measure_after},     {"--planner", measure_planner}};
  const bool all = std::none_of(std::begin(modes), std::end(modes),
                                [&](const auto& mode) { return options.has(mode.first); });
  for (const auto& [flag, measure] : modes)
    if (all || options.has(flag)) measure(options);
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
