// predictive_nearest in SQL: inputs by position, by name and by lateral columns, errors, plans, snapshots.
#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

struct NearestInSql : Harbour {
  std::string rows_of(const std::string& call) { return db.rows("SELECT * FROM " + call + " ORDER BY rank"); }
  std::string error(const std::string& call) { return db.error_of("SELECT * FROM " + call); }
};

TEST_F(NearestInSql, RanksByTheClosestApproachOfTheCentres) {
  // Seen from (7, 3): both pass below at distance 3, Bob at 3 and Ada at 7.
  EXPECT_EQ(rows_of("predictive_nearest(100, 'ships', 2, 7, 3)"), "1|1|3.0|7.0|7.0\n2|2|3.0|3.0|3.0");
  EXPECT_EQ(rows_of("predictive_nearest(100, 'ships', 1, 7, 3)"), "1|1|3.0|7.0|7.0");
  EXPECT_EQ(rows_of("predictive_nearest(0, 'ships', 1, 7, 4)"), "2|1|5.0|0.0|0.0");
  EXPECT_EQ(rows_of("predictive_nearest(0, 'ships', 1, 7, 4, NULL, 4)"), "2|1|4.123105625617661|4.0|0.0");
}

TEST_F(NearestInSql, GivesAllWhenKIsLarge) {
  EXPECT_EQ(db.rows("SELECT id, rank FROM predictive_nearest(0, 'ships', 100, 0, 0) ORDER BY rank"),
            "1|1\n2|2\n3|3");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_nearest(0, 'ships', 9223372036854774784.0, 0, 0)"), "3");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_nearest(0, 'ships', '2', 0, 0)"), "1\n2");
}

TEST_F(NearestInSql, FollowsAMovingPoint) {
  EXPECT_EQ(rows_of("predictive_nearest(8, 'ships', 1, 0, 4, NULL, 0, 1, -0.5)"), "1|1|0.0|8.0|8.0");
  EXPECT_EQ(
      db.rows("SELECT id, distance FROM predictive_nearest WHERE h = 4 AND k = 1 AND x = 10 AND y = 1 AND "
              "qvx = -1"),
      "2|1.0");
}

TEST_F(NearestInSql, LeavesOutObjectsThatDoNotExist) {
  db.exec(
      "CREATE VIRTUAL TABLE shifts USING moving_objects(id, t, x, until);"
      "INSERT INTO shifts VALUES (1, 0, 1, 5), (2, 4, 2, 9), (3, 8, 3, NULL)");
  EXPECT_EQ(db.rows("SELECT id, distance, t FROM predictive_nearest(2, 'shifts', 9, 0) WHERE now = 5"),
            "1|1.0|5.0\n2|2.0|5.0");
  EXPECT_EQ(db.rows("SELECT id, t FROM predictive_nearest(3, 'shifts', 9, 0) WHERE now = 6"), "2|6.0\n3|8.0");
}

TEST_F(NearestInSql, GoesOverTheRowsOfAnotherTable) {
  db.exec("CREATE TABLE depots(name, x, y); INSERT INTO depots VALUES ('east', 12, 0), ('north', 0, 90)");
  EXPECT_EQ(
      db.rows(
          "SELECT d.name, s.name, n.distance FROM depots d, predictive_nearest(0, 'ships', 1, d.x, d.y) n "
          "JOIN ships s ON s.id = n.id ORDER BY 1"),
      "east|Bob|2.0\nnorth|Cid|9.0");
  const std::string steps = db.rows(
      "EXPLAIN QUERY PLAN SELECT * FROM ships s, predictive_nearest(0, 'ships', 1, d.x, d.y) n, depots d "
      "WHERE s.id "
      "= n.id");
  EXPECT_LT(steps.find("SCAN d"), steps.find("SCAN n")) << steps;
  EXPECT_LT(steps.find("SCAN n"), steps.find("SCAN s")) << steps;
}

TEST_F(NearestInSql, IsUnchangedUnderALoopThatWrites) {
  db.exec(
      "CREATE TABLE seen(id, d); CREATE TRIGGER move AFTER INSERT ON seen BEGIN "
      "UPDATE ships SET x = 1000, y = 1000; END;"
      "INSERT INTO seen SELECT id, distance FROM predictive_nearest(0, 'ships', 3, 0, 0)");
  EXPECT_EQ(db.rows("SELECT * FROM seen"), "1|0.0\n2|10.0\n3|99.0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_nearest(0, 'ships', 9, 1000, 1000) WHERE distance = 0"),
            "3");
}

TEST_F(NearestInSql, SaysWhatToWrite) {
  const std::string usage =
      "write predictive_nearest(h, tbl, k, x, y, z, now, qvx, qvy, qvz, method, schema, lat, lon, mask)";
  const std::string name = "predictive_nearest";
  EXPECT_EQ(error(name), "predictive_nearest: h is missing or NULL: " + usage);
  EXPECT_EQ(error(name + "(1)"), "predictive_nearest: k is missing or NULL: " + usage);
  EXPECT_EQ(error(name + "(1, 'ships', 0, 0, 0)"),
            "predictive_nearest: k must be a whole number >= 1, not 0");
  EXPECT_EQ(error(name + "(1, 'ships', 1.5, 0, 0)"), "predictive_nearest: k must be a whole number, not 1.5");
  EXPECT_EQ(error(name + "(1, 'ships', 9223372036854775807, 0, 0)"), "");
  EXPECT_EQ(error(name + "(1, 'ships', '9223372036854775807', 0, 0)"), "");
  EXPECT_EQ(error(name + "(1, 'ships', 1e19, 0, 0)"),
            "predictive_nearest: k must be a whole number, not 1e+19");
  EXPECT_EQ(error(name + "(1, 'ships', 1)"),
            "predictive_nearest: ships has 2 axes (x, y): x is missing; give one number for each axis");
  EXPECT_EQ(error(name + "(1, 'ships', 1, 0, 0, 0)"),
            "predictive_nearest: ships has 2 axes (x, y): leave out z");
  EXPECT_EQ(error(name + "(1, 'ships', 1, 0, 9e999)"),
            "predictive_nearest: y must be a finite number, not inf");
  EXPECT_EQ(error(name + "(-1, 'ships', 1, 0, 0)"),
            "predictive_nearest: h must be a finite number >= 0, not -1");
  EXPECT_EQ(error(name + "(1, 'boats', 1, 0, 0)"),
            "predictive_nearest: no such table: 'boats' (moving_objects tables here: 'ships')");
  EXPECT_NE(error(name + "(1, 'ships', 1, 0, 0) WHERE method = 'grid'"), "");
}

TEST_F(NearestInSql, AnEmptyTableGivesNoRows) {
  db.exec("DELETE FROM ships");
  EXPECT_EQ(rows_of("predictive_nearest(9, 'ships', 5, 0, 0)"), "");
}

}  // namespace
}  // namespace foresee::testing
