// Tables in degrees: what is written is read back, what is stored are the bits of geo_to_plane, and each refusal.
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* create_knots =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, r, +name TEXT, "
    "origin = '53.9 7.9', speed_unit = knots)";
constexpr const char* anna = "INSERT INTO ships VALUES (211, 1641168600, 53.99, 7.85, 14, 91, 60, 'Anna')";

struct Degrees : ::testing::Test {
  Degrees() { db.exec(create_knots); }

  std::string stored(int id = 211) {
    return db.rows("SELECT x, y, vx, vy FROM ships WHERE id = " + std::to_string(id));
  }
  std::string error_of_row(const std::string& lat, const std::string& lon, const std::string& speed,
                           const std::string& course) {
    return db.error_of("INSERT INTO ships VALUES (7, 0, " + lat + ", " + lon + ", " + speed + ", " + course +
                       ", 1, 'x')");
  }

  Database db;
};

TEST_F(Degrees, ReadBackWhatWasWritten) {
  db.exec(anna);
  EXPECT_EQ(db.rows("SELECT * FROM ships"), "211|1641168600.0|53.99|7.85|14.0|91.0|60.0|Anna");
  EXPECT_EQ(stored(), db.rows("SELECT * FROM geo_to_plane(53.99, 7.85, 14.0 * 1852 / 3600, 91, 53.9, 7.9)"));
}

/// Places up to 1,400 km from the origin, all units, with all the layouts that a table in degrees has.
TEST_F(Degrees, StoreTheBitsOfGeoToPlane) {
  const struct {
    const char *unit, *to_mps;
  } units[] = {{"mps", ""}, {"knots", " * 1852 / 3600"}, {"kmh", " / 3.6"}};
  db.exec("CREATE TABLE reports(id INTEGER PRIMARY KEY, lat REAL, lon REAL, speed REAL, course REAL)");
  Random random(4);
  db.exec("BEGIN");
  for (int i = 0; i < 10000; ++i)
    db.exec("INSERT INTO reports VALUES (" + std::to_string(random.next() >> 12) + ", " +
            std::to_string(random.in(45, 63)) + ", " + std::to_string(random.in(-7, 22)) + ", " +
            std::to_string(random.in(0, 40)) + ", " + std::to_string(random.in(0, 360)) + ")");
  db.exec("COMMIT");
  for (const auto& [unit, to_mps] : units) {
    db.exec(std::string(
                "CREATE VIRTUAL TABLE g USING moving_objects(id, lat, lon, speed, course, origin = '54 8', "
                "speed_unit = ") +
            unit + ")");
    db.exec("INSERT INTO g SELECT * FROM reports");
    const std::string plane =
        std::string("geo_to_plane(r.lat, r.lon, r.speed") + to_mps + ", r.course, 54, 8)";
    EXPECT_EQ(
        db.rows(
            "SELECT count(*), sum(g.x = p.x AND g.y = p.y AND g.vx = p.vx AND g.vy = p.vy) FROM reports r "
            "JOIN g USING(id), " +
            plane + " p"),
        "10000|10000");
    EXPECT_EQ(db.rows("SELECT sum(abs(g.lat - r.lat) < 1e-9), sum(abs(g.lon - r.lon) < 1e-9), "
                      "sum(abs(g.speed - r.speed) < 1e-9), sum(abs(g.course - r.course) < 1e-9), "
                      "sum(g.course >= 0 AND g.course < 360) FROM reports r JOIN g USING(id)"),
              "10000|10000|10000|10000|10000");
    EXPECT_EQ(db.rows("SELECT * FROM g ORDER BY id LIMIT 3"),
              db.rows("SELECT * FROM reports ORDER BY id LIMIT 3"));
    db.exec("DROP TABLE g");
  }
}

TEST_F(Degrees, JoinAsThePlainTableOfGeoToPlane) {
  db.exec(
      "CREATE VIRTUAL TABLE plain USING moving_objects(id, t, x, y, vx, vy, r);"
      "CREATE TABLE reports(id, t, lat, lon, speed REAL, course, r);"
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 3000)"
      "INSERT INTO reports SELECT i, 0, 53.6 + i * 37 % 997 / 1700.0, 7.4 + i * 53 % 991 / 1000.0, i * 7 % "
      "25, "
      "  i * 11 % 360, 50 FROM n;"
      "INSERT INTO ships SELECT *, '' FROM reports;"
      "INSERT INTO plain SELECT s.id, s.t, p.x, p.y, p.vx, p.vy, s.r FROM reports s, "
      "  geo_to_plane(s.lat, s.lon, s.speed * 1852 / 3600, s.course, 53.9, 7.9) p");
  const auto pairs = [&](const std::string& table) {
    return db.rows("SELECT a, b, t, t_end, t_cpa, d_cpa FROM predictive_join(600, '" + table +
                   "', 100) ORDER BY a, b");
  };
  EXPECT_GT(pairs("ships").size(), 10000u);
  EXPECT_TRUE(pairs("ships") == pairs("plain"));
  EXPECT_EQ(
      db.rows(
          "SELECT count(*) FROM ships s JOIN plain p USING(id) WHERE s.x = p.x AND s.y = p.y AND s.vx = p.vx "
          "AND s.vy = p.vy"),
      "3000");
}

TEST_F(Degrees, HaveHeightsAndRestWithoutSpeed) {
  db.exec(
      "CREATE VIRTUAL TABLE drones USING moving_objects(id, lat, lon, z, speed, course, vz, until, origin = "
      "'50 8');"
      "INSERT INTO drones VALUES (1, 50, 8, 120, 10, 90, -2, NULL), (2, 50, 8, 120, 0, 5, NULL, 9)");
  EXPECT_EQ(db.rows("SELECT *, x, y, vx, vy FROM drones"),
            "1|50.0|8.0|120.0|10.0|90.0|-2.0|NULL|0.0|0.0|10.0|0.0\n"
            "2|50.0|8.0|120.0|0.0|NULL|0.0|9.0|0.0|0.0|0.0|0.0");
  db.exec(
      "CREATE VIRTUAL TABLE buoys USING moving_objects(id, lat, lon); INSERT INTO buoys VALUES (1, 10.05, "
      "-170.123)");
  EXPECT_EQ(db.rows("SELECT *, round(x, 3), round(y, 3) FROM buoys"), "1|10.05|-170.123|-2521.319|-5530.325");
  EXPECT_EQ(db.rows("SELECT vx FROM buoys"), "error: no such column: vx");
}

TEST_F(Degrees, TakeUnknownSpeedsAndCourses) {
  EXPECT_EQ(error_of_row("54", "8", "NULL", "NULL"), "");
  EXPECT_EQ(db.rows("SELECT speed, course, vx, vy FROM ships"), "0.0|NULL|0.0|0.0");
  for (const char* motion :
       {"NULL, 90", "'', ''", "0.5, NULL", "0.5, 360", "102.3, 90", "102.3, 360", "0, 90", "0, NULL"}) {
    db.exec(std::string("INSERT OR REPLACE INTO ships VALUES (7, 0, 54, 8, ") + motion + ", 1, 'x')");
    EXPECT_EQ(db.rows("SELECT speed, course, vx, vy FROM ships"), "0.0|NULL|0.0|0.0") << motion;
  }
  db.exec(
      "INSERT OR REPLACE INTO ships VALUES (7, 0, '54', 8, '10', '0', 1, 'x'), (8, 0, 54, 8, 0.2, 359.5, 1, "
      "'')");
  EXPECT_EQ(db.rows("SELECT lat, speed, course FROM ships"), "54.0|10.0|0.0\n54.0|0.2|359.5");
  db.exec(
      "CREATE VIRTUAL TABLE fast USING moving_objects(id, lat, lon, speed, course);"
      "INSERT INTO fast VALUES (1, 54, 8, 102.3, 90), (2, 54, 8, 0.257, NULL)");
  EXPECT_EQ(db.rows("SELECT speed FROM fast"), "102.3\n0.0") << "102.3 is a speed in metres per second";
}

TEST_F(Degrees, RefuseWhatNoReportSays) {
  const std::string row = " of row 7 is ";
  EXPECT_EQ(error_of_row("91", "8", "1", "1"),
            "ships.lat" + row + "91: \"not available\" in AIS; leave the row out");
  EXPECT_EQ(error_of_row("54", "181", "1", "1"),
            "ships.lon" + row + "181: \"not available\" in AIS; leave the row out");
  EXPECT_EQ(error_of_row("-90.5", "8", "1", "1"),
            "ships.lat" + row +
                "-90.5: a latitude is within 90 degrees; write degrees north of the equator, -90 to 90");
  EXPECT_EQ(error_of_row("54", "-180.001", "1", "1"),
            "ships.lon" + row +
                "-180.001: a longitude is within 180 degrees; write degrees east of Greenwich, -180 to 180");
  EXPECT_EQ(error_of_row("NULL", "8", "1", "1"),
            "ships.lat" + row + "NULL: a position is needed; write a finite number");
  EXPECT_EQ(error_of_row("54", "'east'", "1", "1"),
            "ships.lon" + row + "'east': not a number; write a finite number");
  EXPECT_EQ(error_of_row("54", "8", "-1", "1"),
            "ships.speed" + row + "-1: a speed is never negative; write 0 or more, and the course");
  EXPECT_EQ(error_of_row("54", "8", "1", "361"),
            "ships.course" + row +
                "361: a course is at least 0 and below 360; write degrees clockwise from north, or NULL if "
                "it is unknown");
  EXPECT_EQ(error_of_row("54", "8", "1", "-1"), "ships.course" + row +
                                                    "-1: a course is at least 0 and below 360; write degrees "
                                                    "clockwise from north, or NULL if it is unknown");
  EXPECT_EQ(error_of_row("54", "8", "1", "1e999"),
            "ships.course" + row + "inf: not a finite number; write a finite one");
  for (const char* course : {"NULL", "''"})
    EXPECT_EQ(error_of_row("54", "8", "0.6", course),
              "ships.course" + row +
                  "NULL: a speed of 0.6 needs a course; write the course, or NULL for the speed");
  for (const char* course : {"360", "'360'"})
    EXPECT_EQ(error_of_row("54", "8", "0.6", course),
              "ships.course" + row +
                  "360: unknown, as in AIS, and a speed of 0.6 needs a course; write the course, or NULL for "
                  "the speed; 0 is north");
  EXPECT_EQ(error_of_row("40", "8", "1", "1"),
            "ships: lat, lon of row 7 are 40, 8: 1546 km from the origin '53.9 7.9', the limit is 1500; "
            "create a table with a nearer origin, or with origin = globe");
  const char* opposite =
      "20004 km from the origin '53.9 7.9', the limit is 1500; create a table with a nearer origin, or with "
      "origin = globe";
  for (const char* speed : {"1", "0", "NULL"})
    EXPECT_EQ(error_of_row("-53.9", "-172.1", speed, "1"),
              std::string("ships: lat, lon of row 7 are -53.9, -172.1: ") + opposite);
  EXPECT_EQ(error_of_row("54", "8", "1.7e308", "90"),
            "ships.speed" + row +
                "1.7e+308: more than 1e300 metres per second; write the speed in knots, or NULL if it is "
                "unknown");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
  EXPECT_EQ(db.code_of("INSERT INTO ships VALUES (7, 0, 91, 8, 1, 1, 1, 'x')"), SQLITE_CONSTRAINT);
  db.exec("INSERT OR IGNORE INTO ships VALUES (7, 0, 91, 8, 1, 1, 1, 'x'), (8, 0, 54, 8, 1, 1, 1, 'x')");
  EXPECT_EQ(db.rows("SELECT id FROM ships"), "8");
}

/// The plane stretches velocities: nearer to the limit of doubles one could be stored, and make every scan fail.
TEST_F(Degrees, ReadEverySpeedThatTheyStore) {
  for (const char* unit : {"mps", "knots", "kmh"}) {
    db.exec(std::string("CREATE VIRTUAL TABLE fast USING moving_objects(id, lat, lon, speed, course, "
                        "origin = '54 8', speed_unit = ") +
            unit + ")");
    for (const char* speed : {"1e300", "1e301", "9e307", "1.7976931348623157e308", "1e-320", "5e-324"})
      db.code_of(std::string("INSERT INTO fast VALUES (NULL, 66, 12, ") + speed + ", 45)");
    EXPECT_EQ(db.rows("SELECT sum(speed < 9e307), max(speed) > 9e299 FROM fast"),
              db.rows("SELECT count(*), 1 FROM fast"))
        << unit;
    EXPECT_NE(db.error_of("INSERT INTO fast VALUES (9, 54, 8, 1.7976931348623157e308, 90)"), "") << unit;
    db.exec("DROP TABLE fast");
  }
}

TEST_F(Degrees, ReachThePolesAndTheDateLine) {
  db.exec(
      "CREATE VIRTUAL TABLE polar USING moving_objects(id, lat, lon, speed, course, origin = '90 0');"
      "INSERT INTO polar VALUES (1, 85, 170, 10, 180), (2, 85, -170, 10, 0), (3, 90, 12, 10, 90)");
  EXPECT_EQ(db.rows("SELECT id, lat, lon, speed, course FROM polar WHERE id < 3"),
            "1|85.0|170.0|10.0|180.0\n2|85.0|-170.0|10.0|0.0");
  EXPECT_EQ(db.rows("SELECT lat, speed, x * x + y * y < 1e-12, round(vx * vx + vy * vy, 6) FROM (SELECT *, "
                    "x, y, vx, vy FROM "
                    "polar) WHERE id = 3"),
            "90.0|10.0|1|100.0");
  db.exec(
      "CREATE VIRTUAL TABLE pacific USING moving_objects(id, lat, lon, speed, course, origin = '-17 179.9');"
      "INSERT INTO pacific VALUES (1, -17, 179.95, 10, 90), (2, -17, -179.95, 10, 270), (3, -17, 180, 1, 1), "
      "(4, -17, -180, 1, 1)");
  EXPECT_EQ(db.rows("SELECT id, lon, course FROM pacific"),
            "1|179.95|90.0\n2|-179.95|270.0\n3|180.0|1.0\n4|180.0|1.0");
  EXPECT_EQ(db.rows("SELECT a, b, t > 500 FROM predictive_join(1000, 'pacific', 100) WHERE a = 1 AND b = 2"),
            "1|2|1");
}

TEST_F(Degrees, ShowThePlaneInColumnsThatCannotBeWritten) {
  db.exec(anna);
  for (const char* column : {"x", "y", "vx", "vy"}) {
    const std::string name = column;
    const std::string error = "ships." + name + " follows from lat, lon, speed, course; write these";
    EXPECT_EQ(db.error_of("UPDATE ships SET " + name + " = 1"), error);
    EXPECT_EQ(db.error_of("UPDATE ships SET " + name + " = NULL"), error);
    EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, lat, lon, r, " + name + ") VALUES (7, 0, 54, 8, 1, 5)"),
              error);
    db.exec("UPDATE ships SET " + name + " = " + name);
  }
  db.exec("UPDATE ships SET r = y");
  EXPECT_EQ(db.rows("SELECT r = y FROM ships"), "1");
}

TEST_F(Degrees, CopyAndReturnRows) {
  db.exec(anna);
  db.exec(
      "CREATE VIRTUAL TABLE copy USING moving_objects(id, t, lat, lon, speed, course, r, +name TEXT, "
      "origin = '53.9 7.9', speed_unit = knots); INSERT INTO copy SELECT * FROM ships");
  EXPECT_EQ(db.rows("SELECT *, x, y, vx, vy FROM copy"), db.rows("SELECT *, x, y, vx, vy FROM ships"));
  EXPECT_EQ(
      db.rows("INSERT INTO ships VALUES (8, 0, 54, 8, 1, 1, 1, 'x') RETURNING id, lat * 1.0, lon * 1.0, "
              "course * 1.0"),
      "8|54.0|8.0|1.0");
  EXPECT_EQ(db.rows("SELECT lat FROM ships WHERE ships MATCH 'foresee-handle'"), "NULL");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check'); INSERT INTO ships(ships) VALUES('rebuild')");
  EXPECT_EQ(db.rows("SELECT lat, lon FROM ships WHERE id = 211"), "53.99|7.85");
}

}  // namespace
}  // namespace foresee::testing
