// Commits of one report: the usual one, the slowest, and the pages that they write.
#include <cstdio>

#include "measure.h"
#include "reports/modes.h"
#include "reports/two_tables.h"

namespace foresee::bench {
namespace {

/// The costs of single commits, in order.
struct Commits {
  std::vector<double> seconds;
  std::vector<double> pages;
};

/// The WAL is written into the file between commits and is not measured: that is SQLite's work, equal for all
/// tables.
Commits commit_one_by_one(Table& table, const Writes& writes, Medium medium) {
  constexpr std::size_t commits_a_checkpoint = 100;
  if (medium == Medium::wal) table.db().run("PRAGMA wal_autocheckpoint = 0");
  Commits commits;
  for (std::size_t i = 0; i < writes.size(); ++i) {
    if (medium == Medium::wal && i % commits_a_checkpoint == 0) table.db().run("PRAGMA wal_checkpoint");
    table.db().pages_written();
    commits.seconds.push_back(seconds_of([&] { table.update_alone(writes, i); }));
    commits.pages.push_back(table.db().pages_written());
  }
  return commits;
}

void print(const char* whose, const Commits& commits) {
  std::vector<double> seconds = commits.seconds, pages = commits.pages;
  std::sort(seconds.begin(), seconds.end());
  std::sort(pages.begin(), pages.end());
  const auto at = [](const std::vector<double>& sorted, double part) {
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
  };
  std::printf("  %-8s median %7.1f   99.9 %% within %8.1f   slowest %8.1f us (%.1f times the median)\n",
              whose, at(seconds, 0.5) * 1e6, at(seconds, 0.999) * 1e6, seconds.back() * 1e6,
              seconds.back() / at(seconds, 0.5));
  std::printf("  %-8s median %7.0f   99.9 %% within %8.0f   most    %8.0f pages written\n", "",
              at(pages, 0.5), at(pages, 0.999), pages.back());
}

}  // namespace

void measure_commits(const Options& options) {
  const bool quick = options.has("--quick");
  const std::size_t count = quick ? 10000 : 100000;
  for (const std::string& name : options.names({quick ? "S-100000" : "S-1000000"}))
    for (const Medium medium : mediums_of(options, {Medium::journal, Medium::wal})) {
      Feed feed(make_workload(name));
      TwoTables tables(feed, medium, Table::rtree);
      const Writes writes = writes_of(feed.random_reports(count), feed.objects());
      std::printf("%zu commits of one report, %s, %s\n", count, name.c_str(), name_of(medium));
      print("foresee", commit_one_by_one(tables.ours, writes, medium));
      std::fflush(stdout);
      print("R*Tree", commit_one_by_one(tables.rival, writes, medium));
      tables.require_same_rows();
      std::fflush(stdout);
    }
}

}  // namespace foresee::bench
