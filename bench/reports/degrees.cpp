// Loads in degrees: the same reports into a table in degrees, through geo_to_plane into a plain table, and as metres.
#include <cstdio>

#include "files.h"
#include "measure.h"
#include "reports/modes.h"
#include "scenes.h"
#include "sql.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

constexpr const char* plain =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name TEXT)";
constexpr const char* degrees =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, r, +name TEXT, "
    "origin = '54 8', speed_unit = knots)";
constexpr const char* from_metres = "INSERT INTO ships SELECT * FROM metres";
constexpr const char* from_reports = "INSERT INTO ships SELECT * FROM reports";
constexpr const char* by_hand =
    "INSERT INTO ships SELECT i.id, i.t, p.x, p.y, p.vx, p.vy, i.r, i.name FROM reports i, "
    "geo_to_plane(i.lat, i.lon, i.speed * 1852 / 3600, i.course, 54, 8) p";

/// Two ordinary tables of the same reports, ids in random order, names as ships have them.
void make_reports(Database& db, std::int64_t count) {
  db.run(
      "CREATE TABLE reports(id INTEGER, t REAL, lat REAL, lon REAL, speed REAL, course REAL, r REAL, name "
      "TEXT)");
  Statement insert(db, "INSERT INTO reports VALUES (?1, 1641168600, ?2, ?3, ?4, ?5, 60, 'MV ' || ?1)");
  testing::Random random(36);
  db.run("BEGIN");
  for (std::int64_t i = 0; i < count; ++i) {
    insert.bind(1, static_cast<std::int64_t>(random.next() >> 16));
    insert.bind(2, random.in(52, 56));
    insert.bind(3, random.in(4, 12));
    insert.bind(4, random.in(0, 25));
    insert.bind(5, random.in(0, 360));
    insert.step_all();
  }
  db.run("COMMIT");
  db.run(
      "CREATE TABLE metres AS SELECT i.id, i.t, p.x, p.y, p.vx, p.vy, i.r, i.name FROM reports i, "
      "geo_to_plane(i.lat, i.lon, i.speed * 1852 / 3600, i.course, 54, 8) p");
}

double seconds_of_load(Database& db, const char* create, const char* insert) {
  db.run("DROP TABLE IF EXISTS ships");
  db.run(create);
  return seconds_of([&] { db.run(insert); });
}

/// The rows of a query as a checksum of their bits; the loads must agree on it.
std::int64_t checksum(Database& db) {
  Statement rows(db, "SELECT id, x, y, vx, vy, r FROM ships ORDER BY id");
  std::uint64_t sum = 0;
  while (rows.step())
    for (int column = 0; column < rows.columns(); ++column)
      sum = sum * 31 + static_cast<std::uint64_t>(std::hash<double>()(rows.number(column)));
  return static_cast<std::int64_t>(sum);
}

double seconds_of_query(Database& db, const std::string& sql) {
  Statement query(db, sql);
  return seconds_of([&] { query.step_all(); });
}

}  // namespace

void measure_degrees(const Options& options) {
  const bool quick = options.has("--quick");
  const std::int64_t count = quick ? 50000 : 500000;
  const ScratchFile file("degrees");
  Database db(file.path);
  register_foresee(db);
  db.run("PRAGMA synchronous = OFF");
  make_reports(db, count);
  Comparison metres, hand, read, join;
  const std::string scan = "SELECT * FROM ships",
                    pairs = "SELECT a, b, t FROM predictive_join(60, 'ships', 100)";
  for (int i = 0; i < (quick ? 3 : 5); ++i) {
    const double in_metres = seconds_of_load(db, plain, from_metres);
    const double read_metres = seconds_of_query(db, scan), join_metres = seconds_of_query(db, pairs);
    const double through_function = seconds_of_load(db, plain, by_hand);
    const std::int64_t expected = checksum(db);
    const double in_degrees = seconds_of_load(db, degrees, from_reports);
    if (checksum(db) != expected) throw Error("a table in degrees stores other bits than geo_to_plane gives");
    metres.add(in_degrees, in_metres);
    hand.add(in_degrees, through_function);
    read.add(seconds_of_query(db, scan), read_metres);
    join.add(seconds_of_query(db, pairs), join_metres);
  }
  const auto print = [&](const char* what, const Comparison& times, const char* rival) {
    const double a_row = 1e6 / static_cast<double>(count);
    std::printf("%-28s degrees %6.2f   %-12s %6.2f us per row   %5.2fx\n", what, median(times.ours) * a_row,
                rival, median(times.rivals) * a_row, median(times.ratios));
  };
  print("load into a file", metres, "metres");
  print("load into a file", hand, "geo_to_plane");
  print("SELECT * of all rows", read, "metres");
  print("join, 60 s", join, "metres");
}

}  // namespace foresee::bench
