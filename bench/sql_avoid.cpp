// Manoeuvres that avoid collision through SQL, beside a join of the same id.
//
//   bench_sql_avoid [--quick] [FILE]
//
//   uniform  one disc of radius 10 for each (100 m)^2, |v| <= 10 per axis, 60 s: 10^3 to 10^5 objects
//   hulls    the same with 10^4 hulls of 8 by 20 for discs, turned to their course
//   round    the same with 400 hulls of 1,000 corners
//   crowd    10^4 discs in one spot
//   FILE     ships: id, t, x, y, vx, vy of a CSV file, those that would come within 200 m of another in 600 s
//
// For each: turn and speed of one object, predictive_join of the same id, and the method without foresee, its
// 361 turned copies joined with the table. Processor time per query, medians; ratios are of the same
// repetition.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>

#include "measure.h"
#include "program.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

struct Scene {
  std::string name;
  double h, within;
  std::vector<std::int64_t> queried;
};

/// Declaration of the ships: columns, their values for a velocity ?4, ?5, and those of a copy turned by k.
struct ShipShape {
  std::string columns, drawn, turned;
};
const ShipShape disc{"r", "10", "r"};
const ShipShape hull{"shape, heading",
                     "'POLYGON((-4 -10, 4 -10, 4 6, 0 10, -4 6, -4 -10))', degrees(atan2(?4, ?5))",
                     "shape, mod(heading + k + 540, 360) - 180"};

/// An ellipse of 8 by 20.
ShipShape round_hull(int corners) {
  std::string text;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * 3.14159265358979 * (i % corners) / corners;
    char corner[64];
    std::snprintf(corner, sizeof corner, "%s%.17g %.17g", i ? ", " : "", 4 * std::cos(angle),
                  10 * std::sin(angle));
    text += corner;
  }
  return {hull.columns, "'POLYGON((" + text + "))', degrees(atan2(?4, ?5))", hull.turned};
}

void make_table(Database& db, const ShipShape& ship_shape) {
  register_foresee(db);
  for (const char* table : {"ships", "turned"})
    db.run(std::string("CREATE VIRTUAL TABLE ") + table + " USING moving_objects(id, t, x, y, vx, vy, " +
           ship_shape.columns + ")");
}

Scene fill_uniform(Database& db, const ShipShape& ship_shape, std::size_t count, double side,
                   const std::string& name) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(0, side), speed(-10, 10);
  db.run("BEGIN");
  Statement insert(db, "INSERT INTO ships VALUES (?1, 0, ?2, ?3, ?4, ?5, " + ship_shape.drawn + ")");
  for (std::size_t i = 0; i < count; ++i) {
    insert.bind(1, static_cast<std::int64_t>(i) + 1);
    for (int place_of = 2; place_of <= 3; ++place_of) insert.bind(place_of, place(random));
    for (int place_of = 4; place_of <= 5; ++place_of) insert.bind(place_of, speed(random));
    insert.step_all();
  }
  db.run("COMMIT");
  Scene scene{name, 60, 0, {}};
  for (std::size_t i = 0; i < 40; ++i) scene.queried.push_back(static_cast<std::int64_t>(i * count / 40) + 1);
  return scene;
}

Scene fill_ships(Database& db, const std::string& path) {
  std::ifstream file(path);
  std::string line, cell;
  std::getline(file, line);  // the header
  db.run("BEGIN");
  Statement insert(db, "INSERT INTO ships VALUES (?1, ?2, ?3, ?4, ?5, ?6, 0)");
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    for (int place = 1; place <= 6 && std::getline(cells, cell, ','); ++place) {
      if (place == 1)
        insert.bind(place, static_cast<std::int64_t>(std::stoll(cell)));
      else
        insert.bind(place, std::stod(cell));
    }
    insert.step_all();
  }
  db.run("COMMIT");
  Scene scene{"ships", 600, 200, {}};
  Statement meets(
      db,
      "SELECT id FROM ships WHERE vx * vx + vy * vy > 0 AND id IN (SELECT a FROM predictive_join(600, "
      "'ships', 200) WHERE dt > 0 UNION SELECT b FROM predictive_join(600, 'ships', 200) WHERE dt > 0)");
  while (meets.step()) scene.queried.push_back(meets.integer(0));
  return scene;
}

/// Seconds per query, with each queried id bound as ?1.
double seconds_a_question(Statement& statement, const Scene& scene, std::int64_t& rows) {
  rows = 0;
  return seconds_of([&] {
           for (const std::int64_t id : scene.queried) {
             statement.bind(1, id);
             rows += statement.step_all();
           }
         }) /
         static_cast<double>(scene.queried.size());
}

/// One object's 361 turned copies, written and joined with the table.
double seconds_of_copies(Database& db, const Scene& scene, const ShipShape& ship_shape, std::int64_t id) {
  Statement write(
      db,
      "WITH RECURSIVE d(k) AS (SELECT -180 UNION ALL SELECT k + 1 FROM d WHERE k < 180) INSERT INTO "
      "turned SELECT k + 181, t, x, y, vx * cos(k * 0.017453292519943295) + vy * sin(k * "
      "0.017453292519943295), vy * cos(k * 0.017453292519943295) - vx * sin(k * "
      "0.017453292519943295), " +
          ship_shape.turned + " FROM ships, d WHERE id = ?1");
  const std::string join = "SELECT a, count(*) FROM predictive_join(" + std::to_string(scene.h) +
                           ", 'turned', " + std::to_string(scene.within) +
                           ", 'ships') WHERE b <> ?1 GROUP BY a";
  Statement statement(db, join);
  return seconds_of([&] {
    db.run("DELETE FROM turned");
    write.bind(1, id);
    write.step_all();
    statement.bind(1, id);
    statement.step_all();
  });
}

void measure(Database& db, const Scene& scene, const ShipShape& ship_shape, int repetitions) {
  const std::string numbers = std::to_string(scene.h) + ", 'ships'", within = std::to_string(scene.within);
  Statement avoid(
      db, "SELECT manoeuvre, clear, k_from, k_to FROM predictive_avoid(" + numbers + ", ?1, " + within + ")");
  Statement all(db, "SELECT * FROM predictive_avoid(" + numbers + ", ?1, " + within + ")");
  Statement join(db, "SELECT a, b, t FROM predictive_join WHERE h = " + std::to_string(scene.h) +
                         " AND tbl = 'ships' AND within = " + within + " AND (a = ?1 OR b = ?1)");
  std::vector<double> ours, joined, whole, ratios, copies;
  std::int64_t rows = 0, pairs = 0, ignored = 0;
  for (int i = 0; i < repetitions; ++i) {
    ours.push_back(seconds_a_question(avoid, scene, rows));
    whole.push_back(seconds_a_question(all, scene, ignored));
    joined.push_back(seconds_a_question(join, scene, pairs));
    ratios.push_back(ours.back() / joined.back());
    copies.push_back(seconds_of_copies(db, scene, ship_shape,
                                       scene.queried[static_cast<std::size_t>(i) % scene.queried.size()]));
  }
  const double queried = static_cast<double>(scene.queried.size());
  std::printf(
      "%-16s turn and speed %8.1f us (all columns %8.1f, %.1f rows), join of the id %7.1f us (%.1f pairs): "
      "%5.1f times; 361 copies %9.1f us: %5.1f times ours\n",
      scene.name.c_str(), median(ours) * 1e6, median(whole) * 1e6, static_cast<double>(rows) / queried,
      median(joined) * 1e6, static_cast<double>(pairs) / queried, median(ratios), median(copies) * 1e6,
      median(copies) / median(ours));
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick");
  const int repetitions = quick ? 3 : 9;
  const auto measure_uniform = [&](const ShipShape& ship_shape, std::size_t count, const std::string& name) {
    Database db(":memory:");
    make_table(db, ship_shape);
    const double side = 100 * std::sqrt(static_cast<double>(count));
    measure(db, fill_uniform(db, ship_shape, count, side, name + " " + std::to_string(count)), ship_shape,
            repetitions);
  };
  for (const std::size_t count : {1000, 10000, 100000}) measure_uniform(disc, count, "uniform");
  measure_uniform(hull, 10000, "hulls");
  measure_uniform(round_hull(1000), 400, "round");
  {
    Database db(":memory:");
    make_table(db, disc);
    Scene crowd = fill_uniform(db, disc, 10000, 100, "crowd 10000");
    crowd.queried.resize(4);
    measure(db, crowd, disc, repetitions);
  }
  for (const std::string& path : options.names({})) {
    Database db(":memory:");
    make_table(db, disc);
    measure(db, fill_ships(db, path), disc, repetitions);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
