// predictive_avoid where the result has several legs: waits, resume, and tables with plans; changes written back keep
// clear.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct AvoidInLegs : ::testing::Test {
  AvoidInLegs() {
    db.exec(
        "CREATE VIRTUAL TABLE carts USING moving_objects(id, t, x, y, vx, vy, r);"
        "INSERT INTO carts VALUES (1, 0, 0, 0, 2, 0, 1), (2, 0, 20, -20, 0, 2, 1)");  // they meet at (20, 0)
  }
  std::string legs(const std::string& call, const std::string& where) {
    return db.rows("SELECT leg, p.t, p.until, p.x, p.y, p.vx, p.vy FROM predictive_avoid(" + call +
                   ") a, plan_rows(a.plan) p WHERE " + where + " ORDER BY k_from, leg");
  }

  Database db;
};

TEST_F(AvoidInLegs, WaitsUntilTheOtherHasPassed) {
  // The closest approach after a wait of k is k sqrt(2), and the two touch within 3.
  EXPECT_EQ(db.rows("SELECT clear, round(k_from, 6), round(k_to, 6), below, above, plan IS NULL, vx "
                    "FROM predictive_avoid(60, 'carts', 1, 1, 'wait', 0, 30)"),
            "0|0.0|2.12132|2|2|1|2.0\n1|2.12132|30.0|2|NULL|0|0.0");
  EXPECT_EQ(legs("60, 'carts', 1, 1, 'wait', 3, 3", "clear"),
            "1|0.0|3.0|0.0|0.0|0.0|0.0\n2|3.0|NULL|0.0|0.0|2.0|0.0");
}

TEST_F(AvoidInLegs, ResumesItsVelocity) {
  EXPECT_EQ(legs("60, 'carts', 1, 1, 'speed', -1, -1", "clear AND resume = 5"),
            "1|0.0|5.0|0.0|0.0|1.0|0.0\n2|5.0|NULL|5.0|0.0|2.0|0.0");
  EXPECT_EQ(
      db.rows("SELECT clear FROM predictive_avoid(60, 'carts', 1, 1, 'speed', -1, -1) WHERE resume = 3"), "0")
      << "late by 1.5: 2.1 apart, within 3";
}

TEST_F(AvoidInLegs, GivesThePlanAloneAndTheLastOutputsAlone) {
  EXPECT_EQ(db.rows("SELECT typeof(plan) FROM predictive_avoid(60, 'carts', 1, 1, 'wait', 3, 3)"), "blob");
  db.exec(
      "CREATE VIRTUAL TABLE flights USING moving_objects(id, lat, lon, z, speed, course, vz, r, origin = '50 "
      "8');"
      "INSERT INTO flights VALUES (1, 50, 8, 900, 100, 0, 2, 30)");
  EXPECT_EQ(db.rows("SELECT height FROM predictive_avoid(60, 'flights', 1, 0, 'turn', 5, 5)"), "900.0");
  EXPECT_EQ(db.rows("SELECT climb FROM predictive_avoid(60, 'flights', 1, 0, 'turn', 5, 5)"), "2.0");
}

struct AvoidInPlans : ::testing::Test {
  AvoidInPlans() {
    // 1 drives east, stops for 4 at (10, 0), and goes on north; 2 comes from the north and passes (10, 10) at 25.
    db.exec(
        "CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y, plan, r, until, +name);"
        "INSERT INTO robots(id, plan, r) VALUES (1, 'LINESTRING M(0 0 0, 10 0 10, 10 0 14, 10 20 34)', 1),"
        "  (2, 'LINESTRING M(10 40 0, 10 20 15, 10 0 35)', 1);"
        "INSERT INTO robots(id, x, y, r) VALUES (3, -50, 0, 1)");
  }
  std::string contacts() {
    return db.rows("SELECT a, b FROM predictive_join(200, 'robots', 0.5) WHERE now = 2 AND (a = 1 OR b = 1)");
  }

  Database db;
};

TEST_F(AvoidInPlans, RefusesWhatAPlanCannotDo) {
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_avoid(60, 'robots', 1)"),
            "predictive_avoid: robots: row 1 has a plan: write 'wait' or 'delay' with lo and hi, as in "
            "'wait', 0, 600");
  EXPECT_EQ(db.rows("SELECT count(*) > 0 FROM predictive_avoid(60, 'robots', 3)"), "1");
}

TEST_F(AvoidInPlans, FindsTheObjectsThatItsLegsMeet) {
  EXPECT_EQ(contacts(), "1|2");
  EXPECT_EQ(
      db.rows("SELECT clear, k_from, below FROM predictive_avoid(200, 'robots', 1, 0.5, 'wait', 0, 0, 2)"),
      "0|0.0|2");
  EXPECT_EQ(
      db.rows(
          "SELECT count(*), sum(clear) > 0 FROM predictive_avoid(200, 'robots', 1, 0.5, 'wait', 0, 90, 2) "
          "WHERE k_to > 60"),
      "1|1");
}

TEST_F(AvoidInPlans, KeepsClearOnceAWaitIsWrittenBack) {
  db.exec(
      "UPDATE robots SET (plan, until) = (SELECT plan, until FROM predictive_avoid(200, 'robots', 1, 0.5, "
      "'wait', 0, "
      "90, 2) WHERE clear ORDER BY k LIMIT 1) WHERE id = 1");
  EXPECT_EQ(contacts(), "");
}

TEST_F(AvoidInPlans, KeepsKnotsAndGivesBackTheStoredPlan) {
  EXPECT_EQ(db.rows("SELECT plan FROM predictive_avoid(200, 'robots', 2, 0, 'wait', 0, 0, 2)"),
            "LINESTRING M(10 40 0, 10 20 15, 10 0 35)");
  EXPECT_EQ(db.rows("SELECT plan, t, x FROM predictive_avoid(200, 'robots', 2, 0, 'wait', 64, 64, 15)"),
            "LINESTRING M(10 40 0, 10 20 15, 10 20 79, 10 0 99)|0.0|10.0");
  EXPECT_EQ(db.rows("SELECT plan, t FROM predictive_avoid(200, 'robots', 2, 0, 'delay', 64, 64, -1)"),
            "LINESTRING M(10 40 64, 10 20 79, 10 0 99)|64.0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_avoid(200, 'robots', 2, 0, 'delay', 64, 64, 1)"), "0")
      << "it has started";
}

TEST_F(AvoidInPlans, AvoidsPlansOfASecondTable) {
  db.exec(
      "CREATE VIRTUAL TABLE carts USING moving_objects(id, t, x, y, vx, vy, r);"
      "INSERT INTO carts VALUES (1, 0, 0, 10, 1, 0, 1)");
  // At (10, 10) the cart is at 10, robot 1 at 24.
  EXPECT_EQ(db.rows("SELECT clear FROM predictive_avoid(60, 'carts', 1, 0, 'speed', 0, 0, 0, 'robots')"),
            "1");
  EXPECT_EQ(
      db.rows("SELECT clear, below, below_tbl FROM predictive_avoid(60, 'carts', 1, 0, 'wait', 14, 14, 0, "
              "'robots')"),
      "0|1|robots");
}

// What no column of the table stores.

struct AvoidWithoutColumns : AvoidInLegs {};

TEST_F(AvoidWithoutColumns, GivesAPlanOfOneLegInATableOfPlansWithoutT) {
  db.exec(
      "CREATE VIRTUAL TABLE drones USING moving_objects(id, x, y, vx, vy, plan, r);"
      "INSERT INTO drones(id, x, y, vx, vy, r) VALUES (1, 0, 0, 2, 0, 1), (2, 30, 0, 0, 0, 1), (3, 40, 12, "
      "-1, 0, 1)");
  const std::string change = "FROM predictive_avoid(60, 'drones', 1, 1, 'turn', -28, -28, 5)";
  EXPECT_EQ(db.rows("SELECT clear, t, x, until, plan IS NULL " + change), "1|5.0|10.0|NULL|0");
  db.exec("UPDATE drones SET plan = (SELECT plan " + change + ") WHERE id = 1");
  EXPECT_EQ(
      db.rows(
          "SELECT leg, p.t, p.until, p.x, round(p.vx, 3), round(p.vy, 3) FROM drones d, plan_rows(d.plan) p "
          "WHERE d.id = 1"),
      "1|5.0|NULL|10.0|1.766|0.939");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(60, 'drones', 1) WHERE now = 5"), "");
  EXPECT_EQ(legs("60, 'drones', 2, 1, 'delay', 2, 2, 0", "1"), "1|2.0|NULL|30.0|0.0|0.0|0.0");
  EXPECT_EQ(db.rows("SELECT plan FROM predictive_avoid(60, 'drones', 2, 1, 'turn', 0, 0, 0)"), "NULL");
}

TEST_F(AvoidWithoutColumns, RefusesAStartThatATableInDegreesCannotStore) {
  db.exec(
      "CREATE VIRTUAL TABLE boats USING moving_objects(id, lat, lon, speed, course, plan, r, origin = '54 "
      "8');"
      "INSERT INTO boats(id, lat, lon, speed, course, r) VALUES (1, 54, 8, 2, 90, 1)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_avoid(60, 'boats', 1, 0, 'turn', 0, 1, 5)"),
            "predictive_avoid: now must be 0 in a table without t: write now = 0, or declare t in boats; a "
            "change from "
            "5 on cannot be stored there");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_avoid(60, 'boats', 1, 0, 'delay', 0, 1, 0)"),
            "predictive_avoid: 'delay' changes t: declare t in boats");
  EXPECT_EQ(db.rows("SELECT clear FROM predictive_avoid(60, 'boats', 1, 0, 'turn', 0, 1, 0)"), "1");
  EXPECT_EQ(db.rows("SELECT clear FROM predictive_avoid(60, 'boats', 9, 0, 'turn', 0, 1, 5)"), "")
      << "no object";
}

TEST_F(AvoidWithoutColumns, RefusesAVelocityThatNoColumnStores) {
  db.exec(
      "CREATE VIRTUAL TABLE sledges USING moving_objects(id, t, x, y, z, ax, ay, az, r);"
      "INSERT INTO sledges VALUES (1, 0, 0, 0, 0, 1, 0, 0, 1), (2, 0, -10, 0, 0, 0, 0, 0, 1)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_avoid(5, 'sledges', 1, 0, 'accelerate', -2.5, -2.5, 4)"),
            "predictive_avoid: sledges: row 1 has a velocity at 4, which no column stores: declare vx …, or "
            "write now "
            "= 0");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_avoid(5, 'sledges', 1, 0, 'climb', -2.5, -2.5, 0)"),
            "predictive_avoid: 'climb' changes vz: declare vx, vy, vz in sledges");
  EXPECT_EQ(
      db.rows(
          "SELECT clear, vx, round(ay, 3) FROM predictive_avoid(5, 'sledges', 1, 0, 'turn', -90, -90, 0)"),
      "1|NULL|1.0");
}

TEST_F(AvoidWithoutColumns, RefusesAPlanOfAnOutlineThatTurnsBack) {
  db.exec(
      "CREATE VIRTUAL TABLE hulls USING moving_objects(id, t, x, y, vx, vy, shape, heading, plan);"
      "INSERT INTO hulls(id, t, x, y, vx, vy, shape, heading) VALUES"
      "  (1, 0, 0, 0, 2, 0, 'POLYGON((-1 -3, 1 -3, 0 3, -1 -3))', 90)");
  EXPECT_EQ(db.error_of(
                "SELECT plan FROM predictive_avoid(60, 'hulls', 1, 1, 'turn', 60, 60, 0) WHERE resume = 12"),
            "predictive_avoid: a 'turn' with resume turns the outline back, and a plan has one heading: "
            "leave plan out "
            "and store the first leg, or leave resume out");
  EXPECT_EQ(db.rows("SELECT clear, heading FROM predictive_avoid(60, 'hulls', 1, 1, 'turn', 60, 60, 0) "
                    "WHERE resume = 12"),
            "1|150.0");
}

TEST_F(AvoidInLegs, NamesTheFirstDelayThatItTakes) {
  db.exec(
      "CREATE VIRTUAL TABLE trams USING moving_objects(id, t, x, vx, r);"
      "INSERT INTO trams VALUES (1, 10.047163307392325, 0, 1, 1), (2, 0, 5, 0, 1)");
  const std::string call = "SELECT clear FROM predictive_avoid(60, 'trams', 1, 0.5, 'delay', ",
                    now = ", 5, 1.9352673989719382)";
  EXPECT_EQ(db.error_of(call + "-8.111895908420388" + now),
            "predictive_avoid: 'delay' cannot make an object start before now: lo must not be less than now "
            "- t, which is -8.111895908420385; lo is -8.111895908420388");
  EXPECT_EQ(db.error_of(call + "-8.111895908420385" + now), "");
  // now - t as SQL computes it is the nearest double, here one that is too early.
  EXPECT_EQ(
      db.rows("SELECT 10.047163307392325 + (1.9352673989719382 - 10.047163307392325) < 1.9352673989719382"),
      "1");
  EXPECT_EQ(db.rows("SELECT DISTINCT 10.047163307392325 + k_from >= 1.9352673989719382 FROM "
                    "predictive_avoid(60, 'trams', "
                    "1, 0.5, 'delay', 1.9352673989719382 - 10.047163307392325, 5, 1.9352673989719382)"),
            "1");
}

/// The newest t is then the start of another plan, and a contact before it would not be examined.
TEST_F(AvoidInLegs, ALaterPlanOfAnotherObjectNeedsNow) {
  db.exec(
      "CREATE VIRTUAL TABLE bots USING moving_objects(id, x, y, plan, r); INSERT INTO bots(id, plan, r) "
      "VALUES"
      "  (1, 'LINESTRING M(0 0 0, 40 0 20, 40 0 inf)', 1), (2, 'LINESTRING M(20 -20 0, 20 20 20, 20 20 "
      "inf)', 1)");
  const std::string query =
                        "SELECT clear, round(k_from, 2), round(k_to, 2) FROM predictive_avoid(60, 'bots', 1, "
                        "1, 'wait', 0, 30",
                    ranges = "0|0.0|2.12\n1|2.12|30.0";
  EXPECT_EQ(db.rows(query + ")"), ranges);
  db.exec("INSERT INTO bots(id, plan, r) VALUES (3, 'LINESTRING M(500 500 3600, 600 500 3700)', 1)");
  EXPECT_EQ(
      db.error_of(query + ")"),
      "predictive_avoid: the newest t is 3600, perhaps the start of a plan later than that of the object, 0: "
      "write now = ..., the time of the manoeuvre");
  EXPECT_EQ(db.rows(query + ", 0)"), ranges);
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_avoid(60, 'bots', 3, 1, 'wait', 0, 30)"), "");
}

}  // namespace
}  // namespace foresee::testing
