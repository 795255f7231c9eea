// UPDATE of tables in degrees: which stored bits change, and what a value that is left out becomes.
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct DegreesUpdate : ::testing::Test {
  DegreesUpdate() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, z, speed, course, vz, r, +name "
        "TEXT, "
        "origin = '53.9 7.9', speed_unit = knots)");
    Random random(5);
    db.exec("BEGIN");
    for (int i = 1; i <= 500; ++i)
      db.exec("INSERT INTO ships VALUES (" + std::to_string(i) + ", 0, " + std::to_string(random.in(50, 58)) +
              ", " + std::to_string(random.in(0, 16)) + ", 0, " +
              (i % 5 == 0 ? "0, NULL"
                          : std::to_string(random.in(0, 30)) + ", " + std::to_string(random.in(0, 359.9))) +
              ", 0, 10, 'ship')");
    db.exec("COMMIT; CREATE TABLE before AS SELECT *, x, y, vx, vy FROM ships");
  }

  /// How many rows have the place, and how many the motion, that they had before; bit for bit.
  std::string unchanged() {
    return db.rows(
        "SELECT sum(s.x = b.x AND s.y = b.y), sum(s.vx = b.vx AND s.vy = b.vy) FROM ships s JOIN before b "
        "USING(id)");
  }

  Database db;
};

TEST_F(DegreesUpdate, OfOtherColumnsChangesNoStoredBit) {
  db.exec("UPDATE ships SET r = 20, z = 3, vz = 1, t = 5, name = 'other'");
  EXPECT_EQ(unchanged(), "500|500");
  EXPECT_EQ(
      db.rows("SELECT count(*) FROM ships WHERE r = 20 AND z = 3 AND vz = 1 AND t = 5 AND name = 'other'"),
      "500");
  db.exec("UPDATE ships SET id = id + 1000; UPDATE ships SET id = id - 1000");
  EXPECT_EQ(unchanged(), "500|500");
}

TEST_F(DegreesUpdate, ByWhatTheColumnsShowChangesNoStoredBit) {
  for (const char* set :
       {"lat = lat", "lat = lat, lon = lon, speed = speed, course = course", "course = course",
        "speed = speed, r = 5",
        "lat = b.lat, lon = b.lon, speed = b.speed, course = b.course, r = b.r FROM before b WHERE b.id = "
        "ships.id",
        "(lat, lon, speed, course) = (SELECT lat, lon, speed, course FROM before b WHERE b.id = ships.id)"}) {
    db.exec(std::string("UPDATE ships SET ") + set);
    EXPECT_EQ(unchanged(), "500|500") << set;
  }
}

TEST_F(DegreesUpdate, OfThePlaceKeepsSpeedAndCourse) {
  db.exec("UPDATE ships SET lat = 54, lon = 8 WHERE id % 2 = 0; UPDATE ships SET lat = 54 WHERE id % 2 = 1");
  EXPECT_EQ(
      db.rows("SELECT sum(s.speed = b.speed AND s.course IS b.course AND s.lat = 54), sum(s.lon = b.lon) "
              "FROM ships s JOIN before b USING(id)"),
      "500|250");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships s JOIN before b USING(id), geo_to_plane(54, s.lon, "
                    "b.speed * 1852 / 3600, coalesce(b.course, 0), 53.9, 7.9) p "
                    "WHERE s.x = p.x AND s.y = p.y AND s.vx = p.vx AND s.vy = p.vy"),
            "500");
}

TEST_F(DegreesUpdate, OfTheMotionKeepsThePlace) {
  db.exec("UPDATE ships SET course = 123.5 WHERE speed > 1");
  EXPECT_EQ(db.rows("SELECT sum(s.x = b.x AND s.y = b.y), sum(s.speed = b.speed), sum(s.course = 123.5) "
                    "FROM ships s JOIN before b USING(id) WHERE b.speed > 1"),
            db.rows("SELECT count(*), count(*), count(*) FROM before WHERE speed > 1"));
  db.exec("UPDATE ships SET speed = 9, course = 0");
  EXPECT_EQ(db.rows("SELECT sum(s.x = b.x AND s.y = b.y), sum(s.speed = 9), sum(s.course = 0) FROM ships s "
                    "JOIN before b "
                    "USING(id)"),
            "500|500|500");
  db.exec("UPDATE ships SET speed = NULL");
  EXPECT_EQ(db.rows("SELECT sum(speed = 0), sum(course IS NULL), sum(vx = 0 AND vy = 0) FROM ships"),
            "500|500|500");
}

TEST_F(DegreesUpdate, ThatGivesASpeedAloneNeedsACourse) {
  EXPECT_EQ(
      db.error_of("UPDATE ships SET speed = 3 WHERE id = 5"),
      "ships.course of row 5 is NULL: a speed of 3 needs a course; write the course, or NULL for the speed");
  EXPECT_EQ(db.error_of("UPDATE ships SET course = NULL WHERE id = 1").substr(0, 30),
            "ships.course of row 1 is NULL:");
  EXPECT_EQ(db.error_of("UPDATE ships SET lat = 91 WHERE id = 5"),
            "ships.lat of row 5 is 91: \"not available\" in AIS; leave the row out");
  EXPECT_EQ(unchanged(), "500|500");
  db.exec("UPDATE ships SET speed = 3, course = 4 WHERE id = 5");
  EXPECT_EQ(db.rows("SELECT speed, course FROM ships WHERE id = 5"), "3.0|4.0");
}

TEST_F(DegreesUpdate, ReplacesAndIgnores) {
  db.exec("INSERT OR REPLACE INTO ships SELECT id, t, lat, lon, z, speed, course, vz, r, 'new' FROM before");
  EXPECT_EQ(db.rows("SELECT sum(abs(s.x - b.x) < 1e-5 AND abs(s.vx - b.vx) < 1e-9), sum(s.name = 'new') "
                    "FROM ships s JOIN before b USING(id)"),
            "500|500");
  db.exec("REPLACE INTO ships(id, t, lat, lon, z, r) VALUES (1, 0, 54, 8, 0, 1)");
  EXPECT_EQ(db.rows("SELECT lat, lon, speed, course, name FROM ships WHERE id = 1"),
            "54.0|8.0|0.0|NULL|NULL");
  db.exec("UPDATE OR REPLACE ships SET id = 2, lat = 55 WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT count(*), max(lat) FILTER (WHERE id = 2) FROM ships"), "499|55.0");
  db.exec("UPDATE OR IGNORE ships SET lat = 95 - id");
  EXPECT_EQ(
      db.error_of("INSERT INTO ships(id, t, lat, lon, r) VALUES (2, 0, 54, 8, 1) ON CONFLICT DO NOTHING"),
      "UPSERT not implemented for virtual table \"ships\"");
}

/// SQLite updates a row once per match and passes all columns as they were before the first of these.
TEST_F(DegreesUpdate, FromSeveralReportsOfOneShip) {
  db.exec(
      "CREATE TABLE reports AS SELECT id, 1 AS i, lat + 0.1 AS lat, lon, 7.0 AS speed, 20.0 AS course FROM "
      "ships;"
      "INSERT INTO reports SELECT id, 2, lat + 0.2, lon, 8.0, 30.0 FROM ships;"
      "INSERT INTO reports SELECT id, 3, lat + 0.3, lon, 9.0, 40.0 FROM ships");
  const std::string from = " FROM (SELECT * FROM reports ORDER BY i) r WHERE r.id = ships.id";
  db.exec("UPDATE ships SET lat = r.lat, lon = r.lon, speed = r.speed, course = r.course" + from);
  EXPECT_EQ(
      db.rows(
          "SELECT sum(abs(s.lat - b.lat - 0.3) < 1e-9), sum(s.lon = b.lon), sum(s.speed = 9 AND s.course = "
          "40) FROM ships s JOIN before b USING(id)"),
      "500|500|500");
  db.exec("UPDATE ships SET lat = r.lat - 0.3" + from);
  EXPECT_EQ(
      db.rows("SELECT sum(abs(s.lat - b.lat) < 1e-9), sum(abs(s.lon - b.lon) < 1e-9), sum(abs(s.speed - 9) < "
              "1e-9) FROM ships s JOIN before b USING(id)"),
      "500|500|500");
  for (const char* set :
       {"x = r.i", "lat = r.lat, x = iif(r.i = 1, x, 5)", "lat = r.lat, vy = iif(r.i = 2, NULL, vy)"})
    EXPECT_EQ(db.error_of(std::string("UPDATE ships SET ") + set + from).substr(6),
              std::string(set).find("vy") == std::string::npos
                  ? "x follows from lat, lon, speed, course; write these"
                  : "vy follows from lat, lon, speed, course; write these");
  EXPECT_EQ(db.rows("SELECT sum(abs(s.lat - b.lat) < 1e-9) FROM ships s JOIN before b USING(id)"), "500");
}

/// A scan that writes the rows which it reads: each is read as it was.
TEST_F(DegreesUpdate, DuringAScan) {
  db.exec("UPDATE ships SET lat = lat + 0.1, course = iif(course IS NULL, NULL, 10)");
  EXPECT_EQ(db.rows("SELECT sum(abs(s.lat - b.lat - 0.1) < 1e-9), sum(s.course = 10), sum(s.speed = b.speed) "
                    "FROM ships s JOIN before b USING(id)"),
            "500|400|500");
  db.exec("UPDATE ships SET lon = s.lat / 10 FROM ships s WHERE s.id = ships.id + 1");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships a JOIN ships b ON b.id = a.id + 1 WHERE abs(a.lon - b.lat / "
                    "10) < 1e-9"),
            "499");
}

}  // namespace
}  // namespace foresee::testing
