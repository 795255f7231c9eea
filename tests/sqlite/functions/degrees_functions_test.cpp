// Functions on a table in degrees: the same rows as on a plain table filled through geo_to_plane, bit for bit.
#include <algorithm>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct DegreesFunctions : ::testing::Test {
  DegreesFunctions() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, r, origin = '53.9 "
        "7.9', "
        "speed_unit = knots);"
        "CREATE VIRTUAL TABLE plain USING moving_objects(id, t, x, y, vx, vy, r);"
        "CREATE TABLE reports AS WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400) "
        "  SELECT i AS id, i % 7 * 10.0 AS t, 53.8 + i * 37 % 397 / 2000.0 AS lat, 7.7 + i * 53 % 391 / "
        "1000.0 AS lon, "
        "    i * 7 % 25 AS speed, i * 11 % 360 AS course, i % 5 * 20.0 AS r FROM n;"
        "INSERT INTO ships SELECT * FROM reports;"
        "INSERT INTO plain SELECT id, t, x, y, vx, vy, r FROM reports, "
        "  geo_to_plane(lat, lon, speed * 1852.0 / 3600, course, 53.9, 7.9);");
  }

  /// The rows of a query are the same on both tables; '%' stands for the table. Returns how many they are.
  std::size_t compare(const std::string& query) {
    const auto with = [&](const char* table) {
      std::string text = query;
      for (std::size_t at; (at = text.find('%')) != std::string::npos;) text.replace(at, 1, table);
      return db.rows(text);
    };
    const std::string degrees = with("ships"), metres = with("plain");
    EXPECT_EQ(degrees, metres) << query;
    return degrees.empty() ? 0
                           : static_cast<std::size_t>(std::count(degrees.begin(), degrees.end(), '\n')) + 1;
  }

  /// The corners of a zone on the plane, with all digits.
  std::string on_plane(const std::string& corners) {
    return db.rows(
        "SELECT 'POLYGON((' || group_concat(printf('%!.17g %!.17g', x, y), ', ') || '))' FROM (SELECT x, y "
        "FROM json_each('" +
        corners + "') c, geo_to_plane(c.value ->> 1, c.value ->> 0, NULL, NULL, 53.9, 7.9))");
  }

  std::string error(const std::string& call) { return db.error_of("SELECT * FROM " + call); }

  Database db;
};

TEST_F(DegreesFunctions, GiveTheSameRows) {
  EXPECT_EQ(compare("SELECT id, x, y, z, vx, vy, vz FROM predictive_position(300, '%') ORDER BY id"), 400);
  EXPECT_EQ(compare("SELECT id, t, x, y FROM predictive_track(60, 600, 60, '%') ORDER BY id, t"), 4000);
  EXPECT_EQ(compare("SELECT id, x0, x1, y0, y1 FROM predictive_sweep(600, '%', 100) ORDER BY id"), 400);
  EXPECT_GT(compare("SELECT * FROM predictive_join(600, '%', 50) ORDER BY a, b"), 100);
  EXPECT_GT(compare("SELECT stage, n_before, n_after FROM predictive_explain(600, '%', 50)"), 3);
  EXPECT_GT(compare("SELECT * FROM predictive_window(600, '%', -3000, 2000, -5000, 4000) ORDER BY id"), 20);
  EXPECT_GT(
      compare("SELECT manoeuvre, clear, k_from, k_to, k, t, x, y, vx, vy, below, t_below, above, t_above "
              "FROM predictive_avoid(600, '%', 17, 300, 'turn')"),
      1);
}

TEST_F(DegreesFunctions, GivePlaces) {
  EXPECT_EQ(db.rows("SELECT count(*), sum(abs(p.lat - g.lat) < 1e-9 AND abs(p.lon - g.lon) < 1e-9) FROM "
                    "predictive_position(300, 'ships') p, plane_to_geo(p.x, p.y, NULL, NULL, 53.9, 7.9) g"),
            "400|400");
  EXPECT_EQ(
      db.rows("SELECT count(*), sum(abs(p.lat - g.lat) < 1e-9 AND abs(p.lon - g.lon) < 1e-9) FROM "
              "predictive_track(60, 600, 60, 'ships') p, plane_to_geo(p.x, p.y, NULL, NULL, 53.9, 7.9) g"),
      "4000|4000");
  EXPECT_EQ(
      db.rows(
          "SELECT p.lat = s.lat, p.lon = s.lon FROM ships s, predictive_position(0, 'ships') p WHERE p.id = "
          "s.id AND s.id = 7"),
      "1|1");
  EXPECT_EQ(db.rows("SELECT count(*), sum(p.course IS g.course OR abs(p.course - g.course) < 1e-6), "
                    "sum(abs(p.speed - g.speed * 3600 / "
                    "1852) < 1e-6), count(p.climb) FROM predictive_position(300, 'ships') p, "
                    "plane_to_geo(p.x, p.y, p.vx, p.vy, 53.9, 7.9) g"),
            "400|400|400|0");
  EXPECT_EQ(
      db.rows("SELECT p.speed = s.speed, p.course = s.course FROM ships s, predictive_position(0, 'ships') "
              "p WHERE p.id = s.id AND s.id = 7"),
      "1|1");
  EXPECT_EQ(
      db.rows("SELECT count(lat), count(lon), count(speed), count(course) FROM predictive_position(300, "
              "'plain')"),
      "0|0|0|0");
  EXPECT_EQ(db.rows("SELECT count(lat), count(lon) FROM predictive_track(0, 60, 60, 'plain')"), "0|0");
  EXPECT_EQ(db.rows("SELECT count(lat), count(lon), count(speed), count(course), count(*) > 0 FROM "
                    "predictive_avoid(600, 'plain', 17, 300, 'turn')"),
            "0|0|0|0|1");
}

/// After 30,000 hours the point of the plane is beyond the Earth.
TEST_F(DegreesFunctions, GiveNoPlaceBeyondTheEarth) {
  db.exec("DELETE FROM ships WHERE id <> 3");
  EXPECT_EQ(db.rows("SELECT x IS NULL, lat, lon, speed FROM predictive_position(1e9, 'ships')"),
            "0|NULL|NULL|NULL");
}

TEST_F(DegreesFunctions, FindNearestByAPlace) {
  const std::string metres = db.rows(
      "SELECT n.* FROM geo_to_plane(53.91, 7.95, NULL, NULL, 53.9, 7.9) p, predictive_nearest(600, 'plain', "
      "20, p.x, "
      "p.y) n ORDER BY rank");
  EXPECT_EQ(std::count(metres.begin(), metres.end(), '\n'), 19);
  EXPECT_EQ(db.rows("SELECT * FROM predictive_nearest WHERE h = 600 AND tbl = 'ships' AND k = 20 AND lat = "
                    "53.91 AND lon "
                    "= 7.95 ORDER BY rank"),
            metres);
  EXPECT_EQ(db.rows("SELECT * FROM predictive_nearest WHERE h = 600 AND tbl = 'ships' AND k = 20 AND lat = "
                    "53.91 AND lon "
                    "= 7.95 AND method = 'scan' ORDER BY rank"),
            metres);
  // Beside the columns lat and lon of a table.
  EXPECT_EQ(db.rows("SELECT n.id FROM reports p JOIN predictive_nearest n ON n.h = 0 AND n.tbl = 'ships' AND "
                    "n.k = 1 AND "
                    "n.now = p.t AND n.lat = p.lat AND n.lon = p.lon WHERE p.id = 5"),
            "5");
}

TEST_F(DegreesFunctions, RefuseACoordinateOfTheOtherKind) {
  const std::string nearest = "predictive_nearest WHERE h = 0 AND k = 1 AND tbl = ";
  EXPECT_EQ(error("predictive_nearest(0, 'ships', 1, 53.9, 7.9)"),
            "predictive_nearest: ships has lat, lon; write WHERE lat = ... AND lon = ... in place of x");
  EXPECT_EQ(error(nearest + "'ships' AND y = 1 AND lat = 53 AND lon = 7"),
            "predictive_nearest: ships has lat, lon; write WHERE lat = ... AND lon = ... in place of y");
  EXPECT_EQ(
      error(nearest + "'ships'"),
      "predictive_nearest: ships has lat, lon, and lat is missing; write WHERE lat = ... AND lon = ...");
  EXPECT_EQ(
      error(nearest + "'ships' AND lat = 53"),
      "predictive_nearest: ships has lat, lon, and lon is missing; write WHERE lat = ... AND lon = ...");
  EXPECT_EQ(error(nearest + "'ships' AND lat = 91 AND lon = 7"),
            "predictive_nearest: lat is 91, beyond 90; write degrees");
  EXPECT_EQ(error(nearest + "'ships' AND lat = 1 AND lon = 181"),
            "predictive_nearest: lon is 181, beyond 180; write -179");
  EXPECT_EQ(error(nearest + "'ships' AND lat = 7.9 AND lon = 53.9"),
            "predictive_nearest: lat, lon are 6545 km from the origin '53.9 7.9' of ships; write a place "
            "within 1500 km");
  EXPECT_EQ(error(nearest + "'plain' AND lat = 53 AND lon = 7"),
            "predictive_nearest: plain has no lat, lon; write x, y in place of lat");
  EXPECT_EQ(error(nearest + "'plain' AND x = 1 AND lon = 7"),
            "predictive_nearest: plain has no lat, lon; write x, y in place of lon");
}

TEST_F(DegreesFunctions, TakeZonesInDegrees) {
  const std::string corners = "[[7.8,53.85],[8,53.85],[7.95,53.95],[7.8,53.9],[7.8,53.85]]";
  const std::string metres =
      db.rows("SELECT * FROM predictive_window WHERE h = 600 AND tbl = 'plain' AND zone = '" +
              on_plane(corners) + "' ORDER BY id");
  EXPECT_GT(std::count(metres.begin(), metres.end(), '\n'), 20);
  for (const char* method : {"auto", "scan"})
    EXPECT_EQ(
        db.rows(
            std::string("SELECT * FROM predictive_window WHERE h = 600 AND tbl = 'ships' AND method = '") +
            method +
            "' AND zone = 'POLYGON((7.8 53.85, 8 53.85, 7.95 53.95, 7.8 53.9, 7.8 53.85))' ORDER BY id"),
        metres);
}

TEST_F(DegreesFunctions, SayWhatIsWrongWithAZone) {
  const std::string window = "predictive_window WHERE h = 60 AND tbl = 'ships' AND zone = ";
  EXPECT_EQ(error(window + "'POLYGON((53.85 7.8, 53.85 8, 53.95 7.9, 53.85 7.8))'"),
            "predictive_window: zone: corner (53.85 7.8) is 6552 km from the origin '53.9 7.9'; write "
            "longitude first, "
            "and an origin within 1500 km");
  EXPECT_EQ(error(window + "'POLYGON((7 53, 9 54, 9 53, 7 54, 7 53))'"),
            "predictive_window: zone: edges (7 53, 9 54) and (9 53, 7 54) cross");
  EXPECT_EQ(error("predictive_window WHERE h = 60 AND tbl = 'plain' AND zone = 'SRID=4326;POLYGON((7 53, 9 "
                  "54, 9 53, 7 "
                  "53))'"),
            "predictive_window: zone: at character 6: SRID 4326 is in degrees: project to metres first");
}

TEST_F(DegreesFunctions, CompareOneShipAfterAnotherWithAZone) {
  const std::string zone =
      "predictive_window WHERE h = 600 AND tbl = 'ships' AND zone = 'POLYGON((7.8 53.85, 8 53.85, "
      "7.95 53.95, 7.8 53.9, 7.8 53.85))'";
  const std::string rows = db.rows("SELECT * FROM " + zone + " ORDER BY id");
  EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 20);
  EXPECT_EQ(db.rows("SELECT w.* FROM ships s LEFT JOIN (SELECT * FROM " + zone +
                    ") w ON w.id = s.id WHERE w.t >= 0 "
                    "ORDER BY s.id"),
            rows);
  EXPECT_EQ(
      db.rows("SELECT id FROM ships s WHERE EXISTS (SELECT 1 FROM " + zone + " AND id = s.id) ORDER BY id"),
      db.rows("SELECT id FROM " + zone + " ORDER BY id"));
}

TEST_F(DegreesFunctions, KnowNothingAboutAnEmptyTable) {
  db.exec("CREATE VIRTUAL TABLE empty USING moving_objects(id, lat, lon)");
  EXPECT_EQ(db.rows("SELECT * FROM predictive_position(0, 'empty')"), "");
  EXPECT_EQ(
      db.rows(
          "SELECT * FROM predictive_nearest WHERE h = 0 AND tbl = 'empty' AND k = 1 AND lat = 3 AND lon = 4"),
      "");
  EXPECT_EQ(
      db.rows(
          "SELECT * FROM predictive_window WHERE h = 0 AND tbl = 'empty' AND zone = 'POLYGON((7 53, 9 54, 9 "
          "53, 7 53))'"),
      "");
}

/// A recommendation that is written back as a report is clear to a micrometre. The pairs that are left touch at the
/// start and separate, as in the plain table with the exact numbers.
TEST_F(DegreesFunctions, WriteBackRecommendations) {
  const auto recommended = [&](const char* table, const char* columns, const std::string& id,
                               const char* how) {
    return std::string("(") + columns + ") = (SELECT " + columns + " FROM predictive_avoid(600, '" + table +
           "', " + id + ", 300, '" + how + "') WHERE clear ORDER BY abs(k) LIMIT 1) WHERE id = " + id;
  };
  const auto pairs_of = [&](const char* table, const std::string& id) {
    return db.rows(std::string("SELECT a, b FROM predictive_join(600, '") + table +
                   "', 299.999999) WHERE a = " + id + " OR b = " + id + " ORDER BY a, b");
  };
  int changed = 0, apart = 0;
  for (int number = 1; number <= 400; number += 9)
    for (const char* how : {"turn", "speed"}) {
      const std::string id = std::to_string(number);
      if (db.rows("SELECT 1 FROM predictive_avoid(600, 'ships', " + id + ", 300, '" + how +
                  "') WHERE clear LIMIT 1")
              .empty())
        continue;
      const std::string before = pairs_of("ships", id);
      db.exec("SAVEPOINT before");
      db.exec("UPDATE ships SET " + recommended("ships", "t, lat, lon, speed, course", id, how));
      db.exec("UPDATE plain SET " + recommended("plain", "t, x, y, vx, vy", id, how));
      EXPECT_EQ(pairs_of("ships", id), pairs_of("plain", id)) << id << ' ' << how;
      apart += pairs_of("ships", id).empty(), changed += pairs_of("ships", id) != before;
      EXPECT_EQ(db.rows("SELECT abs(s.x - p.x) < 1e-7, abs(s.y - p.y) < 1e-7, abs(s.vx - p.vx) < 1e-9, "
                        "abs(s.vy - p.vy) "
                        "< 1e-9 FROM ships s JOIN plain p USING(id) WHERE id = " +
                        id),
                "1|1|1|1")
          << id << ' ' << how;
      db.exec("ROLLBACK TO before; RELEASE before");
    }
  EXPECT_GT(apart, 20);
  EXPECT_GT(changed, 20);
}

/// A ship that is clear keeps its course: written back, no stored bit changes.
TEST_F(DegreesFunctions, KeepTheStoredBitsThatDoNotChange) {
  const std::string alone =
      "CREATE VIRTUAL TABLE alone USING moving_objects(id, t, lat, lon, speed, course, origin = '53.9 7.9', "
      "speed_unit = "
      "kmh); INSERT INTO alone VALUES (1, 0, 53.912345678, 7.987654321, 23.456, 78.9)";
  db.exec(alone);
  const std::string before = db.rows("SELECT t, x, y, vx, vy, lat, lon, speed, course FROM alone");
  db.exec(
      "UPDATE alone SET (t, lat, lon, speed, course) = (SELECT t, lat, lon, speed, course FROM "
      "predictive_avoid(600, 'alone', 1, 300, 'turn', 0, 0)) WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT t, x, y, vx, vy, lat, lon, speed, course FROM alone"), before);
}

}  // namespace
}  // namespace foresee::testing
