// Frames of tables: foresee_tables lists them, and tables whose coordinates do not match are not compared.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct TableFrames : ::testing::Test {
  TableFrames() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, lat, lon, speed, course, origin = '53.9 7.9', "
        "speed_unit = knots);"
        "CREATE VIRTUAL TABLE buoys USING moving_objects(id, lat, lon, origin = '53.9 7.9', speed_unit = "
        "kmh);"
        "CREATE VIRTUAL TABLE far USING moving_objects(id, lat, lon, origin = '54 8');"
        "CREATE VIRTUAL TABLE first USING moving_objects(id, lat, lon);"
        "CREATE VIRTUAL TABLE plain USING moving_objects(id, x, y);"
        "CREATE VIRTUAL TABLE other USING moving_objects(id, x, y, vx, vy);"
        "CREATE VIRTUAL TABLE dock USING moving_objects(id, x, y, frame = 'dock 3');"
        "CREATE VIRTUAL TABLE dock_too USING moving_objects(id, x, y, frame = \"dock 3\");"
        "CREATE VIRTUAL TABLE yard USING moving_objects(id, x, y, frame = yard);"
        "INSERT INTO ships VALUES (1, 53.95, 7.95, 10, 0); INSERT INTO buoys VALUES (1, 53.96, 7.95);");
    for (const char* table : {"plain", "dock", "dock_too", "yard"})
      db.exec(std::string("INSERT INTO ") + table + " VALUES (1, 0, 0)");
    db.exec("INSERT INTO far VALUES (1, 54, 8); INSERT INTO other VALUES (1, 0, 0, 1, 1)");
  }

  Database db;
};

TEST_F(TableFrames, AreListed) {
  EXPECT_EQ(db.rows("SELECT * FROM foresee_tables ORDER BY name"),
            "buoys|main|degrees|53.9 7.9|kmh|1\n"
            "dock|main|dock 3|NULL|NULL|1\n"
            "dock_too|main|dock 3|NULL|NULL|1\n"
            "far|main|degrees|54 8|mps|1\n"
            "first|main|degrees|NULL|mps|0\n"
            "other|main|plane|NULL|NULL|1\n"
            "plain|main|plane|NULL|NULL|1\n"
            "ships|main|degrees|53.9 7.9|knots|1\n"
            "yard|main|yard|NULL|NULL|1");
  db.exec(
      "ATTACH ':memory:' AS side; CREATE VIRTUAL TABLE side.ships USING moving_objects(id, x);"
      "BEGIN; INSERT INTO side.ships VALUES (1, 2), (3, 4)");
  EXPECT_EQ(db.rows("SELECT name, schema, objects FROM foresee_tables WHERE schema = 'side'"),
            "ships|side|2");
  EXPECT_EQ(db.rows("SELECT name, objects FROM foresee_tables('side')"), "ships|2");
  EXPECT_EQ(db.rows("SELECT count(*) FROM foresee_tables('nowhere')"), "0");
  db.exec("ROLLBACK");
  EXPECT_EQ(db.rows("SELECT count(*) FROM foresee_tables WHERE schema = 'side' AND objects = 0"), "1");
  db.exec("DELETE FROM plain_meta WHERE key = 'objects'; CREATE TABLE t AS SELECT * FROM plain_meta");
}

/// Every function that reads two tables.
TEST_F(TableFrames, AreComparedWhereTwoTablesMeet) {
  const auto refused = [&](const std::string& a, const std::string& b, const std::string& why) {
    for (const std::string function : {"predictive_join", "predictive_explain"}) {
      const std::string call =
          " FROM " + function + " WHERE h = 10 AND within = 5 AND tbl = '" + a + "' AND other = '" + b + "'";
      EXPECT_EQ(db.error_of("SELECT *" + call), function + ": " + why);
      if (function == "predictive_join") {
        EXPECT_EQ(db.error_of("SELECT *" + call + " AND a = 1"), function + ": " + why);
        EXPECT_EQ(db.error_of("SELECT *" + call + " AND now = 0 AND own_x0 = 5"), function + ": " + why);
      }
    }
    EXPECT_EQ(
        db.error_of("SELECT * FROM predictive_avoid WHERE h = 10 AND id = 1 AND how = 'speed' AND tbl = '" +
                    a + "' AND also = '" + b + "'"),
        "predictive_avoid: " + why);
    EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE w USING predictive_watch(" + a +
                          ", horizon = 10, other = " + b + ")"),
              "w: " + why);
  };
  refused(
      "ships", "plain",
      "ships has lat, lon, plain has x, y: their coordinates do not match; create plain with lat, lon and "
      "origin = '53.9 7.9'");
  refused(
      "other", "first",
      "first has lat, lon, other has x, y: their coordinates do not match; create other with lat, lon and "
      "an origin");
  refused(
      "ships", "far",
      "ships has origin '53.9 7.9', far has '54 8': their coordinates do not match; create far with origin = "
      "'53.9 7.9'");
  refused(
      "dock", "yard",
      "dock has frame 'dock 3', yard has 'yard': their coordinates do not match; create yard with frame = "
      "'dock 3'");
  refused(
      "other", "dock",
      "other has frame none, dock has 'dock 3': their coordinates do not match; create other with frame = "
      "'dock 3'");
  refused("ships", "dock",
          "ships has lat, lon, dock has x, y: their coordinates do not match; create dock with lat, lon and "
          "origin = '53.9 7.9'");
}

TEST_F(TableFrames, ThatAreEqualAreJoined) {
  const auto count = [&](const std::string& a, const std::string& b) {
    return db.rows("SELECT count(*) FROM predictive_join(1000, '" + a + "', 100, '" + b + "')");
  };
  EXPECT_EQ(count("ships", "buoys"), "1");
  EXPECT_EQ(count("ships", "ships"), "0");
  EXPECT_EQ(count("plain", "other"), "1");
  EXPECT_EQ(count("dock", "dock_too"), "1");
  EXPECT_EQ(count("ships", "first"), "0") << "it is empty";
  db.exec(
      "CREATE VIRTUAL TABLE w USING predictive_watch(ships, horizon = 1000, within = 100, other = buoys)");
  EXPECT_EQ(db.rows("SELECT a, b FROM w"), "1|1");
}

/// A table without an origin takes only one that fits all its watches.
TEST_F(TableFrames, OfWatchedTablesAreComparedWhenAnOriginIsChosen) {
  db.exec(
      "CREATE VIRTUAL TABLE w USING predictive_watch(ships, horizon = 1000, within = 100, other = first);"
      "CREATE VIRTUAL TABLE alone USING predictive_watch(first, horizon = 1000)");
  const std::string error =
      "w: ships has origin '53.9 7.9', first has '54 8': their coordinates do not match; create first with "
      "origin = '53.9 7.9'";
  EXPECT_EQ(db.error_of("INSERT INTO first VALUES (1, 54, 8)"), error);
  EXPECT_EQ(db.code_of("INSERT INTO first VALUES (1, 54, 8)"), SQLITE_CONSTRAINT);
  db.exec("BEGIN");
  EXPECT_EQ(db.error_of("INSERT INTO first VALUES (1, 54, 8)"), error);
  db.exec("COMMIT");
  EXPECT_EQ(db.rows("SELECT origin FROM foresee_tables WHERE name = 'first'"), "NULL");
  db.exec("INSERT INTO first VALUES (1, 53.94, 7.94), (2, 54, 8)");
  EXPECT_EQ(db.rows("SELECT origin FROM foresee_tables WHERE name = 'first'"), "53.9 7.9");
  EXPECT_EQ(db.rows("SELECT count(*) FROM w"),
            db.rows("SELECT count(*) FROM predictive_join(1000, 'ships', 100, 'first')"));
}

TEST_F(TableFrames, OfTwoWatchedTablesWithoutAnOrigin) {
  db.exec(
      "CREATE VIRTUAL TABLE zones USING moving_objects(id, lat, lon, r);"
      "CREATE VIRTUAL TABLE w USING predictive_watch(first, horizon = 1000, within = 100, other = zones);"
      "BEGIN; SAVEPOINT s; INSERT INTO zones VALUES (1, 10, 10, 5)");
  EXPECT_EQ(db.error_of("INSERT INTO first VALUES (1, 54, 8)"),
            "w: zones has origin '10 10', first has '54 8': their coordinates do not match; create first "
            "with origin = "
            "'10 10'");
  db.exec("ROLLBACK TO s; INSERT INTO first VALUES (1, 54, 8)");
  EXPECT_EQ(db.error_of("INSERT INTO zones VALUES (1, 10, 10, 5)"),
            "w: first has origin '54 8', zones has '10 10': their coordinates do not match; create zones "
            "with origin = "
            "'54 8'");
  db.exec("INSERT INTO zones VALUES (1, 54.01, 8.01, 2000); COMMIT");
  EXPECT_EQ(db.rows("SELECT a, b FROM w"), "1|1");
}

TEST(Frames, AnOriginOnTheDateLineHasTwoNames) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE a USING moving_objects(id, lat, lon, origin = '0 180');"
      "CREATE VIRTUAL TABLE b USING moving_objects(id, lat, lon, origin = '0 -180');"
      "INSERT INTO a VALUES(1, 0, 179.5), (2, 5, -179); INSERT INTO b VALUES(1, 0, 179.5), (2, 5, -179)");
  EXPECT_EQ(db.rows("SELECT sum(a.x = b.x AND a.y = b.y) FROM a JOIN b USING (id)"), "2");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(0, 'a', 1, 'b') ORDER BY a"), "1|1\n2|2");
}

}  // namespace
}  // namespace foresee::testing
