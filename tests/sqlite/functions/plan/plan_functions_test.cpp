// Plans in SQL: aggregates, legs as rows, shifts, cuts and turns; NULL, and every error.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct PlanFunctions : ::testing::Test {
  Database db;

  /// The legs of a plan, with the columns that tests need.
  std::string legs(const std::string& plan, const std::string& columns = "leg, t, until, x, vx") {
    return db.rows("SELECT " + columns + " FROM plan_rows(" + plan + ")");
  }
};

TEST_F(PlanFunctions, RowsOfATextAreItsLegs) {
  EXPECT_EQ(legs("'LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)'",
                 "leg, t, until, x, y, z, vx, vy, vz, ax, ay, az"),
            "1|0.0|5.0|0.0|0.0|NULL|2.0|0.0|NULL|0.0|0.0|NULL\n"
            "2|5.0|9.0|10.0|0.0|NULL|0.0|0.0|NULL|0.0|0.0|NULL\n"
            "3|9.0|29.0|10.0|0.0|NULL|0.0|1.0|NULL|0.0|0.0|NULL");
  EXPECT_EQ(legs("'LINESTRING ZM(0 0 9 0, 0 0 5 2)'", "z, vz"), "9.0|-2.0");
  EXPECT_EQ(legs("'MULTILINESTRING M((0 0 0, 1 0 1), (7 7 3, 7 7 inf))'"),
            "1|0.0|1.0|0.0|1.0\n2|3.0|NULL|7.0|0.0");
}

TEST_F(PlanFunctions, RowsOfNullAreNone) {
  EXPECT_EQ(legs("NULL"), "");
  EXPECT_EQ(legs("''"), "");
  EXPECT_EQ(db.rows("SELECT count(*) FROM plan_rows"), "0");
}

TEST_F(PlanFunctions, RowsReadAColumnNamedPlan) {
  db.exec(
      "CREATE TABLE robots(id, plan); INSERT INTO robots VALUES (1, 'LINESTRING M(0 0 0, 4 0 2)'), (2, "
      "NULL)");
  EXPECT_EQ(db.rows("SELECT id, vx FROM robots, plan_rows(plan) ORDER BY leg"), "1|2.0");
  EXPECT_EQ(db.rows("SELECT id, leg FROM robots LEFT JOIN plan_rows(plan) ORDER BY id, leg"), "1|1\n2|NULL");
}

TEST_F(PlanFunctions, PointsInAnyOrderAreOnePlan) {
  db.exec("CREATE TABLE w(t, x, y); INSERT INTO w VALUES (9, 10, 0), (0, 0, 0), (5, 10, 0)");
  EXPECT_EQ(db.rows("SELECT plan_points(t, x) FROM w WHERE t < 9"),
            "x'706c0101000000000000000000000000000000000000000000000000000014400000000000002440'");
  EXPECT_EQ(db.rows("SELECT (SELECT plan_points(t, x, y) FROM w) = (SELECT plan_points(t, x, y) FROM (SELECT "
                    "* FROM w ORDER BY t))"),
            "1");
  EXPECT_EQ(legs("(SELECT plan_points(t, x, y) FROM w)"), "1|0.0|5.0|0.0|2.0\n2|5.0|9.0|10.0|0.0");
  EXPECT_EQ(legs("(SELECT plan_points(t, x, y) FROM (SELECT * FROM w UNION ALL SELECT * FROM w))"),
            legs("(SELECT plan_points(t, x, y) FROM w)"))
      << "what is delivered twice counts once";
  EXPECT_EQ(legs("(SELECT plan_points(t, x, y, 7) FROM w)", "z, vz"), "7.0|0.0\n7.0|0.0");
  EXPECT_EQ(db.rows("SELECT plan_points(t, x) IS NULL FROM w WHERE 0"), "1");
  EXPECT_EQ(db.rows("SELECT plan_points(t, x) IS NULL FROM (SELECT NULL AS t, NULL AS x)"), "1");
  EXPECT_EQ(legs("(SELECT plan_points(t, x) FROM (SELECT * FROM w UNION ALL SELECT 9e999, 10, 0))"),
            "1|0.0|5.0|0.0|2.0\n2|5.0|9.0|10.0|0.0\n3|9.0|NULL|10.0|0.0");
}

TEST_F(PlanFunctions, APointWithoutAPositionIsAGap) {
  db.exec(
      "CREATE TABLE w(t, x, y); INSERT INTO w VALUES (0, 0, 0), (5, 10, 0), (6, NULL, 0), (7, '', NULL), (9, "
      "10, 0), (10, 11, 0), (11, NULL, NULL)");
  EXPECT_EQ(legs("(SELECT plan_points(t, x, y) FROM w)"), "1|0.0|5.0|0.0|2.0\n2|9.0|10.0|10.0|1.0");
}

TEST_F(PlanFunctions, LegsInAnyOrderAreOnePlan) {
  db.exec(
      "CREATE TABLE l(t, until, x, vx, ax); INSERT INTO l VALUES (5, NULL, 3, 0, 0), (0, NULL, 1, 2, 0), (7, "
      "NULL, 4, 0, 0.5)");
  EXPECT_EQ(legs("(SELECT plan_uniform(t, until, x, vx) FROM l)"),
            "1|0.0|5.0|1.0|2.0\n2|5.0|7.0|3.0|0.0\n3|7.0|NULL|4.0|0.0");
  EXPECT_EQ(legs("(SELECT plan_accelerated(t, until, x, vx, ax) FROM l)", "until, ax"),
            "5.0|0.0\n7.0|0.0\nNULL|0.5");
  EXPECT_EQ(legs("(SELECT plan_uniform(t, t + 1, x, 0, vx, 1) FROM l)", "t, until, y, vy"),
            "0.0|1.0|0.0|1.0\n5.0|6.0|0.0|1.0\n7.0|8.0|0.0|1.0");
  EXPECT_EQ(legs("(SELECT plan_accelerated(t, t + 1, x, 0, 5, vx, 1, 2, ax, 3, 4) FROM l)", "z, vz, az"),
            "5.0|2.0|4.0\n5.0|2.0|4.0\n5.0|2.0|4.0");
  EXPECT_EQ(legs("(SELECT plan_uniform(t, 9e999, x, vx) FROM l WHERE t = 7)"), "1|7.0|NULL|4.0|0.0");
}

TEST_F(PlanFunctions, RowsBecomeThePlanAgain) {
  db.exec("CREATE TABLE p(plan); INSERT INTO p SELECT plan_turn(0, 5, 7, 0, 10, 9, 10, 60, 0.5)");
  EXPECT_EQ(db.rows("SELECT plan = (SELECT plan_accelerated(t, until, x, y, vx, vy, ax, ay) FROM "
                    "plan_rows(plan)) FROM p"),
            "1");
}

TEST_F(PlanFunctions, LegsAsRowsOfATableMeet) {
  db.exec("CREATE VIRTUAL TABLE legs USING moving_objects(id, t, x, y, vx, vy, r, until, +robot INTEGER)");
  db.exec("CREATE TABLE robots(robot INTEGER PRIMARY KEY, plan TEXT)");
  db.exec(
      "INSERT INTO robots VALUES (1, 'LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 19)'), (2, 'LINESTRING M(10 "
      "20 0, 10 2 9, 10 2 inf)')");
  db.exec(
      "INSERT INTO legs(t, x, y, vx, vy, r, until, robot) SELECT t, x, y, vx, vy, 0.5, until, robot FROM "
      "robots, plan_rows(plan)");
  EXPECT_EQ(db.rows("SELECT count(*), count(until) FROM legs"), "5|4");
  EXPECT_EQ(db.rows("SELECT min(j.t) FROM predictive_join(60, 'legs') j, legs a, legs b WHERE j.now = 0 AND "
                    "a.id = j.a AND b.id = j.b AND a.robot < b.robot"),
            "9.5");
}

TEST_F(PlanFunctions, ACutInDegreesKeepsThePathOnThePlane) {
  db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, lat, lon, plan, origin = '54 8')");
  const std::string plan = "'LINESTRING M(7 54 0, 9 54.5 6000, 9.1 54 9000)'";
  db.exec("INSERT INTO ships(id, plan) VALUES (1, " + plan + "), (2, plan_cut(" + plan +
          ", 3000, 7000, (SELECT origin FROM foresee_tables))), (3, plan_cut(" + plan + ", 3000, 7000))");
  const auto aside = [this](int id, int t) {
    const std::string at = "FROM predictive_position(" + std::to_string(t) + ") WHERE id = ";
    return std::stod(db.rows("SELECT geo_distance(a.lat, a.lon, b.lat, b.lon) FROM (SELECT * " + at +
                             "1) AS a, (SELECT * " + at + std::to_string(id) + ") AS b"));
  };
  for (const int t : {3000, 4000, 5999, 6000, 6500, 7000}) EXPECT_LT(aside(2, t), 1e-3) << t;
  EXPECT_GT(aside(3, 3000), 400);
  EXPECT_EQ(db.rows("SELECT plan_cut(" + plan + ", 6000, 9000, '54 8')"),
            "LINESTRING M(9 54.5 6000, 9.1 54 9000)");
  EXPECT_EQ(db.rows("SELECT plan_cut(" + plan + ", 1, 2, NULL) = plan_cut(" + plan + ", 1, 2)"), "1");
  // Across the date line the numbers of a leg run around the Earth; its path does not.
  EXPECT_EQ(db.rows("SELECT plan_cut('SRID=4326;LINESTRING M(179 0 0, -179 0 10)', 5, NULL, '0 180')"),
            "LINESTRING M(180 0 5, -179 0 10)");
  EXPECT_EQ(db.rows("SELECT plan_cut('LINESTRING ZM(8 54 70 0, 8 54 90 10)', 5, NULL, '54 8')"),
            "LINESTRING ZM(8 54 80 5, 8 54 90 10)");
}

TEST_F(PlanFunctions, ShiftAndCutKeepTheForm) {
  EXPECT_EQ(db.rows("SELECT plan_shift('linestring m(0 0 0, 1 0 1)', 60)"), "LINESTRING M(0 0 60, 1 0 61)");
  EXPECT_EQ(db.rows("SELECT typeof(plan_shift(plan_points(t, t), 60)) FROM (SELECT 1 AS t UNION SELECT 2)"),
            "blob");
  EXPECT_EQ(db.rows("SELECT plan_cut('LINESTRING M(0 0 0, 10 0 5, 10 0 9)', 2, 7)"),
            "LINESTRING M(4 0 2, 10 0 5, 10 0 7)");
  EXPECT_EQ(db.rows("SELECT plan_cut('LINESTRING M(0 0 0, 10 0 5)', NULL, 2), plan_cut('LINESTRING M(0 0 0, "
                    "10 0 5)', 2, NULL)"),
            "LINESTRING M(0 0 0, 4 0 2)|LINESTRING M(4 0 2, 10 0 5)");
  EXPECT_EQ(
      db.rows(
          "SELECT plan_cut('LINESTRING M(0 0 0, 10 0 5)', 7, 8), plan_cut(NULL, 7, 8), plan_shift(NULL, 1), "
          "plan_shift('LINESTRING M(0 0 0, 10 0 5)', NULL)"),
      "NULL|NULL|NULL|NULL");
}

TEST_F(PlanFunctions, TurnsBecomeLegs) {
  EXPECT_EQ(legs("plan_turn(0, 0, 0, 0, 52.35987755982989, 3, 30, 120, 1)",
                 "leg, t, until, round(x, 1), round(y, 1), round(vx, 1)"),
            "1|0.0|7.5|0.0|0.0|0.1\n2|7.5|15.0|76.1|382.7|20.4\n3|15.0|22.5|292.9|707.1|37.6\n"
            "4|22.5|30.0|617.3|923.9|49.0\n5|30.0|120.0|1000.0|1000.0|52.4");
  EXPECT_EQ(legs("plan_turn(0, 0, 0, 0, 1, 90, 1, NULL, 0.1)", "until"), "1.0\nNULL");
}

TEST_F(PlanFunctions, AnIntegerMustBeADouble) {
  EXPECT_EQ(db.error_of("SELECT plan_points(9007199254740993, 1)"),
            "plan_points: t must be a number that a double holds exactly, not 9007199254740993");
}

TEST_F(PlanFunctions, SayWhatIsNoPlan) {
  for (const auto& [value, message] :
       {std::pair("7", "7 is no plan: write text as in 'LINESTRING M(0 0 0, 4 0 9)', or a blob"),
        {"x''", "an empty blob is no plan"},
        {"x'706c'", "a blob of 2 bytes that does not start with 'pl' is no plan: write one of plan_points"},
        {"'LINESTRING M(0 0, 1 0 1)'", "at character 14: expected 3 numbers (x y t), found 2 (knot 1)"},
        {"'LINESTRING M(-1e308 0 0, 1e308 0 1)'",
         "leg 1 from -1e+308 to 1e+308: no double holds its velocity"}})
    EXPECT_EQ(db.error_of(std::string("SELECT * FROM plan_rows(") + value + ")"),
              std::string("plan_rows: ") + message);
  EXPECT_EQ(db.error_of("SELECT plan_shift('here', 1)"),
            "plan_shift: at character 1: expected LINESTRING M or LINESTRING ZM, found 'here'");
  EXPECT_EQ(db.error_of("SELECT plan_cut(1.5, 1, 2)"),
            "plan_cut: 1.5 is no plan: write text as in 'LINESTRING M(0 0 0, 4 0 9)', or a blob");
}

TEST_F(PlanFunctions, SayWhichNumberIsWrong) {
  const char* plan = "'LINESTRING M(0 0 0, 1 0 1)'";
  const auto error = [&](const std::string& call) { return db.error_of("SELECT " + call); };
  EXPECT_EQ(error(std::string("plan_shift(") + plan + ", 'soon')"),
            "plan_shift: seconds must be a number, not 'soon'");
  EXPECT_EQ(error(std::string("plan_shift(") + plan + ", 9e999)"),
            "plan_shift: seconds is infinite: write a finite number");
  EXPECT_EQ(error(std::string("plan_cut(") + plan + ", 0, 4, 54)"),
            "plan_cut: origin is 54: write latitude and longitude, as in '53.9 7.9', or NULL for metres");
  EXPECT_EQ(error("plan_cut((SELECT plan_points(value, 7) FROM json_each('[1, 2]')), 1, 2, '54 8')"),
            "plan_cut: 1 axis, and the table has 2: write LINESTRING M");
  EXPECT_EQ(error("plan_cut('LINESTRING M(8 54 0, 4 95 9)', 1, 4, '54 8')"),
            "plan_cut: knot 2 has latitude 95, beyond 90: write longitude, then latitude");
  EXPECT_EQ(error(std::string("plan_cut(") + plan + ", 5, 4)"),
            "plan_cut: from is 5, later than to, which is 4: exchange them");
  EXPECT_EQ(error("plan_turn(0, 0, 0, 0, NULL, 3, 30, 120, 1)"), "plan_turn: vy is NULL: write a number");
  EXPECT_EQ(error("plan_turn(0, 0, 0, 0, 9e999, 3, 30, 120, 1)"),
            "plan_turn: vy is infinite: write a finite number");
  EXPECT_EQ(error("plan_turn(0, 0, 0, 0, 1, 3, 30, 120, 0)"),
            "plan_turn: error is 0: write a distance greater than 0");
  EXPECT_EQ(error("plan_turn(0, 0, 0, 0, 1, 3, -30, 120, 1)"),
            "plan_turn: duration is -30: write a number greater than 0");
  EXPECT_EQ(error("plan_points('noon', 1)"), "plan_points: t must be a number, not 'noon'");
  EXPECT_EQ(error("plan_points(NULL, 1)"),
            "plan_points: t is NULL in a row with other values: write a time, or leave the row out");
  EXPECT_EQ(error("plan_points(1, 9e999)"), "plan_points: at t = 1: x is infinite: write a finite number");
  EXPECT_EQ(error("plan_points(1, 2, 'east')"), "plan_points: at t = 1: y must be a number, not 'east'");
  EXPECT_EQ(error("plan_points(1, 2)"),
            "plan_points: one knot at t = 1: a leg needs two; leave it out, or write a plain row");
  EXPECT_EQ(error("plan_points(1, x) FROM (SELECT 1 AS x UNION ALL SELECT 2)"),
            "plan_points: t is 1 in two rows, at (1) and at (2): times must rise; leave one out");
  EXPECT_EQ(error("plan_points(t, t) FROM (SELECT 1 AS t UNION ALL SELECT 1)"),
            "plan_points: one knot at t = 1: a leg needs two; leave it out, or write a plain row");
  EXPECT_EQ(
      error("plan_points(1, x, 7) FROM (SELECT NULL AS x UNION ALL SELECT -2)"),
      "plan_points: t is 1 in two rows, at (-2, 7) and without a position: times must rise; leave one out");
  EXPECT_EQ(error("plan_points(t, t) FROM (SELECT 1 AS t UNION ALL SELECT 9e999)"),
            "plan_points: at t = inf: x is infinite: write a finite number");
  EXPECT_EQ(error("plan_points(t, iif(t < 9, t, 7)) FROM (SELECT 1 AS t UNION ALL SELECT 9e999)"),
            "plan_points: knot 2: t is inf, but its place is not that of knot 1: write the place where the "
            "mover stays");
  EXPECT_EQ(error("plan_points(t, t * 1e308) FROM (SELECT -1.0 AS t UNION ALL SELECT -0.9)"), "");
  EXPECT_EQ(error("plan_uniform(1, 0, 1, 1)"), "plan_uniform: leg 1 ends at 0, before it starts at 1");
  EXPECT_EQ(error("plan_uniform(1, 2, 1, NULL)"),
            "plan_uniform: at t = 1: a number of the leg is NULL: write 0, or leave the row out");
  EXPECT_EQ(
      error("plan_uniform(1, NULL, x, 1) FROM (SELECT 1 AS x UNION ALL SELECT 2)"),
      "plan_uniform: t is 1 in two rows, at (1) and at (2): times must rise; write until, or leave one out");
  EXPECT_EQ(error("plan_accelerated(t, t + 2, 1, 1, 1) FROM (SELECT 1 AS t UNION ALL SELECT 2)"),
            "plan_accelerated: leg 2 starts at 2, before leg 1 ends at 3");
  EXPECT_EQ(error("plan_uniform(9e999, NULL, 1, 1)"), "plan_uniform: t is infinite: write a finite number");
}

TEST_F(PlanFunctions, MoreThanTheLimitIsForPlanCut) {
  db.exec(
      "CREATE TABLE p AS WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 1048577) "
      "SELECT plan_points(i, 0) AS plan FROM n");
  EXPECT_EQ(db.error_of("SELECT * FROM p, plan_rows(plan)"),
            "plan_rows: 1048577 legs; at most 1048576: cut it with plan_cut");
  EXPECT_EQ(db.error_of("SELECT plan_shift(plan, 1) FROM p"),
            "plan_shift: 1048577 legs; at most 1048576: cut it with plan_cut");
  EXPECT_EQ(db.rows("SELECT count(*) FROM p, plan_rows(plan_cut(plan, 0, 1048576))"), "1048576");
}

}  // namespace
}  // namespace foresee::testing
