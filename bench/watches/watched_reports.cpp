// k reports per commit: a watch beside a join compared at each commit, an R*Tree with a trigger, and an
// R*Tree without.
#include "files.h"
#include "measure.h"
#include "watches/compared_join.h"
#include "watches/modes.h"
#include "watches/triggered_pairs.h"

namespace foresee::bench {
namespace {

constexpr const char* watch_of_ships =
    "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 3)";

void commit_reports(Table& table, const Writes& writes, std::size_t first, std::size_t count) {
  table.db().run("BEGIN");
  for (std::size_t i = first; i < first + count; ++i) table.update(writes, i);
  table.db().run("COMMIT");
}

/// The same objects four times, each copy with its own method to keep the pairs, or without.
struct Sides {
  explicit Sides(const Workload& w)
      : watched(Table::foresee, w, Medium::journal, watched_file.path),
        joined(Table::foresee, w, Medium::journal, joined_file.path),
        plain(Table::rtree, w, Medium::journal, plain_file.path),
        triggered_db(triggered_file.path) {
    const Writes all = writes_of(w);
    for (Table* table : {&watched, &joined, &plain}) table->insert_all(all);
    watched.db().run(watch_of_ships);
    compared = std::make_unique<ComparedJoin>(joined.db(), "predictive_join(3, 'ships')");
    triggered_db.run("PRAGMA synchronous = OFF");
    triggered = std::make_unique<TriggeredPairs>(triggered_db, objects = w);
  }

  ScratchFile watched_file{"watched"}, joined_file{"joined"}, plain_file{"plain"},
      triggered_file{"triggered"};
  Workload objects;
  Table watched, joined, plain;
  Database triggered_db;
  std::unique_ptr<ComparedJoin> compared;
  std::unique_ptr<TriggeredPairs> triggered;
};

/// The side of the join commits the first `joins` of them so, the rest at once at the end.
struct Commits {
  std::size_t reports, count, joins;
};

void compare_commits(Sides& sides, Feed& feed, const Commits& commits) {
  const std::size_t k = commits.reports, all = k * commits.count;
  const Writes writes = writes_of(feed.random_reports(all), feed.objects());
  const auto each = [&](auto commit) {
    return seconds_of([&] {
             for (std::size_t i = 0; i < all; i += k) commit(i);
           }) /
           static_cast<double>(commits.count);
  };
  const auto join_and_commit = [&](std::size_t first, std::size_t count) {
    sides.joined.db().run("BEGIN");
    for (std::size_t i = first; i < first + count; ++i) sides.joined.update(writes, i);
    sides.compared->update();
    sides.joined.db().run("COMMIT");
  };
  const double watched = each([&](std::size_t i) { commit_reports(sides.watched, writes, i, k); });
  const double plain = each([&](std::size_t i) { commit_reports(sides.plain, writes, i, k); });
  const double triggered = each([&](std::size_t i) { sides.triggered->update_all(writes, i, k); });
  const std::size_t joined_reports = k * commits.joins;
  const double joined = seconds_of([&] {
                          for (std::size_t i = 0; i < joined_reports; i += k) join_and_commit(i, k);
                        }) /
                        static_cast<double>(commits.joins);
  join_and_commit(joined_reports, all - joined_reports);
  require_same_pairs(sides.joined.db(), sides.watched.db());

  const std::string reports = std::to_string(k) + (k == 1 ? " report" : " reports") + " a commit";
  std::printf("%s, %s: a watch takes %.3f ms\n", feed.objects().name.c_str(), reports.c_str(), watched * 1e3);
  const double join_goal = k == 1 ? 300 : k == 100 ? 12 : k == 1000 ? 2.5 : 1;
  print_figure("  join + compare / watch", joined / watched, Bound::at_least, join_goal);
  print_figure("  R*Tree + trigger, which cannot move its clock / watch", triggered / watched);
  if (k >= 10000) print_figure("  watch / R*Tree with base table, without trigger", watched / plain);
}

/// Every object in one commit.
void compare_all_at_once(Sides& sides, Feed& feed, int repetitions) {
  Comparison times;
  for (int i = 0; i < repetitions; ++i) {
    const Writes writes = writes_of(feed.reports_of_all(), feed.objects());
    const double watched = seconds_of([&] { commit_reports(sides.watched, writes, 0, writes.size()); });
    times.add(watched, seconds_of([&] { commit_reports(sides.plain, writes, 0, writes.size()); }));
  }
  std::printf("%s, every object in one commit: a watch takes %.1f ms\n", feed.objects().name.c_str(),
              median(times.ours) * 1e3);
  print_figure("  watch / R*Tree with base table, without trigger", 1 / median(times.ratios), Bound::at_most,
               0.5);
}

}  // namespace

void measure_watched_reports(const Options& options) {
  const bool quick = options.has("--quick");
  Feed feed(make_workload(quick ? "S-10000" : "S-100000"));
  Sides sides(feed.objects());
  compare_commits(sides, feed, {1, quick ? 200U : 2000U, quick ? 3U : 10U});
  compare_commits(sides, feed, {100, quick ? 20U : 100U, quick ? 3U : 10U});
  compare_commits(sides, feed, {1000, quick ? 5U : 20U, quick ? 3U : 10U});
  if (!quick) compare_commits(sides, feed, {10000, 10, 5});
  compare_all_at_once(sides, feed, quick ? 3 : 5);
}

}  // namespace foresee::bench
