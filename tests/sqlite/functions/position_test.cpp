// predictive_position in SQL: outputs, inputs, look-ups by id, errors.
#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

struct PositionTest : Harbour {};

TEST_F(PositionTest, GivesPlaceAndVelocityWithNullForUndeclaredAxes) {
  EXPECT_EQ(db.rows("SELECT * FROM predictive_position(2) ORDER BY id"),
            "1|2.0|0.0|NULL|1.0|0.0|NULL|NULL|NULL|NULL|NULL|NULL|NULL\n2|8.0|0.0|NULL|-1.0|0.0|NULL|NULL|"
            "NULL|NULL|NULL|NULL|NULL\n"
            "3|0.0|99.0|NULL|0.0|0.0|NULL|NULL|NULL|NULL|NULL|NULL|NULL");
  db.exec("CREATE VIRTUAL TABLE rails USING moving_objects(id, x); INSERT INTO rails VALUES (7, 1.5)");
  EXPECT_EQ(db.rows("SELECT * FROM predictive_position(2, 'rails')"),
            "7|1.5|NULL|NULL|0.0|NULL|NULL|NULL|NULL|NULL|NULL|NULL|NULL");
  db.exec(
      "CREATE VIRTUAL TABLE drones USING moving_objects(id, x, y, z, vx, vy, vz, ax, ay, az);"
      "INSERT INTO drones VALUES (1, 0, 0, 0, 1, 2, 3, 2, 0, -2)");
  EXPECT_EQ(db.rows("SELECT * FROM predictive_position(3, 'drones')"),
            "1|12.0|6.0|0.0|7.0|2.0|-3.0|NULL|NULL|NULL|NULL|NULL|NULL");
  db.exec(
      "CREATE VIRTUAL TABLE carts USING moving_objects(id, x, vx, fx, m); INSERT INTO carts VALUES (1, 0, 0, "
      "8, 4)");
  EXPECT_EQ(db.rows("SELECT x, vx FROM predictive_position(3, 'carts')"), "9.0|6.0");
}

TEST_F(PositionTest, TakesInputsByName) {
  EXPECT_EQ(
      db.rows(
          "SELECT x FROM predictive_position WHERE at = 4 AND tbl = 'ships' AND schema = 'main' AND id = 1"),
      "4.0");
  EXPECT_EQ(db.rows("SELECT x FROM predictive_position(4, NULL, NULL) WHERE id = 1"), "4.0");
}

TEST_F(PositionTest, LeavesOutObjectsThatDoNotExistThen) {
  db.exec(
      "CREATE VIRTUAL TABLE lives USING moving_objects(id, t, x, until);"
      "INSERT INTO lives VALUES (1, 0, 0, 5), (2, 3, 0, NULL)");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_position(2, 'lives')"), "1");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_position(3, 'lives') ORDER BY id"), "1\n2");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_position(5, 'lives') ORDER BY id"), "1\n2");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_position(5.5, 'lives')"), "2");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_position(-1, 'lives')"), "");
}

TEST_F(PositionTest, OfOneIdIsLookedUp) {
  db.exec(
      "INSERT INTO ships SELECT value, 0, value, 2, 1, 0, 0, 'many' FROM (WITH n(value) AS "
      "(VALUES(100) UNION ALL SELECT value + 1 FROM n WHERE value < 20000) SELECT value FROM n)");
  const auto steps = [&](const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db.handle(), sql.c_str(), -1, &statement, nullptr), SQLITE_OK);
    while (sqlite3_step(statement) == SQLITE_ROW) {
    }
    const int count = sqlite3_stmt_status(statement, SQLITE_STMTSTATUS_VM_STEP, 0);
    sqlite3_finalize(statement);
    return count;
  };
  for (const char* which : {"id = 777", "id IN (3, 777, 778)", "id = 3 OR id = 777", "id = 777.0",
                            "id = '777'", "id = NULL", "id = -5", "id = 777.5"}) {
    const std::string question = "predictive_position(7, 'ships') WHERE ";
    EXPECT_EQ(
        db.rows("SELECT * FROM " + question + which + " ORDER BY id"),
        db.rows("SELECT * FROM (SELECT * FROM predictive_position(7, 'ships') LIMIT -1 OFFSET 0) WHERE " +
                std::string(which) + " ORDER BY id"))
        << which;
    if (std::string(which) != "id = 777.5") {
      EXPECT_LT(steps("SELECT * FROM " + question + which), 200) << which;
    }
  }
}

TEST_F(PositionTest, FeedsItsOwnTableAndEnds) {
  db.exec("INSERT INTO ships SELECT id + 10, 5, x, y, vx, vy, 0, 'copy' FROM predictive_position(5)");
  EXPECT_EQ(db.rows("SELECT count(*), sum(x) FROM ships WHERE id > 10"), "3|10.0");
}

TEST_F(PositionTest, MovesAFleetForward) {
  db.exec(
      "UPDATE ships SET t = 5, x = p.x, y = p.y FROM predictive_position(5, 'ships') p WHERE p.id = "
      "ships.id");
  EXPECT_EQ(db.rows("SELECT id, t, x, y FROM ships ORDER BY id"),
            "1|5.0|5.0|0.0\n2|5.0|5.0|0.0\n3|5.0|0.0|99.0");
}

TEST_F(PositionTest, GivesATrackForASeriesOfTimes) {
  EXPECT_EQ(
      db.rows("WITH moments(s) AS (VALUES (0), (1), (2)) SELECT s, x FROM moments, predictive_position(s, "
              "'ships') WHERE id = 2"),
      "0|10.0\n1|9.0\n2|8.0");
}

TEST_F(PositionTest, IsNeverNullOnADeclaredAxis) {
  db.exec(
      "CREATE VIRTUAL TABLE far USING moving_objects(id, x, vx, ax); INSERT INTO far VALUES (1, 0, 1e200, "
      "-1e200)");
  EXPECT_EQ(db.rows("SELECT x, vx FROM predictive_position(1e200, 'far')"), "-inf|-inf");
}

TEST_F(PositionTest, SaysWhatIsWrong) {
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_position"),
            "predictive_position: at is missing or NULL: write predictive_position(at, tbl, schema)");
  EXPECT_EQ(
      db.error_of("SELECT * FROM predictive_position('noon')"),
      "predictive_position: at must be a number, not 'noon': write predictive_position(at, tbl, schema)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_position(9e999)"),
            "predictive_position: at must be a finite number, not inf");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_position(1, 'nowhere')"),
            "predictive_position: no such table: 'nowhere' (moving_objects tables here: 'ships')");
  EXPECT_EQ(
      db.error_of("SELECT * FROM predictive_position(1, 'Main.ships')"),
      "predictive_position: no such table: 'Main.ships'; write the schema separately: 'ships' with schema = "
      "'main' (moving_objects tables here: 'ships')");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_position(1, 'ships') WHERE schema = 'main'"), "3");
}

}  // namespace
}  // namespace foresee::testing
