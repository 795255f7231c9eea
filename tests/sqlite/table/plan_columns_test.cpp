// The column `plan`: what CREATE accepts, values in and out, the columns that follow from the first leg, UPDATE.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

/// Two axes, and the columns t, vx, vy, until, which follow from plans or cut them.
struct Plans : ::testing::Test {
  Plans() {
    db.exec("CREATE VIRTUAL TABLE robots USING moving_objects(id, t, x, y, vx, vy, plan, r, until, +name)");
  }
  std::string row(int id = 7) {
    return db.rows("SELECT t, x, y, vx, vy, plan, r, until, name FROM robots WHERE id = " +
                   std::to_string(id));
  }
  /// The error of a value of `plan` in row 7.
  std::string error_of(const std::string& plan, const std::string& table = "robots") {
    return db.error_of("INSERT INTO " + table + "(id, plan) VALUES (7, " + plan + ")");
  }
  static constexpr const char* stops = "'LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)'";
  Database db;
};

TEST(PlanDeclaration, Errors) {
  Database db;
  const auto error_of = [&](const std::string& columns) {
    return db.error_of("CREATE VIRTUAL TABLE a USING moving_objects(" + columns + ")");
  };
  EXPECT_EQ(error_of("id, plan"),
            "a: \"plan\": no position is declared; add x (and y, z for two or three axes), as in "
            "moving_objects(id, x, y, vx, vy)");
  EXPECT_EQ(error_of("id, x, y, r, growth, plan"), "a: \"growth\": a plan does not grow; leave one out");
  EXPECT_EQ(error_of("id, x, y, z, r, hz, growth_z, plan"),
            "a: \"growth_z\": a plan does not grow; leave one out");
  EXPECT_EQ(error_of("id, x, fx, m, plan"),
            "a: \"fx\": a plan has accelerations, not forces; declare ax, or leave plan out");
  EXPECT_EQ(error_of("id, x, y, m, plan"),
            "a: \"m\": a plan has accelerations, not forces; declare ax, ay, or leave plan out");
  EXPECT_EQ(error_of("id, x, y, plan INTEGER"), "a: \"plan INTEGER\": plan holds text or blobs; write plan");
  EXPECT_EQ(error_of("id, x, plan, plan"),
            "a: \"plan\": a column named plan is declared already; choose another name");
  EXPECT_EQ(error_of("id, x, mask, plan"),
            "a: \"plan\": category and mask come after the motion columns; move it before mask");
  EXPECT_EQ(error_of("id, x, y, route"),
            "a: \"route\": no such column; did you mean plan? a column of your own is written +route");
  EXPECT_EQ(error_of("id, lat, lon, r, plan, origin = globe"),
            "a: \"plan\": legs are straight, and paths on the globe bend; write origin = 'LAT LON', or leave "
            "plan out");
  EXPECT_EQ(error_of("id, zone, plan, origin = '54 8'"),
            "a: \"plan\": a zone is at rest; leave plan out, or write lat, lon and shape in place of zone");
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE plan USING moving_objects(id, x, plan)"),
            "plan: a table cannot be named like one of its columns (commands go to a column named like the "
            "table); choose another name than plan");
}

TEST(PlanDeclaration, BesideAllOtherColumns) {
  Database db;
  for (const char* columns :
       {"id, x, plan", "id, plan, y, x", "id, x, y, z, plan TEXT, r, hz", "id, x, y, hx, hy, plan BLOB",
        "id, t, x, y, vx, vy, ax, ay, plan, r, until, category, mask, +name",
        "id, x, y, plan, shape, heading, r", "id, x, y, z, plan, shape", "id, lat, lon, plan",
        "id, t, lat, lon, z, speed, course, vz, plan, r, hz, until, origin = '54 8'"}) {
    db.exec(std::string("CREATE VIRTUAL TABLE a USING moving_objects(") + columns + ")");
    db.exec("DROP TABLE a");
  }
}

TEST_F(Plans, ReadBackAsTheyAreWritten) {
  const char* texts[] = {"LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)",
                         "LINESTRING M(0.1 1e-300 -5, 1e+300 0.3 1792531200.25)",
                         "LINESTRING M(1 2 3, 4 5 6, 4 5 inf)",
                         "MULTILINESTRING M((0 0 0, 1 0 1), (5 5 1, 6 6 2), (0 0 9, 0 0 inf))"};
  for (const std::string text : texts) {
    db.exec("INSERT OR REPLACE INTO robots(id, plan) VALUES (7, '" + text + "')");
    EXPECT_EQ(db.rows("SELECT plan FROM robots"), text);
  }
  db.exec(
      "INSERT OR REPLACE INTO robots(id, plan) VALUES (7, '  srid=0; multiLineStringM ( (0 0 0,1 0 1 ) ) ')");
  EXPECT_EQ(db.rows("SELECT plan FROM robots"), "LINESTRING M(0 0 0, 1 0 1)");
}

TEST_F(Plans, BlobsOfKnotsReadBackAsTextAndLegsAsBlobs) {
  db.exec(
      "INSERT INTO robots(id, plan) SELECT 7, plan_points(column1, column2, column3) FROM (VALUES (5, 10, "
      "0), (0, 0, 0.5))");
  EXPECT_EQ(db.rows("SELECT plan FROM robots"), "LINESTRING M(0 0.5 0, 10 0 5)");
  db.exec(
      "INSERT INTO robots(id, plan) VALUES (8, (SELECT plan_uniform(t, until, x, y, vx, vy) FROM "
      "plan_rows('LINESTRING M(0 0 0, 10 0 5, 10 0 9)')))");
  EXPECT_EQ(db.rows("SELECT typeof(plan), t, x, vx FROM robots WHERE id = 8"), "blob|0.0|0.0|2.0");
  EXPECT_EQ(db.rows("SELECT leg, t, until, x, vx FROM plan_rows((SELECT plan FROM robots WHERE id = 8))"),
            "1|0.0|5.0|0.0|2.0\n2|5.0|9.0|10.0|0.0");
  db.exec("INSERT INTO robots(id, plan) SELECT 9, plan FROM robots WHERE id = 8");
  EXPECT_EQ(db.rows("SELECT count(DISTINCT plan) FROM robots WHERE id > 7"), "1");
}

TEST_F(Plans, OfAcceleratedLegs) {
  db.exec("CREATE VIRTUAL TABLE jets USING moving_objects(id, t, x, y, vx, vy, ax, ay, plan)");
  const std::string turn = "plan_turn(0, 0, 0, 0, 200, 3, 30, 120, 1)";
  EXPECT_EQ(error_of(turn), "robots.plan of row 7: a blob of accelerated legs: declare ax, ay");
  db.exec("INSERT INTO jets(id, plan) VALUES (7, " + turn + ")");
  EXPECT_EQ(db.rows("SELECT plan = " + turn + ", vy > 200, ax > 0 FROM jets"), "1|1|1");
  db.exec(std::string("INSERT INTO jets(id, plan) VALUES (8, ") + stops + ")");
  EXPECT_EQ(db.rows("SELECT plan, vx, ax FROM jets WHERE id = 8"),
            "LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)|2.0|0.0");
}

TEST_F(Plans, OnOneAndThreeAxes) {
  db.exec("CREATE VIRTUAL TABLE lifts USING moving_objects(id, x, plan)");
  db.exec("INSERT INTO lifts(id, plan) SELECT 7, plan_points(column1, column2) FROM (VALUES (0, 1), (2, 5))");
  EXPECT_EQ(db.rows("SELECT x, typeof(plan) FROM lifts"), "1.0|blob");
  EXPECT_EQ(error_of(stops, "lifts"),
            "lifts.plan of row 7: 2 axes, and the table has 1: write plan_points(t, x), or declare y");
  db.exec("CREATE VIRTUAL TABLE drones USING moving_objects(id, x, y, z, plan, r)");
  db.exec("INSERT INTO drones(id, plan) VALUES (7, 'LINESTRING ZM(0 0 0 0, 1 2 3 4)')");
  EXPECT_EQ(db.rows("SELECT z, plan FROM drones"), "0.0|LINESTRING ZM(0 0 0 0, 1 2 3 4)");
  EXPECT_EQ(error_of(stops, "drones"),
            "drones.plan of row 7: 2 axes, and the table has 3: write LINESTRING ZM");
  EXPECT_EQ(error_of("'LINESTRING ZM(0 0 0 0, 1 2 3 4)'"),
            "robots.plan of row 7: 3 axes, and the table has 2: write LINESTRING M, or declare z");
}

TEST_F(Plans, ErrorsOfValues) {
  const std::string of = "robots.plan of row 7: ";
  EXPECT_EQ(error_of("'LINESTRING M(0 0, 10 0 5)'"),
            of + "at character 14: expected 3 numbers (x y t), found 2 (knot 1)");
  EXPECT_EQ(
      error_of("'LINESTRING(0 0 0, 10 0 5)'"),
      of + "at character 11: write LINESTRING M: the third number is the time, or LINESTRING ZM: the fourth");
  EXPECT_EQ(error_of("'MULTILINESTRING M((0 0 0, 1 0 2), (1 0 3, 2 0 4, 3 0 5, 4 0 5))'"),
            of + "knot 4 of part 2: t is 5 after 5: times must rise; write MULTILINESTRING M for a jump");
  EXPECT_EQ(error_of("'MULTILINESTRING M((0 0 0, 1 0 5), (2 0 4, 3 0 6))'"),
            of + "part 2 starts at 4, before part 1 ends at 5");
  EXPECT_EQ(error_of("'LINESTRING M(0 0 0)'"), of + "part 1 has one knot: write two, or a plain row");
  EXPECT_EQ(error_of("'LINESTRING M EMPTY'"), of + "at character 14: EMPTY is no plan: write NULL and x, y");
  EXPECT_EQ(
      error_of("'LINESTRING M(0 0 0, 5 0 inf)'"),
      of + "knot 2: t is inf, but its place is not that of knot 1: write the place where the mover stays");
  EXPECT_EQ(error_of("'LINESTRING M(-1e308 0 0, 1e308 0 1)'"),
            of + "leg 1 from -1e+308 to 1e+308: no double holds its velocity");
  EXPECT_EQ(error_of("x''"), of + "an empty blob is no plan");
  EXPECT_EQ(error_of("7"), of + "7 is no plan: write text as in 'LINESTRING M(0 0 0, 4 0 9)', or a blob");
  EXPECT_EQ(error_of("x'706c010200000000000000000000f87f00000000000000000000000000000000'"),
            of + "byte 8: not a finite number");
  EXPECT_EQ(error_of("'POLYGON((0 0, 1 0, 1 1))'"),
            of + "at character 1: expected LINESTRING M or LINESTRING ZM, found 'POLYGON'");
  EXPECT_EQ(error_of("'SRID=4326;LINESTRING M(8 54 0, 8 55 9)'"),
            of + "at character 6: SRID 4326 is in degrees: project to metres first");
  EXPECT_EQ(db.rows("SELECT count(*) FROM robots"), "0");
}

TEST_F(Plans, TooManyLegs) {
  const std::string error = error_of(
      "(WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 1048577) SELECT "
      "plan_points(i, i % 7, 0) "
      "FROM n)");
  EXPECT_EQ(error, "robots.plan of row 7: 1048577 legs; at most 1048576: cut it with plan_cut");
}

TEST_F(Plans, NullAndEmptyTextArePlainRows) {
  db.exec("INSERT INTO robots(id, t, x, y, plan) VALUES (1, 0, 5, 6, NULL), (2, 0, 7, 8, '')");
  EXPECT_EQ(db.rows("SELECT x, plan FROM robots ORDER BY id"), "5.0|NULL\n7.0|NULL");
  EXPECT_EQ(db.error_of("INSERT INTO robots(id, t, y) VALUES (7, 0, 0)"),
            "robots.x of row 7 is NULL: a position or a plan is needed; write one of them");
  EXPECT_EQ(db.error_of("INSERT INTO robots(id, plan) VALUES (7, '')"),
            "robots.t of row 7 is NULL: a declared reference time or a plan is needed; write one of them");
}

TEST_F(Plans, ColumnsOfTheFirstLegFollow) {
  db.exec(std::string("INSERT INTO robots(id, plan, r, name) VALUES (7, ") + stops + ", 0.5, 'A')");
  const std::string expected = "0.0|0.0|0.0|2.0|0.0|LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)|0.5|NULL|A";
  EXPECT_EQ(row(), expected);
  // just those of its first leg: a copied row
  db.exec("INSERT INTO robots SELECT id + 1, t, x, y, vx, vy, plan, r, until, name FROM robots");
  EXPECT_EQ(row(8), expected);
  EXPECT_EQ(db.error_of(std::string("INSERT INTO robots(id, x, plan) VALUES (9, 5, ") + stops + ")"),
            "robots.x of row 9 is 5: its plan starts with x = 0; leave x out, or set plan to NULL");
  EXPECT_EQ(db.error_of(std::string("INSERT INTO robots(id, vx, plan) VALUES (9, 2.5, ") + stops + ")"),
            "robots.vx of row 9 is 2.5: its plan starts with vx = 2; leave vx out, or set plan to NULL");
  EXPECT_EQ(db.error_of(std::string("INSERT INTO robots(id, t, plan) VALUES (9, 'noon', ") + stops + ")"),
            "robots.t of row 9 is 'noon': not a number; write a finite number");
}

TEST_F(Plans, UpdateOfThePlanAloneBringsThemAlong) {
  db.exec(std::string("INSERT INTO robots(id, plan, r, name) VALUES (7, ") + stops + ", 0.5, 'A')");
  db.exec("UPDATE robots SET plan = 'LINESTRING M(3 4 2, 3 9 7)'");
  EXPECT_EQ(row(), "2.0|3.0|4.0|0.0|1.0|LINESTRING M(3 4 2, 3 9 7)|0.5|NULL|A");
  // to NULL, with a position: the row stays as its columns read
  db.exec("UPDATE robots SET plan = NULL, x = x, y = y");
  EXPECT_EQ(row(), "2.0|3.0|4.0|0.0|1.0|NULL|0.5|NULL|A");
  db.exec("UPDATE robots SET vy = 5");
  EXPECT_EQ(row(), "2.0|3.0|4.0|0.0|5.0|NULL|0.5|NULL|A");
  db.exec(std::string("UPDATE robots SET plan = ") + stops);
  EXPECT_EQ(row(), "0.0|0.0|0.0|2.0|0.0|LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)|0.5|NULL|A");
  db.exec("UPDATE robots SET plan = NULL, x = 44, y = 0, t = 3");
  EXPECT_EQ(row(), "3.0|44.0|0.0|2.0|0.0|NULL|0.5|NULL|A");
}

// As SET plan = (SELECT plan FROM predictive_avoid(…) WHERE clear) where no change is clear.
TEST_F(Plans, NoPlanAndNoPositionIsRefused) {
  db.exec(std::string("INSERT INTO robots(id, plan, r) VALUES (7, ") + stops + ", 1), (8, " + stops + ", 1)");
  const std::string before = db.rows("SELECT * FROM robots");
  for (const char* set : {"plan = NULL", "plan = ''", "plan = (SELECT 1 WHERE 0)",
                          "plan = NULL, vx = 0, r = 2", "plan = NULL, y = 3", "plan = NULL, id = id + 100",
                          "plan = q FROM (SELECT NULL AS q)", "plan = NULL, r = q FROM (SELECT 5 AS q)"})
    EXPECT_EQ(
        db.error_of(std::string("UPDATE robots SET ") + set + " WHERE robots.id = 7"),
        "robots.plan of row 7 is NULL: without its plan the object needs a position; set x, y too, or DELETE "
        "the row")
        << set;
  EXPECT_EQ(db.rows("SELECT * FROM robots"), before);
  db.exec("UPDATE robots SET plan = NULL, x = x, y = 3 WHERE id = 7");
  db.exec("UPDATE robots SET plan = q, x = 3, y = 4 FROM (SELECT NULL AS q) WHERE id = 8");
  db.exec("UPDATE robots SET plan = NULL, r = 2");  // they have no plan any more
  EXPECT_EQ(db.rows("SELECT id, x, y, plan FROM robots ORDER BY id"), "7|0.0|3.0|NULL\n8|3.0|4.0|NULL");
}

TEST_F(Plans, UpdateOfOtherColumnsKeepsThePlan) {
  db.exec(std::string("INSERT INTO robots(id, plan, r, name) VALUES (7, ") + stops + ", 0.5, 'A')");
  db.exec("UPDATE robots SET r = 2, name = 'B', id = 12 WHERE id = 7");
  EXPECT_EQ(row(12), "0.0|0.0|0.0|2.0|0.0|LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)|2.0|NULL|B");
  EXPECT_EQ(db.error_of("UPDATE robots SET x = 5"),
            "robots.x of row 12 is 5: its plan starts with x = 0; leave x out, or set plan to NULL");
  db.exec("UPDATE robots SET x = 0, vx = NULL");  // just that, and NULL
  db.exec("UPDATE robots SET plan = plan, x = x, r = 3");
  EXPECT_EQ(row(12), "0.0|0.0|0.0|2.0|0.0|LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)|3.0|NULL|B");
  db.exec("INSERT INTO robots(robots) VALUES ('integrity-check')");
}

TEST_F(Plans, UntilOnlyCuts) {
  db.exec(std::string("INSERT INTO robots(id, plan, until) VALUES (7, ") + stops + ", 7)");
  const std::string text = "LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)";
  EXPECT_EQ(row(), "0.0|0.0|0.0|2.0|0.0|" + text + "|0.0|7.0|NULL");
  db.exec("UPDATE robots SET until = 400");
  EXPECT_EQ(db.rows("SELECT plan, until FROM robots"), text + "|400.0");
  db.exec("UPDATE robots SET until = 0");
  EXPECT_EQ(db.rows("SELECT plan, until FROM robots"), text + "|0.0");
  db.exec("UPDATE robots SET until = NULL");
  EXPECT_EQ(db.rows("SELECT plan, until FROM robots"), text + "|NULL");
  EXPECT_EQ(db.error_of("UPDATE robots SET until = -1"),
            "robots.until of row 7 is -1: before the reference time 0; write 0 or more, or NULL for no end");
}

TEST_F(Plans, ReplaceAndDelete) {
  db.exec(std::string("INSERT INTO robots(id, plan) VALUES (7, ") + stops + ")");
  db.exec("INSERT OR REPLACE INTO robots(id, plan) VALUES (7, 'LINESTRING M(1 1 1, 2 2 2)')");
  EXPECT_EQ(row(), "1.0|1.0|1.0|1.0|1.0|LINESTRING M(1 1 1, 2 2 2)|0.0|NULL|NULL");
  db.exec("INSERT OR REPLACE INTO robots(id, t, x, y) VALUES (7, 0, 3, 4)");
  EXPECT_EQ(row(), "0.0|3.0|4.0|0.0|0.0|NULL|0.0|NULL|NULL");
  db.exec(std::string("INSERT OR REPLACE INTO robots(id, plan) VALUES (7, ") + stops + ")");
  db.exec("INSERT OR IGNORE INTO robots(id, plan) VALUES (7, 'LINESTRING M(1 1 1, 2 2 2)'), (8, 'prose')");
  EXPECT_EQ(db.rows("SELECT id, x FROM robots"), "7|0.0");
  db.exec("UPDATE OR REPLACE robots SET id = 3");
  EXPECT_EQ(db.rows("SELECT id, plan FROM robots"), "3|LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)");
  db.exec("DELETE FROM robots");
  EXPECT_EQ(db.rows("SELECT count(*) FROM robots_leg"), "0");
  db.exec("INSERT INTO robots(robots) VALUES ('integrity-check')");
}

TEST_F(Plans, UpdateFromPassesAllColumns) {
  db.exec(std::string("INSERT INTO robots(id, plan, r) VALUES (7, ") + stops + ", 1), (8, " + stops + ", 1)");
  db.exec("CREATE TABLE w(robot, plan, r)");
  db.exec("INSERT INTO w VALUES (7, 'LINESTRING M(3 4 2, 3 9 7)', 2), (7, 'LINESTRING M(5 5 2, 6 6 3)', 3)");
  db.exec("UPDATE robots SET plan = w.plan FROM w WHERE w.robot = robots.id");
  EXPECT_EQ(db.rows("SELECT id, x, vx, plan FROM robots WHERE id = 8"),
            "8|0.0|2.0|LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)");
  EXPECT_EQ(db.rows("SELECT x = 3 OR x = 5 FROM robots WHERE id = 7"), "1");
  db.exec("UPDATE robots SET r = w.r FROM w WHERE w.robot + 1 = robots.id");
  EXPECT_EQ(db.rows("SELECT x, vx, plan, r > 1 FROM robots WHERE id = 8"),
            "0.0|2.0|LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)|1");
  db.exec("UPDATE robots SET plan = NULL, x = -1, y = robots.y FROM w WHERE w.robot = robots.id");
  EXPECT_EQ(db.rows("SELECT plan FROM robots WHERE id = 7"), "NULL");
}

TEST_F(Plans, WithoutDeclaredTimeAndVelocity) {
  db.exec("CREATE VIRTUAL TABLE few USING moving_objects(id, x, y, plan)");
  db.exec("INSERT INTO few(id, plan) VALUES (7, 'LINESTRING M(1 2 30, 5 2 34)')");
  db.exec("INSERT INTO few(id, x, y) VALUES (8, 1, 2)");
  EXPECT_EQ(db.rows("SELECT * FROM few ORDER BY id"),
            "7|1.0|2.0|LINESTRING M(1 2 30, 5 2 34)\n8|1.0|2.0|NULL");
  // A row without its plan is what its columns say: at rest.
  db.exec("UPDATE few SET plan = NULL, x = x, y = y WHERE id = 7");
  EXPECT_EQ(db.rows("SELECT * FROM few WHERE id = 7"), "7|1.0|2.0|NULL");
  db.exec("INSERT INTO few(few) VALUES ('integrity-check')");
}

TEST_F(Plans, ShapesNeedAHeading) {
  db.exec("CREATE VIRTUAL TABLE hulls USING moving_objects(id, x, y, plan, shape, heading)");
  const std::string hull = ", 'POLYGON((-1 -1, 1 -1, 0 1, -1 -1))'";
  EXPECT_EQ(db.error_of(std::string("INSERT INTO hulls(id, plan, shape) VALUES (7, ") + stops + hull + ")"),
            "hulls.heading of row 7 is NULL: a row with a plan and a shape needs a heading; write 0 for no "
            "rotation");
  db.exec(std::string("INSERT INTO hulls(id, plan, shape, heading) VALUES (7, ") + stops + hull + ", 90)");
  db.exec(std::string("INSERT INTO hulls(id, plan) VALUES (8, ") + stops + ")");
  db.exec("UPDATE hulls SET plan = 'LINESTRING M(1 1 1, 2 2 2)'");
  EXPECT_EQ(db.rows("SELECT id, x, heading FROM hulls ORDER BY id"), "7|1.0|90.0\n8|1.0|0.0");
}

}  // namespace
}  // namespace foresee::testing
