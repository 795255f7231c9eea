// Errors of predictive_join: each message says what to write instead.
#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

struct JoinErrors : Harbour {
  std::string error(const std::string& call) { return db.error_of("SELECT * FROM " + call); }
};

TEST_F(JoinErrors, NameTheMissingHorizon) {
  const char* missing =
      "predictive_join: h is missing or NULL: write predictive_join(h, tbl, within, other, now, method, "
      "within_z, schema, own_x0, own_x1, own_y0, own_y1, contacts)";
  EXPECT_EQ(error("predictive_join"), missing);
  EXPECT_EQ(error("predictive_join(NULL, 'ships')"), missing);
  EXPECT_EQ(error("predictive_join WHERE tbl = 'ships'"), missing);
}

TEST_F(JoinErrors, QuoteTheWrongInput) {
  EXPECT_EQ(error("predictive_join(-3)"), "predictive_join: h must be a finite number >= 0, not -3");
  EXPECT_EQ(error("predictive_join(9e999)"), "predictive_join: h must be a finite number >= 0, not inf");
  const std::string order = ": write predictive_join(h, tbl, within, other, now, ...)";
  EXPECT_EQ(error("predictive_join('soon')"), "predictive_join: h must be a number, not 'soon'" + order);
  EXPECT_EQ(error("predictive_join('ships', 600)"),
            "predictive_join: h must be a number, not 'ships'" + order);
  EXPECT_EQ(error("predictive_join(x'00')"), "predictive_join: h must be a number, not a blob of 1 bytes");
  EXPECT_EQ(error("predictive_join(1, 'ships', -1)"),
            "predictive_join: within must be a finite number >= 0, not -1");
  EXPECT_EQ(error("predictive_join(1, 'ships', 'near')"),
            "predictive_join: within must be a number, not 'near'" + order);
  EXPECT_EQ(error("predictive_join(1, 926)"),
            "predictive_join: tbl must be a name in quotes, or NULL to leave it out, not 926" + order +
                ", or WHERE within = 60");
  EXPECT_EQ(error("ships, predictive_join(1, r >= 0)"),
            "predictive_join: tbl must be a name in quotes, or NULL to leave it out, not 1" + order +
                ", or WHERE within = 60");
  EXPECT_EQ(error("predictive_position(1, 2.5)"),
            "predictive_position: tbl must be a name in quotes, or NULL to leave it out, not 2.5: write "
            "predictive_position(at, tbl, schema), or WHERE at = 60");
  EXPECT_EQ(error("predictive_join(1) WHERE now = -9e999"),
            "predictive_join: now must be a finite number, not -inf");
  EXPECT_EQ(error("predictive_join(1) WHERE now = 'now'"),
            "predictive_join: now must be a number, not 'now': write unixepoch('now')");
  EXPECT_EQ(error("predictive_join(1) WHERE method = 'quick'"),
            "predictive_join: method must be 'auto', 'grid', 'tree', 'scan' or 'gpcd', not 'quick'");
  EXPECT_EQ(error("predictive_join(1) WHERE method = 2"),
            "predictive_join: method must be a name in quotes, or NULL to leave it out, not 2");
  EXPECT_EQ(error("predictive_join(1) WHERE other = 2"),
            "predictive_join: other must be a name in quotes, or NULL to leave it out, not 2" + order);
  EXPECT_EQ(
      error("predictive_join(1) WHERE schema = x'00'"),
      "predictive_join: schema must be a name in quotes, or NULL to leave it out, not a blob of 1 bytes");
}

TEST_F(JoinErrors, RefuseExtraInputs) {
  EXPECT_EQ(error("predictive_join(1, 'ships', 0, NULL, 0, 'auto', 0, 'main', 1, 2, 3, 4, 'all', 9)"),
            "predictive_join: too many inputs: write at most predictive_join(h, tbl, within, other, now, "
            "method, within_z, "
            "schema, own_x0, own_x1, own_y0, own_y1, contacts)");
}

TEST_F(JoinErrors, NameBothTablesOfDifferentAxes) {
  db.exec("CREATE VIRTUAL TABLE drones USING moving_objects(id, x, y, z)");
  EXPECT_EQ(
      error("predictive_join(1, 'ships', 0, 'drones')"),
      "predictive_join: ships has 2 axes and drones has 3 axes: a join takes two tables with the same number "
      "of axes");
}

TEST_F(JoinErrors, NameBothTablesOfShapesWithoutADistance) {
  db.exec(
      "CREATE VIRTUAL TABLE cans USING moving_objects(id, x, y, z, r, hz);"
      "CREATE VIRTUAL TABLE balls USING moving_objects(id, x, y, z, r);"
      "INSERT INTO cans VALUES (1, 0, 0, 0, 1, 1); INSERT INTO balls VALUES (1, 0, 0, 0, 1)");
  const std::string message = error("predictive_join(1, 'cans', 0, 'balls')");
  EXPECT_TRUE(message.starts_with("predictive_join: ")) << message;
  EXPECT_NE(message.find("cans"), std::string::npos) << message;
  EXPECT_NE(message.find("balls"), std::string::npos) << message;
}

/// For every radius, method and id, and for empty tables too.
TEST_F(JoinErrors, OfShapesWithoutADistanceFollowFromTheDeclarations) {
  db.exec(
      "CREATE VIRTUAL TABLE cans USING moving_objects(id, x, y, z, r, hz);"
      "CREATE VIRTUAL TABLE balls USING moving_objects(id, x, y, z, r);"
      "INSERT INTO cans VALUES (1, 0, 0, 0, 1, 1), (2, 9, 9, 9, 1, 1)");
  const std::string message =
      "predictive_join: no distance is defined between cans (cylinders) and balls (balls): declare hz in "
      "balls to make them cylinders";
  for (const char* ball : {"", "INSERT INTO balls VALUES (1, 0, 0, 0, 0)", "UPDATE balls SET r = 1"}) {
    db.exec(ball);
    for (const std::string method : {"auto", "grid", "tree", "scan", "gpcd"})
      for (const char* ids : {"", " WHERE a = 1", " WHERE b = 1", " WHERE a = 7", " WHERE a = 2"}) {
        EXPECT_EQ(error("predictive_join(1, 'cans', 0, 'balls', 0, '" + method + "')" + ids), message);
        EXPECT_EQ(error("predictive_join(1, 'balls', 0, 'cans', 0, '" + method + "')" + ids), message);
      }
  }
}

TEST_F(JoinErrors, RefuseWithinZWhereHeightMeansNothing) {
  const std::string message = error("predictive_join(1, 'ships', 0, NULL, 0, 'auto', 5)");
  EXPECT_TRUE(message.starts_with("predictive_join: ")) << message;
  EXPECT_NE(message.find("within_z"), std::string::npos) << message;
  EXPECT_EQ(error("predictive_join(1) WHERE within_z = -5"),
            "predictive_join: within_z must be a finite number >= 0, not -5");
}

TEST_F(JoinErrors, ANameDoesNotEndAtANul) {
  const auto with_nul = [](const std::string& text) { return "'" + text + "' || char(0) || 'x'"; };
  EXPECT_TRUE(error("predictive_join(1, " + with_nul("ships") + ")")
                  .starts_with("predictive_join: no such table: 'ships\\0x' (moving_objects tables here: "));
  EXPECT_TRUE(error("predictive_join(1, 'ships', 0, NULL, 0, 'auto', NULL, " + with_nul("main") + ")")
                  .starts_with("predictive_join: no such table: 'ships' in schema 'main\\0x'"));
  EXPECT_EQ(error("predictive_join(1, 'ships', 0, NULL, 0, " + with_nul("scan") + ")"),
            "predictive_join: method must be 'auto', 'grid', 'tree', 'scan' or 'gpcd', not 'scan\\0x'");
  EXPECT_EQ(error("predictive_window(1, 'ships') WHERE method = " + with_nul("scan")),
            "predictive_window: method must be 'auto', 'tree' or 'scan', not 'scan\\0x'");
  EXPECT_TRUE(db.error_of("INSERT INTO ships(ships) VALUES (" + with_nul("rebuild") + ")")
                  .starts_with("ships: no command 'rebuild\\0x';"));
  EXPECT_NE(db.error_of("SELECT ships FROM ships WHERE ships MATCH " + with_nul("foresee-handle")), "");
}

TEST_F(JoinErrors, StopALoopOfCallsAtTheWrongOne) {
  EXPECT_EQ(db.rows("WITH horizons(v) AS (VALUES (20), (-1)) SELECT a FROM horizons, predictive_join(v)"),
            "error: predictive_join: h must be a finite number >= 0, not -1");
}

}  // namespace
}  // namespace foresee::testing
