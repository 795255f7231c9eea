// Plans in tables in degrees: longitude and latitude per knot, projected as the columns lat, lon are.
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct PlanDegrees : ::testing::Test {
  PlanDegrees() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, plan, r, until, "
        "origin = '54 8', speed_unit = knots)");
  }
  std::string error_of(const std::string& plan) {
    return db.error_of("INSERT INTO ships(id, plan) VALUES (7, " + plan + ")");
  }
  Database db;
};

TEST_F(PlanDegrees, KnotsAreTheBitsOfLatAndLon) {
  db.exec(
      "INSERT INTO ships(id, plan) VALUES (7, 'LINESTRING M(7.85 53.99 0, 7.95 54.01 600, 7.95 54.01 inf)');"
      "INSERT INTO ships(id, t, lat, lon) VALUES (8, 0, 53.99, 7.85), (9, 600, 54.01, 7.95)");
  EXPECT_EQ(db.rows("SELECT plan, t, lat, lon FROM ships WHERE id = 7"),
            "LINESTRING M(7.85 53.99 0, 7.95 54.01 600, 7.95 54.01 inf)|0.0|53.99|7.85");
  EXPECT_EQ(
      db.rows("SELECT a.x = b.x AND a.y = b.y, abs(a.vx - (c.x - b.x) / 600) < 1e-9, a.speed > 0, "
              "round(a.course) FROM ships a, ships b, ships c WHERE a.id = 7 AND b.id = 8 AND c.id = 9"),
      "1|1|1|71.0");
}

TEST_F(PlanDegrees, ReadBackWithinABillionthOfADegree) {
  Random random(11);
  for (int id = 1; id <= 40; ++id) {
    std::string knots;
    for (int i = 0; i < 30; ++i)
      knots += (i ? ", " : "") + std::to_string(random.in(0, 16)) + std::to_string(i) + ' ' +
               std::to_string(random.in(50, 58)) + std::to_string(i * 7) + ' ' + std::to_string(i * 60);
    db.exec("CREATE TABLE IF NOT EXISTS written(id, plan); INSERT INTO written VALUES (" +
            std::to_string(id) + ", 'LINESTRING M(" + knots +
            ")'); INSERT INTO ships(id, plan) SELECT id, plan FROM written "
            "WHERE id = " +
            std::to_string(id));
  }
  EXPECT_EQ(db.rows("SELECT count(*), max(abs(a.x - b.x)) < 1e-9, max(abs(a.y - b.y)) < 1e-9, sum(a.t = b.t) "
                    "FROM ships s JOIN written w USING(id), plan_rows(s.plan) a, plan_rows(w.plan) b WHERE "
                    "a.leg = b.leg"),
            "1160|1|1|1160");
  // What it reads back as, it is written back as: copies, and UPDATE FROM, which keeps the stored bits.
  db.exec("INSERT INTO ships SELECT id + 100, t, lat, lon, speed, course, plan, r, until FROM ships");
  EXPECT_EQ(db.rows("SELECT max(abs(a.x - b.x)) < 1e-8, max(abs(a.y - b.y)) < 1e-8 FROM ships a JOIN ships b "
                    "ON b.id = a.id + 100"),
            "1|1");
  db.exec("CREATE TABLE before AS SELECT id, plan, x, y, vx, vy FROM ships");
  db.exec("UPDATE ships SET r = 5 FROM before b WHERE b.id = ships.id");
  db.exec("UPDATE ships SET r = 6; UPDATE ships SET id = id + 1000; UPDATE ships SET id = id - 1000");
  EXPECT_EQ(db.rows("SELECT count(*), sum(a.plan = b.plan AND a.x = b.x AND a.y = b.y AND a.vx = b.vx) FROM "
                    "ships a JOIN before b USING(id)"),
            "80|80");
  db.exec("INSERT INTO ships(ships) VALUES ('integrity-check')");
}

TEST_F(PlanDegrees, TheFirstKnotChoosesTheOrigin) {
  db.exec("CREATE VIRTUAL TABLE here USING moving_objects(id, lat, lon, plan)");
  db.exec("INSERT INTO here(id, plan) VALUES (1, 'SRID=4326;LINESTRING M(7.87 53.96 0, 8 54 60)')");
  EXPECT_EQ(db.rows("SELECT origin FROM foresee_tables WHERE name = 'here'"), "54 7.9");
  EXPECT_EQ(db.rows("SELECT * FROM here"), "1|53.96|7.87|LINESTRING M(7.87 53.96 0, 8 54 60)");
  EXPECT_EQ(db.error_of("UPDATE here SET plan = NULL"),
            "here.plan of row 1 is NULL: without its plan the object needs a position; set lat, lon too, or "
            "DELETE the row");
  EXPECT_NE(db.error_of("UPDATE here SET plan = q FROM (SELECT NULL AS q)"), "");
  EXPECT_NE(db.error_of("UPDATE here SET plan = NULL, lat = lat"), "");
  db.exec("UPDATE here SET plan = NULL, lat = lat, lon = lon");
  EXPECT_EQ(db.rows("SELECT lat, lon, plan FROM here"), "53.96|7.87|NULL");
}

TEST_F(PlanDegrees, PointsMayHaveGaps) {
  db.exec(
      "INSERT INTO ships(id, plan) SELECT 9, plan_points(column1, column2, column3) FROM (VALUES (0, 8, 54), "
      "(60, 8.01, 54), (61, NULL, NULL), (600, 8.1, 54), (660, 8.2, 54.25))");
  EXPECT_EQ(db.rows("SELECT plan FROM ships WHERE id = 9"),
            "MULTILINESTRING M((8 54 0, 8.01 54 60), (8.1 54 600, 8.2 54.25 660))");
}

TEST_F(PlanDegrees, Errors) {
  const std::string of = "ships.plan of row 7: ";
  EXPECT_EQ(error_of("'LINESTRING M(8 54 0, 54 98 9)'"),
            of + "knot 2 has latitude 98, beyond 90: write longitude, then latitude");
  EXPECT_EQ(error_of("'LINESTRING M(190 54 0, 8 54 9)'"),
            of + "knot 1 has longitude 190, beyond 180: write -170");
  EXPECT_EQ(error_of("'LINESTRING M(8 54 0, 54 8 9)'").substr(0, of.size() + 11), of + "knot 2 is 6");
  EXPECT_EQ(error_of("'SRID=25832;LINESTRING M(8 54 0, 8 55 9)'").substr(0, of.size() + 14),
            of + "at character 6");
  EXPECT_EQ(error_of("(SELECT plan_uniform(0, 9, 8, 54, 1, 1))"),
            of + "a blob of legs with velocities: with lat, lon a plan has knots; write plan_points(t, lon, "
                 "lat)");
  const std::string plan = "'LINESTRING M(8 54 0, 8 55 9)'";
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, lat, plan) VALUES (7, 55, " + plan + ")"),
            "ships.lat of row 7 is 55: its plan starts with lat = 54; leave lat out, or set plan to NULL");
  EXPECT_EQ(
      db.error_of("INSERT INTO ships(id, course, plan) VALUES (7, 90, " + plan + ")"),
      "ships.course of row 7 is 90: its plan starts with course = 0; leave course out, or set plan to NULL");
  db.exec("INSERT INTO ships(id, plan) VALUES (7, " + plan + ")");
  EXPECT_EQ(db.error_of("UPDATE ships SET lon = 9"),
            "ships.lon of row 7 is 9: its plan starts with lon = 8; leave lon out, or set plan to NULL");
  EXPECT_EQ(db.error_of("UPDATE ships SET x = 9"),
            "ships.x follows from lat, lon, speed, course; write these");
  db.exec("UPDATE ships SET lat = lat, lon = 9, speed = 3, course = 90, plan = NULL");
  EXPECT_EQ(db.rows("SELECT lat, lon, speed, course, plan FROM ships"), "54.0|9.0|3.0|90.0|NULL");
}

}  // namespace
}  // namespace foresee::testing
