// Tables on the globe: what is written is read back, what is stored are the bits of geo_to_globe, how UPDATE changes
// them, and each refusal.
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

/// 10,000 reports anywhere on the Earth, up to 0.01 degrees from a pole.
void fill_reports(Database& db) {
  db.exec(
      "CREATE TABLE reports(id INTEGER PRIMARY KEY, lat REAL, lon REAL, z REAL, speed REAL, course REAL, vz "
      "REAL)");
  Random random(8);
  db.exec("BEGIN");
  for (int i = 0; i < 10000; ++i) {
    const double lat = i % 4 == 0 ? (i % 8 == 0 ? 90 : -90) * (1 - random.in(1e-4, 0.1)) : random.in(-90, 90);
    db.exec("INSERT INTO reports VALUES (" + std::to_string(random.next() >> 12) + ", " +
            std::to_string(lat) + ", " + std::to_string(random.in(-180, 180)) + ", " +
            std::to_string(random.in(-50, 20000)) + ", " + std::to_string(random.in(0, 600)) + ", " +
            std::to_string(random.in(0, 359.9)) + ", " + std::to_string(random.in(-20, 20)) + ")");
  }
  db.exec("COMMIT");
}

struct Globe : ::testing::Test {
  Globe() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, r, +name TEXT, "
        "origin = globe, speed_unit = knots);"
        "CREATE VIRTUAL TABLE flights USING moving_objects(id, lat, lon, z, speed, course, vz, origin = "
        "globe)");
  }

  std::string error_of_flight(const std::string& values) {
    return db.error_of("INSERT INTO flights VALUES (7, " + values + ")");
  }

  Database db;
};

TEST_F(Globe, ReadsBackWhatWasWritten) {
  db.exec("INSERT INTO ships VALUES (211, 1641168600, 53.99, 7.85, 14, 91, 60, 'Anna')");
  EXPECT_EQ(db.rows("SELECT * FROM ships"), "211|1641168600.0|53.99|7.85|14.0|91.0|60.0|Anna");
  EXPECT_EQ(db.rows("SELECT gx, gy, gz, gvx, gvy, gvz, gax, gay, gaz FROM ships"),
            db.rows("SELECT * FROM geo_to_globe(53.99, 7.85, 0, 14.0 * 1852 / 3600, 91, 0)"));
  EXPECT_EQ(db.rows("SELECT name, frame, origin, speed_unit, objects FROM foresee_tables ORDER BY name"),
            "flights|globe|NULL|mps|0\nships|globe|NULL|knots|1");
}

TEST_F(Globe, StoresTheBitsOfGeoToGlobe) {
  fill_reports(db);
  const struct {
    const char *unit, *to_mps;
  } units[] = {{"mps", ""}, {"knots", " * 1852 / 3600"}, {"kmh", " / 3.6"}};
  for (const auto& [unit, to_mps] : units) {
    db.exec(std::string("CREATE VIRTUAL TABLE g USING moving_objects(id, lat, lon, z, speed, course, vz, "
                        "origin = globe, speed_unit = ") +
            unit + "); INSERT INTO g SELECT * FROM reports");
    EXPECT_EQ(db.rows(std::string("SELECT count(*), sum((gx, gy, gz, gvx, gvy, gvz, gax, gay, gaz) = (p.x, "
                                  "p.y, p.z, p.vx, p.vy, p.vz, p.ax, p.ay, p.az)) FROM reports r JOIN g "
                                  "USING(id), geo_to_globe(r.lat, r.lon, r.z, r.speed") +
                      to_mps + ", r.course, r.vz) p"),
              "10000|10000");
    EXPECT_EQ(db.rows("SELECT sum(abs(g.lat - r.lat) < 1e-9), sum(abs(g.lon - r.lon) < 1e-9), sum(abs(g.z - "
                      "r.z) < 1e-7), sum(abs(g.speed - r.speed) < 1e-9), sum(abs(g.course - r.course) < "
                      "1e-9), sum(abs(g.vz - r.vz) < 1e-9) FROM reports r JOIN g USING(id)"),
              "10000|10000|10000|10000|10000|10000");
    // Few decimals come back as they were.
    EXPECT_EQ(db.rows("SELECT * FROM g WHERE abs(lat) < 80 ORDER BY id LIMIT 100"),
              db.rows("SELECT * FROM reports WHERE abs(lat) < 80 ORDER BY id LIMIT 100"));
    db.exec("DROP TABLE g");
  }
}

TEST_F(Globe, HasPolesAndADateLine) {
  db.exec(
      "INSERT INTO ships VALUES (1, 0, 90, 77, 10, 0, 0, ''), (2, 0, -90, 0, 10, 90, 0, ''), "
      "(3, 0, 10, -180, 10, 270, 0, ''), (4, 0, 10, 180, 0, NULL, 0, '')");
  EXPECT_EQ(db.rows("SELECT lat, lon, speed FROM ships"),
            "90.0|0.0|10.0\n-90.0|0.0|10.0\n10.0|180.0|10.0\n10.0|180.0|0.0");
  EXPECT_EQ(db.rows("SELECT id, course FROM ships WHERE id > 1"), "2|90.0\n3|270.0\n4|NULL");
}

TEST_F(Globe, RisesAtRest) {
  db.exec("INSERT INTO flights VALUES (1, 50, 8, 11000, NULL, NULL, 7), (2, 50, 8, 11000, 0, 90, -3)");
  EXPECT_EQ(db.rows("SELECT * FROM flights"),
            "1|50.0|8.0|11000.0|0.0|NULL|7.0\n2|50.0|8.0|11000.0|0.0|NULL|-3.0");
  EXPECT_EQ(db.rows("SELECT gvx, gvy, gvz, gax FROM flights WHERE id = 1"),
            db.rows("SELECT vx, vy, vz, ax FROM geo_to_globe(50, 8, 11000, 0, 0, 7)"));
  db.exec(
      "CREATE VIRTUAL TABLE buoys USING moving_objects(id, lat, lon, r, until, origin = globe);"
      "INSERT INTO buoys VALUES (1, 10.05, -170.123, 5, NULL)");
  EXPECT_EQ(db.rows("SELECT b.*, gx = p.x, gy = p.y, gz = p.z FROM buoys b, geo_to_globe(10.05, -170.123, 0, "
                    "0, 0, 0) p"),
            "1|10.05|-170.123|5.0|NULL|1|1|1");
  EXPECT_EQ(db.rows("SELECT gvx FROM buoys"), "error: no such column: gvx");
}

TEST_F(Globe, UpdateKeepsWhatItLeavesAlone) {
  fill_reports(db);
  db.exec(
      "INSERT INTO flights SELECT * FROM reports;"
      "CREATE TABLE before AS SELECT *, gx, gy, gz, gvx, gvy, gvz, gax, gay, gaz FROM flights");
  const auto kept = [&] {
    return db.rows(
        "SELECT sum((f.gx, f.gy, f.gz) = (b.gx, b.gy, b.gz)), sum((f.gvx, f.gvy, f.gvz, f.gax, f.gay, f.gaz) "
        "= (b.gvx, b.gvy, b.gvz, b.gax, b.gay, b.gaz)) FROM flights f JOIN before b USING(id)");
  };
  for (const char* set :
       {"lat = lat", "lat = lat, lon = lon, z = z, speed = speed, course = course, vz = vz", "vz = vz",
        "lat = b.lat, lon = b.lon, z = b.z, speed = b.speed, course = b.course, vz = b.vz FROM before b "
        "WHERE "
        "b.id = flights.id"}) {
    db.exec(std::string("UPDATE flights SET ") + set);
    EXPECT_EQ(kept(), "10000|10000") << set;
  }
  db.exec("UPDATE flights SET speed = 100");
  EXPECT_EQ(kept().substr(0, 6), "10000|");
  EXPECT_EQ(db.rows("SELECT sum(f.speed = 100), sum(abs(f.course - b.course) < 1e-9), sum(abs(f.vz - b.vz) < "
                    "1e-9) FROM flights f JOIN before b USING(id)"),
            "10000|10000|10000");
  db.exec("UPDATE flights SET z = 5000");
  EXPECT_EQ(db.rows("SELECT sum(f.z = 5000), sum(f.speed = 100), sum(abs(f.lat - b.lat) < 1e-9), "
                    "sum(abs(f.course - b.course) < 1e-9) FROM flights f JOIN before b USING(id)"),
            "10000|10000|10000|10000");
  db.exec("UPDATE flights SET lat = 10, lon = 20 WHERE abs(lat) < 80");
  EXPECT_EQ(
      db.rows("SELECT count(*) > 1000, sum((f.gx, f.gy, f.gz, f.gvx, f.gax) = (p.x, p.y, p.z, p.vx, p.ax)) = "
              "count(*) FROM flights f JOIN before b USING(id), geo_to_globe(10, 20, 5000, 100, "
              "b.course, b.vz) p WHERE f.lat = 10"),
      "1|1");
  EXPECT_EQ(db.error_of("UPDATE flights SET gax = 1"),
            "flights.gax follows from lat, lon, speed, course; write these");
  db.exec("UPDATE flights SET speed = NULL, course = NULL");
  EXPECT_EQ(db.rows("SELECT sum(speed = 0), sum(course IS NULL) FROM flights"), "10000|10000");
}

/// SQLite updates a row once per match and passes all columns as they were before the first of these.
TEST_F(Globe, UpdateFromSeveralReportsOfOneShip) {
  db.exec(
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 50) "
      "INSERT INTO ships SELECT i, 0, 80, i * 3, 10, 5, 0, '' FROM n;"
      "CREATE TABLE reports AS SELECT id, i, lat + i / 10.0 AS lat, 7.0 + i AS speed FROM ships, (SELECT 1 "
      "AS "
      "i UNION SELECT 2)");
  db.exec(
      "UPDATE ships SET lat = r.lat, speed = r.speed FROM (SELECT * FROM reports ORDER BY i) r WHERE r.id "
      "= ships.id");
  EXPECT_EQ(db.rows("SELECT count(*), sum(lat = 80.2), sum(speed = 9) FROM ships"), "50|50|50");
}

TEST_F(Globe, RefusesWhatNoReportSays) {
  EXPECT_EQ(error_of_flight("91, 8, 0, 1, 1, 0"),
            "flights.lat of row 7 is 91: \"not available\" in AIS; leave the row out");
  EXPECT_EQ(error_of_flight("50, 8, -7e6, 1, 1, 0"),
            "flights.z of row 7 is -7000000: the centre of the Earth is 6.4e6 m down; write metres above the "
            "ellipsoid");
  EXPECT_EQ(error_of_flight("50, 8, NULL, 1, 1, 0"),
            "flights.z of row 7 is NULL: a position is needed; write a finite number");
  EXPECT_EQ(error_of_flight("50, 8, 1e301, 1, 1, 0"),
            "flights.z of row 7 is 1e+301: more than 1e300; write metres, or metres per second");
  EXPECT_EQ(error_of_flight("50, 8, 0, 1e151, 1, 0"),
            "flights.speed of row 7 is 1e+151: more than 1e150 metres per second; write the speed in mps, or "
            "NULL if it is unknown");
  EXPECT_EQ(error_of_flight("50, 8, 0, 5, NULL, 0"),
            "flights.course of row 7 is NULL: a speed of 5 needs a course; write the course, or NULL for the "
            "speed");
  EXPECT_EQ(error_of_flight("50, 8, 0, 5, 1, -1e301"),
            "flights.vz of row 7 is -1e+301: more than 1e300; write metres, or metres per second");
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, lat, lon, gx) VALUES (1, 0, 1, 1, 5)"),
            "ships.gx follows from lat, lon, speed, course; write these");
  EXPECT_EQ(db.rows("SELECT count(*) FROM flights"), "0");
}

/// The largest numbers that are taken can be read.
TEST_F(Globe, ReadsExtremeNumbers) {
  for (const char* values : {"50, 8, 1e300, 1e150, 1, 1e300", "-90, 180, -6.2e6, 1e-300, 1, -1e300",
                             "0, 0, 0, 1e-160, 359.9, 0", "89.99999999, 1e-300, 3.6e7, 1e10, 0, 1e-300"}) {
    EXPECT_EQ(error_of_flight(values), "") << values;
    EXPECT_EQ(db.rows("SELECT count(lat), count(lon), count(z), count(speed), count(vz) FROM flights"),
              "1|1|1|1|1")
        << values;
    db.exec("UPDATE flights SET z = z; UPDATE flights SET z = z + 1; DELETE FROM flights");
  }
}

TEST(GlobeFile, IsReadAgainAndNamesItsFeature) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, lat, lon, speed, course, r, origin = globe);"
        "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 80) "
        "INSERT INTO ships SELECT i, i, 2 * i, 5, i, 3 FROM n");
    EXPECT_EQ(db.rows("SELECT key, value FROM ships_meta WHERE key IN ('columns', 'features', 'origin')"),
              "columns|id, lat, lon, speed, course, r\nfeatures|blocks,globe\norigin|globe");
  }
  Database db(file.path());
  EXPECT_EQ(db.rows("SELECT sum(lat = id), sum(lon = 2 * id), sum(course = id) FROM ships"), "80|80|80");
  db.exec(
      "INSERT INTO ships(ships) VALUES ('integrity-check'), ('rebuild'), ('integrity-check'); "
      "ALTER TABLE ships RENAME TO fleet");
  EXPECT_EQ(db.rows("SELECT sum(lat = id) FROM fleet"), "80");
  db.exec("UPDATE fleet_meta SET value = '54 8' WHERE key = 'origin'");
  EXPECT_EQ(Database(file.path()).rows("SELECT * FROM fleet"),
            "error: fleet: stored with the origin '54 8' but declared with 'globe'");
}

}  // namespace
}  // namespace foresee::testing
