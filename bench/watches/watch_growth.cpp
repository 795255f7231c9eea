// One report per commit at sixteen times the objects; and a table without a watch, beside one in a file that
// has a watch of another table.
#include "files.h"
#include "measure.h"
#include "reports/table.h"
#include "watches/modes.h"

namespace foresee::bench {
namespace {

constexpr std::size_t commits = 2000;

/// Loaded with the objects of a feed.
struct FedTable {
  FedTable(const std::string& scene, const std::string& name)
      : file(name),
        feed(make_workload(scene)),
        table(Table::foresee, feed.objects(), Medium::journal, file.path) {
    table.insert_all(writes_of(feed.objects()));
  }

  /// Seconds per commit of one report.
  double report_alone() {
    const Writes writes = writes_of(feed.random_reports(commits), feed.objects());
    return seconds_of([&] {
             for (std::size_t i = 0; i < commits; ++i) table.update_alone(writes, i);
           }) /
           static_cast<double>(commits);
  }

  ScratchFile file;
  Feed feed;
  Table table;
};

void watch(FedTable& objects) {
  objects.table.db().run("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 3)");
}

void compare_sizes(bool quick) {
  FedTable few(quick ? "S-6250" : "S-62500", "few"), many(quick ? "S-100000" : "S-1000000", "many");
  watch(few), watch(many);
  Comparison times;
  for (int i = 0; i < (quick ? 3 : 7); ++i) {
    const double of_many = many.report_alone();
    times.add(few.report_alone(), of_many);
  }
  std::printf("one report a commit: a watch of %zu objects takes %.3f ms, of %zu %.3f ms\n",
              few.feed.objects().count, median(times.ours) * 1e3, many.feed.objects().count,
              median(times.rivals) * 1e3);
  print_figure("  16 times the objects / those", median(times.ratios), Bound::at_most, 2);
}

void compare_without_watch(bool quick) {
  const std::string scene = quick ? "S-10000" : "S-100000";
  FedTable alone(scene, "alone"), beside(scene, "beside");
  beside.table.db().run(
      "CREATE VIRTUAL TABLE other USING moving_objects(id, x, y);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(other, horizon = 3); INSERT INTO other VALUES (1, "
      "0, 0)");
  Comparison times;
  for (int i = 0; i < (quick ? 5 : 15); ++i) {
    const double with_another = beside.report_alone();
    times.add(alone.report_alone(), with_another);
  }
  std::printf("%s without a watch, one report a commit: %.3f ms\n", scene.c_str(), median(times.ours) * 1e3);
  print_figure("  where another table of the file has a watch / where none has", median(times.ratios),
               Bound::at_most, 1.05);
}

}  // namespace

void measure_watch_growth(const Options& options) {
  compare_sizes(options.has("--quick"));
  compare_without_watch(options.has("--quick"));
}

}  // namespace foresee::bench
