// Functions on a table on the globe: the same rows as on a plain table filled through geo_to_globe, bit for bit. Ships
// meet across the date line and over the poles.
#include <algorithm>

#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

/// Ships on every side of both poles, of the date line and of an equator.
struct GlobeFunctions : ::testing::Test {
  GlobeFunctions() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, r, origin = globe, "
        "speed_unit = knots);"
        "CREATE VIRTUAL TABLE plain USING moving_objects(id, t, x, y, z, vx, vy, vz, ax, ay, az, r);"
        "CREATE TABLE reports AS WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400), "
        "  places(lat, lon, d, e) AS (VALUES (89.9, 0, 0.15, 180.0), (-89.9, 0, 0.15, 180.0), (10, 179.95, "
        "0.1, 0.1), (10, -179.95, 0.1, 0.1), (0, 5, 0.1, 0.1)) "
        "  SELECT row_number() OVER () AS id, i % 7 * 10.0 AS t, max(-90, min(90, lat + d * (i * 37 % 397 / "
        "198.5 - 1))) AS lat, max(-180, min(180, lon + e * (i * 53 % 391 / 195.5 - 1))) AS lon, i * 7 % 25 "
        "AS speed, i * 11 % 360 AS course, i % 5 * 20.0 AS r FROM n, places;"
        "INSERT INTO ships SELECT * FROM reports;"
        "INSERT INTO plain SELECT id, t, x, y, z, vx, vy, vz, ax, ay, az, r FROM reports, "
        "  geo_to_globe(lat, lon, 0, speed * 1852.0 / 3600, course, 0);");
  }

  /// The rows of a query are the same on both tables; '%' stands for the table. Returns how many they are.
  std::size_t compare(const std::string& query) {
    const auto with = [&](const char* table) {
      std::string text = query;
      for (std::size_t at; (at = text.find('%')) != std::string::npos;) text.replace(at, 1, table);
      return db.rows(text);
    };
    const std::string globe = with("ships"), metres = with("plain");
    EXPECT_EQ(globe, metres) << query;
    return globe.empty() ? 0 : static_cast<std::size_t>(std::count(globe.begin(), globe.end(), '\n')) + 1;
  }

  std::string error(const std::string& call) { return db.error_of("SELECT * FROM " + call); }

  Database db;
};

TEST_F(GlobeFunctions, GiveTheSameRows) {
  EXPECT_EQ(compare("SELECT id, x, y, z, vx, vy, vz FROM predictive_position(300, '%') ORDER BY id"), 2000);
  EXPECT_EQ(compare("SELECT id, t, x, y, z FROM predictive_track(60, 600, 60, '%') ORDER BY id, t"), 20000);
  EXPECT_EQ(compare("SELECT * FROM predictive_sweep(600, '%', 100) ORDER BY id"), 2000);
  const std::size_t pairs = compare("SELECT * FROM predictive_join(600, '%', 200) ORDER BY a, b");
  EXPECT_GT(pairs, 300);
  for (const char* method : {"tree", "grid", "gpcd", "scan"})
    EXPECT_EQ(compare(std::string("SELECT * FROM predictive_join(600, '%', 200) WHERE method = '") + method +
                      "' ORDER BY a, b"),
              pairs);
  EXPECT_GT(compare("SELECT * FROM predictive_join(600, '%', 200, '%') ORDER BY a, b"), pairs);
  EXPECT_GT(compare("SELECT stage, n_before, n_after FROM predictive_explain(600, '%', 200)"), 3);
  EXPECT_GT(compare("SELECT * FROM predictive_window(600, '%', 6340000, 6370000, 500000) ORDER BY id"), 20);
  EXPECT_GT(compare("SELECT * FROM predictive_join(600, '%', 500) WHERE a = 17 ORDER BY b"), 1);
}

TEST_F(GlobeFunctions, GivePlaces) {
  EXPECT_EQ(db.rows("SELECT count(*), sum(abs(p.lat - g.lat) < 1e-9), sum(abs(p.lon - g.lon) < 1e-7), "
                    "sum(abs(p.height - g.height) < 1e-7) FROM predictive_position(300, 'ships') p, "
                    "globe_to_geo(p.x, p.y, p.z) g"),
            "2000|2000|2000|2000");
  EXPECT_EQ(db.rows("SELECT sum(p.lat = s.lat AND p.lon = s.lon) FROM ships s JOIN predictive_position(0, "
                    "'ships') p USING(id) WHERE s.t = 0"),
            db.rows("SELECT count(*) FROM ships WHERE t = 0"));
  EXPECT_EQ(
      db.rows("SELECT count(*), count(lat), max(abs(height)) < 0.001 FROM predictive_track(60, 600, 60, "
              "'ships')"),
      "20000|20000|1");
  EXPECT_EQ(db.rows("SELECT count(height) FROM predictive_position(300, 'plain')"), "0");
  EXPECT_EQ(db.rows("SELECT sum(p.speed = s.speed AND p.course IS s.course) FROM ships s JOIN "
                    "predictive_position(0, 'ships') p USING(id) WHERE s.t = 0"),
            db.rows("SELECT count(*) FROM ships WHERE t = 0"));
  // On its way the speed of a ship stays, but for the error of a path without a jerk.
  EXPECT_EQ(db.rows("SELECT max(abs(k.speed - s.speed)) < 0.001, max(abs(k.climb)) < 0.001 FROM ships s JOIN "
                    "predictive_track(60, 600, 60, 'ships') k USING(id)"),
            "1|1");
}

/// A table in degrees has its z as height, if it has one.
TEST_F(GlobeFunctions, GiveHeightsOfThePlane) {
  db.exec(
      "CREATE VIRTUAL TABLE drones USING moving_objects(id, lat, lon, z, speed, course, vz, origin = '50 8');"
      "INSERT INTO drones VALUES (1, 50, 8, 120.123456789012, 10, 90, -2)");
  EXPECT_EQ(db.rows("SELECT height, speed, course, climb FROM predictive_position(0, 'drones')"),
            "120.123456789012|10.0|90.0|-2.0");
  EXPECT_EQ(db.rows("SELECT height, z, climb FROM predictive_track(10, 10, 1, 'drones')"),
            "100.123456789012|100.123456789012|-2.0");
  EXPECT_EQ(db.rows("SELECT height = z, climb FROM predictive_avoid(600, 'drones', 1, 300, 'turn', 5, 5)"),
            "1|-2.0");
}

TEST_F(GlobeFunctions, FindNearestByAPlace) {
  const std::string metres = db.rows(
      "SELECT n.* FROM geo_to_globe(89.99, 12, 100, 0, 0, 0) p, predictive_nearest(600, 'plain', 20, p.x, "
      "p.y, p.z) n ORDER BY rank");
  EXPECT_EQ(std::count(metres.begin(), metres.end(), '\n'), 19);
  for (const char* method : {"tree", "scan"})
    EXPECT_EQ(db.rows("SELECT * FROM predictive_nearest WHERE h = 600 AND tbl = 'ships' AND k = 20 AND lat = "
                      "89.99 AND lon = 12 AND z = 100 AND method = '" +
                      std::string(method) + "' ORDER BY rank"),
              metres);
  EXPECT_EQ(db.rows("SELECT id FROM predictive_nearest WHERE h = 0 AND tbl = 'ships' AND k = 1 AND lat = 90 "
                    "AND lon = 5"),
            db.rows("SELECT id FROM predictive_nearest WHERE h = 0 AND tbl = 'ships' AND k = 1 AND lat = 90 "
                    "AND lon = -99"));
}

/// Both reach the date line, a pole, after the same time; the plain answer is their closing speed.
TEST_F(GlobeFunctions, MeetAcrossTheDateLineAndThePoles) {
  db.exec("DELETE FROM ships");
  db.exec(
      "INSERT INTO ships VALUES (1, 0, 0, 179.99, 20, 90, 0), (2, 0, 0, -179.99, 20, 270, 0), "
      "(3, 0, 89.99, 45, 20, 0, 0), (4, 0, 89.99, -135, 20, 0, 0), "
      "(5, 0, -89.99, 0, 20, 180, 0), (6, 0, -89.99, 90, 20, 180, 0)");
  EXPECT_EQ(
      db.rows("SELECT a, b, abs(t - (d - 100) / v) < 1e-3, abs(t_cpa - d / v) < 1e-3, d_cpa < 1e-6 FROM "
              "(SELECT *, geo_distance(0, 179.99, 0, 180) AS d, 20 * 1852 / 3600.0 AS v FROM "
              "predictive_join(1000, 'ships', 200)) WHERE a = 1"),
      "1|2|1|1|1");
  EXPECT_EQ(
      db.rows("SELECT a, b, abs(t - (d - 100) / v) < 1e-3, abs(t_cpa - d / v) < 1e-3, d_cpa < 1e-6 FROM "
              "(SELECT *, geo_distance(89.99, 45, 90, 0) AS d, 20 * 1852 / 3600.0 AS v FROM "
              "predictive_join(1000, 'ships', 200)) WHERE a = 3"),
      "3|4|1|1|1");
  // Courses at right angles: at the pole both at once.
  EXPECT_EQ(
      db.rows("SELECT a, b, abs(t_cpa - geo_distance(-89.99, 0, -90, 0) / (20 * 1852 / 3600.0)) < 1e-3, "
              "d_cpa < 1e-6 FROM predictive_join(1000, 'ships', 200) WHERE a = 5"),
      "5|6|1|1");
  EXPECT_EQ(db.rows("SELECT id, round(lat, 3), abs(abs(lon) - 180) < 0.011 FROM predictive_position(216, "
                    "'ships') WHERE id < 3"),
            "1|0.0|1\n2|0.0|1");
  EXPECT_EQ(db.rows("SELECT round(lat, 4), round(lon, 4) FROM predictive_position(2 * "
                    "geo_distance(89.99, 45, 90, 0) / (20 * 1852 / 3600.0), 'ships') WHERE id = 3"),
            "89.99|-135.0");
}

TEST_F(GlobeFunctions, RefuseWhatNeedsAnAxisThatPointsUp) {
  const std::string upright =
      ": within_z is for tables whose z points up, and ships is on the globe; leave it out: within covers "
      "every direction";
  for (const char* function : {"predictive_join", "predictive_explain", "predictive_sweep"})
    EXPECT_EQ(error(std::string(function) + " WHERE h = 60 AND tbl = 'ships' AND within_z = 3"),
              function + upright);
  EXPECT_EQ(error("predictive_avoid WHERE h = 60 AND tbl = 'ships' AND id = 1 AND within_z = 3"),
            "predictive_avoid" + upright);
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE w USING predictive_watch(ships, horizon = 60, within_z = 3)"),
            "w" + upright);
  EXPECT_EQ(error("predictive_window WHERE h = 60 AND tbl = 'ships' AND zone = 'POLYGON((0 0, 1 0, 1 1, 0 "
                  "0))'"),
            "predictive_window: zone is for tables on a plane, ships is on the globe; leave it out, or write "
            "origin = 'LAT LON' in ships");
  for (const char* how : {"turn', -9, 9", "climb', -5, 5", "accelerate', -1, 1"}) {
    const std::string name(how, std::find(how, how + 12, '\''));
    EXPECT_EQ(error("predictive_avoid(60, 'ships', 1, 50, '" + std::string(how) + ")"),
              "predictive_avoid: '" + name +
                  "' is for tables on a plane, ships is on the globe; write 'speed', 'delay' or 'wait'");
  }
}

TEST_F(GlobeFunctions, RefuseOtherFrames) {
  db.exec(
      "CREATE VIRTUAL TABLE buoys USING moving_objects(id, lat, lon, origin = '54 8');"
      "CREATE VIRTUAL TABLE islands USING moving_objects(id, lat, lon, r, origin = globe);"
      "INSERT INTO islands VALUES (1, 90, 0, 500)");
  const std::string plain =
      ": ships has lat, lon, plain has x, y: their coordinates do not match; create plain with lat, lon and "
      "origin = "
      "globe";
  EXPECT_EQ(error("predictive_join(60, 'ships', 5, 'plain')"), "predictive_join" + plain);
  EXPECT_EQ(error("predictive_explain(60, 'plain', 5, 'ships')"), "predictive_explain" + plain);
  EXPECT_EQ(error("predictive_avoid WHERE h = 60 AND tbl = 'ships' AND id = 1 AND also = 'buoys'"),
            "predictive_avoid: ships has origin globe, buoys has '54 8': their coordinates do not match; "
            "create buoys "
            "with origin = globe");
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE w USING predictive_watch(buoys, horizon = 60, other = ships)"),
            "w: buoys has origin '54 8', ships has globe: their coordinates do not match; create ships with "
            "origin = '54 8'");
  EXPECT_EQ(db.rows("SELECT count(*) > 5 FROM predictive_join(600, 'ships', 0, 'islands')"), "1");
}

/// A speed that avoids keeps the ship on the ground: its curvature follows. What is written back is clear.
TEST_F(GlobeFunctions, AvoidBySpeed) {
  db.exec(
      "DELETE FROM ships; INSERT INTO ships VALUES (1, 0, 89.99, 45, 20, 0, 50), (2, 0, 89.99, 135, 20, 0, "
      "50)");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(1000, 'ships', 100)"), "1");
  EXPECT_EQ(db.rows("SELECT DISTINCT manoeuvre FROM predictive_avoid(1000, 'ships', 1, 100)"), "speed");
  const std::string rows = db.rows(
      "SELECT clear, round(lat, 2), round(lon, 2), course, speed <> 20, abs(height) < 1e-6, abs(climb) < "
      "1e-6 "
      "FROM predictive_avoid(1000, 'ships', 1, 100) WHERE clear ORDER BY abs(k) LIMIT 1");
  EXPECT_EQ(rows, "1|89.99|45.0|0.0|1|1|1");
  // The accelerations of the changed motion are those of its speed on the same path.
  EXPECT_EQ(
      db.rows("SELECT count(*) > 1, sum(abs(a.ax - g.ax) < 1e-12 AND abs(a.az - g.az) < 1e-12) = count(*) "
              "FROM predictive_avoid(1000, 'ships', 1, 100) a, geo_to_globe(a.lat, a.lon, 0, a.speed * "
              "1852 / 3600, coalesce(a.course, 0), 0) g"),
      "1|1");
  // Changes inside a clear row are clear by exact contact.
  for (int i = 0; i <= 20; ++i) {
    const std::string k =
        db.rows("SELECT k_from + (k_to - k_from) * " + std::to_string(i) +
                " / 20.0 FROM predictive_avoid(1000, 'ships', 1, 100) WHERE clear ORDER BY k_from LIMIT 1");
    EXPECT_EQ(
        db.rows("SELECT clear FROM predictive_avoid(1000, 'ships', 1, 100, 'speed', " + k + ", " + k + ")"),
        "1")
        << k;
  }
  db.exec(
      "UPDATE ships SET (t, lat, lon, speed, course) = (SELECT t, lat, lon, speed, course FROM "
      "predictive_avoid(1000, 'ships', 1, 101) WHERE clear ORDER BY abs(k) LIMIT 1) WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(1000, 'ships', 100)"), "0");
}

TEST_F(GlobeFunctions, AvoidByDelay) {
  db.exec(
      "DELETE FROM ships; INSERT INTO ships VALUES (1, 10, 0, 179.99, 20, 90, 50), (2, 0, 0.01, 180, 20, "
      "180, "
      "50)");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(1000, 'ships', 100, NULL, 0)"), "1");
  EXPECT_EQ(db.rows("SELECT clear, t > 10, lat, lon, speed, course FROM predictive_avoid(1000, 'ships', 1, "
                    "100, 'delay', 0, 600, 0) WHERE clear LIMIT 1"),
            "1|1|0.0|179.99|20.0|90.0");
}

TEST_F(GlobeFunctions, Watch) {
  db.exec("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 600, within = 200)");
  const char* const pairs = "SELECT a, b, t, d_cpa FROM alerts ORDER BY a, b";
  const auto joined = [&] {
    return db.rows("SELECT a, b, t, d_cpa FROM predictive_join(600, 'ships', 200) ORDER BY a, b");
  };
  EXPECT_EQ(db.rows(pairs), joined());
  db.exec(
      "UPDATE ships SET lat = -lat WHERE id % 3 = 0; DELETE FROM ships WHERE id % 7 = 0; UPDATE ships SET t "
      "= "
      "t + 60, speed = speed + 1, course = (coalesce(course, 0) + 30) % 360 WHERE id % 5 = 0");
  EXPECT_EQ(db.rows(pairs), joined());
  EXPECT_GT(db.rows(pairs).size(), 1000u);
}

/// Tiles in x and y of the globe: each pair in one of them.
TEST_F(GlobeFunctions, Tile) {
  const std::string whole =
      db.rows("SELECT a, b, t FROM predictive_join(600, 'ships', 200, NULL, 60) ORDER BY a, b");
  db.exec("CREATE TABLE pairs(a, b, t)");
  for (const char* tile : {"own_x1 = -6000000", "own_x0 = -6000000 AND own_x1 = 0 AND own_y1 = 0",
                           "own_x0 = -6000000 AND own_x1 = 0 AND own_y0 = 0", "own_x0 = 0"})
    db.exec(
        "INSERT INTO pairs SELECT a, b, t FROM predictive_join WHERE h = 600 AND tbl = 'ships' AND within "
        "= 200 AND now = 60 AND " +
        std::string(tile));
  EXPECT_EQ(db.rows("SELECT a, b, t FROM pairs ORDER BY a, b"), whole);
}

}  // namespace
}  // namespace foresee::testing
