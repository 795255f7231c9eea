// Watched reports of real ships, in the order of their times, one second of reports per transaction: at every
// minute all nine columns are those of the join. The file is not in the repository: the test reads
// ../shared/data, or the folder in FORESEE_SHARED_DATA. Without it the test is skipped. FORESEE_LONG=1 runs
// all ships instead of one in three, with one transaction per report, in 25 minutes instead of three.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "sanitized.h"
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

struct ShipReport {
  long second;
  std::string values;  ///< (id, t, x, y, vx, vy): metres in a plane that is only roughly the earth
};

/// Of one ship in so many.
std::vector<ShipReport> reports_of(const std::string& path, int one_in) {
  std::vector<ShipReport> reports;
  FILE* lines = popen(("gzip -dc '" + path + "' 2>/dev/null").c_str(), "r");
  char line[400];
  for (bool header = true; std::fgets(line, sizeof line, lines); header = false) {
    long id, t;
    double latitude, longitude, knots, course;
    if (header ||
        std::sscanf(line, "%ld,%ld,%lf,%lf,%lf,%lf", &id, &t, &latitude, &longitude, &knots, &course) != 6 ||
        id % one_in != 0)
      continue;
    if (knots >= 102.2) knots = 0;
    const double speed = knots * 1852 / 3600, radians = course * 0.017453292519943295;
    char values[300];
    std::snprintf(values, sizeof values, "(%ld, %ld, %.17g, %.17g, %.17g, %.17g)", id, t,
                  (longitude + 90) * 96000, (latitude - 29) * 111200, speed * std::sin(radians),
                  speed * std::cos(radians));
    reports.push_back({t, values});
  }
  pclose(lines);
  std::stable_sort(reports.begin(), reports.end(),
                   [](const ShipReport& a, const ShipReport& b) { return a.second < b.second; });
  return reports;
}

TEST(WatchedShips, AreTheJoinAtEveryMinute) {
  const char* named = std::getenv("FORESEE_SHARED_DATA");
  const std::string folder = named ? named : FORESEE_SOURCE_DIR "/../shared/data";
  const bool is_long = std::getenv("FORESEE_LONG") != nullptr;
  const std::vector<ShipReport> reports = reports_of(folder + "/ships_us_20220103.csv.gz", is_long     ? 1
                                                                                           : sanitized ? 20
                                                                                                       : 3);
  if (reports.empty()) GTEST_SKIP() << "no ships_us_20220103.csv.gz in " << folder;
  const long minutes = is_long ? 25 : 3;
  const TemporaryFile file;
  Database db(file.path());
  db.exec(
      "PRAGMA journal_mode = wal; PRAGMA synchronous = OFF;"
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 600, within = 926, ahead = 3600)");
  WatchReader reader;
  const long first = reports.front().second;
  long second = first;
  std::string sql = "BEGIN;";
  for (const ShipReport& report : reports) {
    if (is_long || report.second != second) {
      db.exec(sql + "COMMIT");
      sql = "BEGIN;";
    }
    if (report.second != second && (report.second - first) % 60 == 0) {
      const std::string after = " at second " + std::to_string(report.second - first);
      expect_joined(db, "h = 600 AND within = 926", after);
      if (!HasFailure()) reader.read(db, after);
      if (!HasFailure()) reader.expect_rows(db, after);
      if (HasFailure() || report.second - first >= 60 * minutes) break;
    }
    second = report.second;
    sql += "INSERT OR REPLACE INTO ships VALUES " + report.values + ";";
  }
  expect_up_to_date(db);
  EXPECT_GT(std::stoi(db.rows("SELECT count(*) FROM alerts")), 30);
}

}  // namespace
}  // namespace foresee::testing
