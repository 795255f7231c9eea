// Real ships: one second of their reports per commit, and the clock alone.
#include <cmath>
#include <cstdlib>
#include <span>

#include "files.h"
#include "measure.h"
#include "sql_ours.h"
#include "watches/compared_join.h"
#include "watches/modes.h"

namespace foresee::bench {
namespace {

struct ShipReport {
  std::int64_t id;
  double t, x, y, vx, vy;
};

/// In a plane: metres east and north of 30 N 90 W, as if a degree of longitude were everywhere 96 km. Empty
/// where there is no such file.
std::vector<ShipReport> reports_of(const std::string& path) {
  std::vector<ShipReport> reports;
  FILE* lines = popen(("gzip -dc '" + path + "' 2>/dev/null").c_str(), "r");
  if (!lines) return reports;
  char line[400];
  while (std::fgets(line, sizeof line, lines)) {
    long id, t;
    double latitude, longitude, knots, course;
    if (std::sscanf(line, "%ld,%ld,%lf,%lf,%lf,%lf", &id, &t, &latitude, &longitude, &knots, &course) != 6)
      continue;
    const double speed = (knots < 102.2 ? knots : 0) * 1852 / 3600, angle = course * 0.017453292519943295;
    reports.push_back({id, static_cast<double>(t), (longitude + 90) * 96000, (latitude - 30) * 111200,
                       speed * std::sin(angle), speed * std::cos(angle)});
  }
  pclose(lines);
  std::stable_sort(reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  return reports;
}

class Ships {
 public:
  explicit Ships(const std::string& name) : file_(name), db_(file_.path) {
    db_.run("PRAGMA synchronous = OFF");
    register_foresee(db_);
    db_.run("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy)");
    put_ = std::make_unique<Statement>(db_, "INSERT OR REPLACE INTO ships VALUES(?, ?, ?, ?, ?, ?)");
  }

  Database& db() { return db_; }

  /// Within a transaction.
  void put(const ShipReport& report) {
    put_->bind(1, report.id);
    const double values[] = {report.t, report.x, report.y, report.vx, report.vy};
    for (int i = 0; i < 5; ++i) put_->bind(2 + i, values[i]);
    put_->step();
  }

 private:
  ScratchFile file_;
  Database db_;
  std::unique_ptr<Statement> put_;
};

constexpr const char* watch_of_ships =
    "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 600, within = 926)";
constexpr const char* join_of_ships = "predictive_join(600, 'ships', 926)";

void commit(Ships& ships, std::span<const ShipReport> reports, ComparedJoin* compared = nullptr) {
  ships.db().run("BEGIN");
  for (const ShipReport& report : reports) ships.put(report);
  if (compared) compared->update();
  ships.db().run("COMMIT");
}

/// Reports of each second, as they follow one another.
std::vector<std::span<const ShipReport>> seconds_in(std::span<const ShipReport> reports) {
  std::vector<std::span<const ShipReport>> seconds;
  for (std::size_t begin = 0; begin < reports.size();) {
    std::size_t end = begin;
    while (end < reports.size() && reports[end].t == reports[begin].t) ++end;
    seconds.push_back(reports.subspan(begin, end - begin));
    begin = end;
  }
  return seconds;
}

/// Counts rows of pairs as they are written, by temporary triggers.
class PairWrites {
 public:
  explicit PairWrites(Database& db) : db_(db) {
    db.run("CREATE TEMP TABLE pair_writes(n); INSERT INTO pair_writes VALUES (0)");
    for (const std::string event : {"INSERT", "UPDATE", "DELETE"})
      db.run("CREATE TEMP TRIGGER count_" + event + " AFTER " + event +
             " ON main.alerts_pair BEGIN UPDATE pair_writes SET n = n + 1; END");
  }
  double count() {
    Statement read(db_, "SELECT n FROM pair_writes");
    read.step();
    return read.number(0);
  }

 private:
  Database& db_;
};

void compare_ticks(const std::vector<ShipReport>& reports, double from, double ticks) {
  const auto at = [&](double t) {
    return static_cast<std::size_t>(
        std::lower_bound(reports.begin(), reports.end(), t, [](const auto& r, double t) { return r.t < t; }) -
        reports.begin());
  };
  const std::span<const ShipReport> all(reports), before = all.first(at(from)),
                                                  timed = all.subspan(at(from), at(from + ticks) - at(from));
  Ships watched("watched"), joined("joined"), counted("counted");
  commit(joined, before);
  for (Ships* ships : {&watched, &counted}) {
    ships->db().run(watch_of_ships);
    for (const auto second : seconds_in(before)) commit(*ships, second);
  }
  ComparedJoin compared(joined.db(), join_of_ships);
  PairWrites writes(counted.db());
  double ours = 0, theirs = 0;
  const auto seconds = seconds_in(timed);
  for (const auto second : seconds) {
    ours += seconds_of([&] { commit(watched, second); });
    theirs += seconds_of([&] { commit(joined, second, &compared); });
    commit(counted, second);
  }
  require_same_pairs(joined.db(), watched.db());
  std::printf("ships, a commit a second, %.0f reports: a watch takes %.2f ms\n",
              static_cast<double>(timed.size()) / static_cast<double>(seconds.size()),
              ours * 1e3 / static_cast<double>(seconds.size()));
  print_figure("  join + compare / watch", theirs / ours, Bound::at_least, 20);
  print_figure("  rows of pairs written a report", writes.count() / static_cast<double>(timed.size()),
               Bound::at_most, 1.3);
}

/// A table with a row on each page, for commits that write some pages and compute nothing.
class OtherRows {
 public:
  explicit OtherRows(Database& db) : db_(db) {
    db.run("CREATE TABLE other(id INTEGER PRIMARY KEY, time, data)");
    db.run(
        "WITH RECURSIVE n(i) AS (VALUES (1) UNION ALL SELECT i + 1 FROM n WHERE i < 10000) "
        "INSERT INTO other SELECT i, 0.5, zeroblob(3000) FROM n");
    write_ =
        std::make_unique<Statement>(db, "UPDATE other SET time = ?1 WHERE id BETWEEN ?2 AND ?2 + ?3 - 1");
  }

  /// Seconds of a commit that writes so many pages: besides those of the rows, the first page of the file.
  double commit(int pages, double time) {
    write_->bind(1, time);
    write_->bind(2, first_);
    write_->bind(3, std::int64_t{pages - 1});
    first_ = 1 + (first_ + pages) % 5000;
    db_.pages_written();
    const double seconds = seconds_of([&] { write_->step(); });
    if (db_.pages_written() != pages) throw Error("a commit of other rows wrote another number of pages");
    return seconds;
  }

 private:
  Database& db_;
  std::unique_ptr<Statement> write_;
  std::int64_t first_ = 1;
};

void compare_clocks(const std::vector<ShipReport>& reports, int ticks) {
  Ships ships("clock");
  commit(ships, reports);
  ships.db().run(watch_of_ships);
  Statement advance(ships.db(), "INSERT INTO alerts(alerts, now) VALUES('advance', ?)");
  Statement join(ships.db(), std::string("SELECT a, b, t FROM ") + join_of_ships + " WHERE now = ?");
  OtherRows other(ships.db());
  double ours = 0, theirs = 0, commits = 0;
  int pages = 0;
  for (int tick = 1; tick <= ticks; ++tick) {
    const double now = reports.back().t + tick;
    advance.bind(1, now);
    ships.db().pages_written();
    ours += seconds_of([&] { advance.step(); });
    const int written = ships.db().pages_written();
    commits += other.commit(written, now);
    pages += written;
    if (tick % 10 > 0) continue;
    join.bind(1, now);
    theirs += 10 * seconds_of([&] { join.step_all(); });
  }
  ships.db().run("INSERT INTO alerts(alerts) VALUES('integrity-check')");
  std::printf("ships, the clock alone, a tick a second: 'advance' takes %.3f ms and writes %.1f pages\n",
              ours * 1e3 / ticks, static_cast<double>(pages) / ticks);
  print_figure("  join / 'advance'", theirs / ours);
  print_figure("  ms beyond a commit of as many pages of other rows", (ours - commits) * 1e3 / ticks,
               Bound::at_most, 0.25);
}

}  // namespace

void measure_watched_ships(const Options& options) {
  const char* named = std::getenv("FORESEE_SHARED_DATA");
  const std::string folder = named ? named : "../shared/data";
  const std::vector<ShipReport> reports = reports_of(folder + "/ships_us_20220103.csv.gz");
  if (reports.empty()) {
    std::printf("ships: skipped, no ships_us_20220103.csv.gz in %s\n", folder.c_str());
    return;
  }
  const bool quick = options.has("--quick");
  compare_ticks(reports, reports.front().t + (quick ? 10 : 600), quick ? 10 : 120);
  compare_clocks(reports, quick ? 60 : 600);
}

}  // namespace foresee::bench
