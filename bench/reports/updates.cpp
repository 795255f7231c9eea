// 100,000 reports of random objects in one transaction, against the R*Tree; every object once, against a load
// and an ordinary table; one report per transaction, against the R*Tree.
#include <cstdio>

#include "measure.h"
#include "reports/modes.h"
#include "reports/two_tables.h"

namespace foresee::bench {
namespace {

constexpr std::size_t reports_a_transaction = 100000;

void print(const std::string& what, const Comparison& times, const char* rival, std::size_t count,
           double mark) {
  const double a_row = 1e6 / static_cast<double>(count);
  std::printf("%-48s foresee %8.2f   %-14s %8.2f us per row   %6.2fx (mark: %.2gx)\n", what.c_str(),
              median(times.ours) * a_row, rival, median(times.rivals) * a_row, median(times.ratios), mark);
  std::fflush(stdout);
}

/// Many reports in one transaction.
void compare_batches(const Workload& scene, Medium medium, int repetitions) {
  Feed feed(scene);
  TwoTables tables(feed, medium, Table::rtree);
  Comparison times;
  for (int i = 0; i < repetitions; ++i) {
    const Writes writes = writes_of(feed.random_reports(reports_a_transaction), feed.objects());
    const double ours = seconds_of([&] { tables.ours.update_all(writes); });
    times.add(ours, seconds_of([&] { tables.rival.update_all(writes); }));
  }
  tables.require_same_rows();
  print("100,000 reports, " + scene.name + ", " + name_of(medium), times, "R*Tree", reports_a_transaction,
        scene.name == "S-100000" ? 6 : 5);
}

double seconds_of_load(const Workload& w) {
  const Writes rows = writes_of(w);
  Table fresh(Table::foresee, w, Medium::memory, "");
  return seconds_of([&] { fresh.insert_all(rows); });
}

/// Every object once in one transaction: in memory beside a load of the same rows, in a file beside an
/// ordinary table.
void compare_all_rows(const Workload& scene, Medium medium, int repetitions) {
  Feed feed(scene);
  TwoTables tables(feed, medium, Table::ordinary);
  Comparison times;
  for (int i = 0; i < repetitions; ++i) {
    const Writes writes = writes_of(feed.reports_of_all(), feed.objects());
    const double ours = seconds_of([&] { tables.ours.update_all(writes); });
    const double ordinary = seconds_of([&] { tables.rival.update_all(writes); });
    times.add(ours, medium == Medium::memory ? seconds_of_load(feed.objects()) : ordinary);
  }
  tables.require_same_rows();
  const bool in_memory = medium == Medium::memory;
  print("all rows once, " + scene.name + ", " + name_of(medium), times, in_memory ? "load" : "ordinary table",
        scene.count, in_memory ? 1 / 1.5 : 1);
}

/// One report per transaction.
void compare_single_reports(const Workload& scene, Medium medium, int repetitions) {
  constexpr std::size_t commits = 2000;
  Feed feed(scene);
  TwoTables tables(feed, medium, Table::rtree);
  Comparison times;
  for (int i = 0; i < repetitions; ++i) {
    const Writes writes = writes_of(feed.random_reports(commits), feed.objects());
    const auto one_by_one = [&](Table& table) {
      return seconds_of([&] {
        for (std::size_t k = 0; k < writes.size(); ++k) table.update_alone(writes, k);
      });
    };
    const double ours = one_by_one(tables.ours);
    times.add(ours, one_by_one(tables.rival));
  }
  tables.require_same_rows();
  print("one report a transaction, " + scene.name + ", " + name_of(medium), times, "R*Tree", commits, 1);
}

}  // namespace

void measure_updates(const Options& options) {
  const bool quick = options.has("--quick");
  const std::vector<std::string> few = {"S-100000", "P-zipf-5000"};
  const std::vector<std::string> all = {"S-100000", "S-1000000", "P-zipf-5000", "L-30", "M-100000"};
  std::vector<Medium> mediums = {Medium::memory};
  if (!quick) mediums.insert(mediums.end(), {Medium::journal, Medium::wal});
  for (const std::string& name : options.names(quick ? few : all)) {
    const Workload scene = make_workload(name);
    const int repetitions = quick || scene.count > 500000 ? 3 : 5;
    for (const Medium medium : mediums_of(options, mediums)) {
      compare_batches(scene, medium, repetitions);
      compare_all_rows(scene, medium, repetitions);
      compare_single_reports(scene, medium, 5);
    }
  }
}

}  // namespace foresee::bench
