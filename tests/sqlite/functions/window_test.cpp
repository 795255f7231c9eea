// predictive_window in SQL: inputs by position, by name and by lateral columns, errors, plans, snapshots.
#include "sqlite/harbour_scene.h"
#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

struct WindowInSql : Harbour {
  std::string rows_of(const std::string& call) { return db.rows("SELECT * FROM " + call + " ORDER BY id"); }
  std::string error(const std::string& call) { return db.error_of("SELECT * FROM " + call); }
  std::string plan(const std::string& sql) { return db.rows("EXPLAIN QUERY PLAN " + sql); }
};

TEST_F(WindowInSql, GivesTheObjectsThatTouchItAndTheirTimes) {
  // Ada's side reaches x = 6 at 3, her stern leaves x = 8 at 11; Bob's bow comes at 1, he is gone at 5.
  EXPECT_EQ(rows_of("predictive_window(100, 'ships', 6, 8, -1, 1)"),
            "1|3.0|11.0|3.0|11.0\n2|1.0|5.0|1.0|5.0");
  EXPECT_EQ(rows_of("predictive_window(4, 'ships', 6, 8, -1, 1)"), "1|3.0|4.0|3.0|4.0\n2|1.0|4.0|1.0|4.0");
  EXPECT_EQ(rows_of("predictive_window(0, 'ships', 6, 8, -1, 1, NULL, NULL, 3)"),
            "1|3.0|3.0|0.0|0.0\n2|3.0|3.0|0.0|0.0");
  EXPECT_EQ(rows_of("predictive_window(100, 'ships', 6, 8, 90, 95)"), "");
}

TEST_F(WindowInSql, TakesBoundsLeftOutAsNone) {
  EXPECT_EQ(rows_of("predictive_window(0)"), "1|0.0|0.0|0.0|0.0\n2|0.0|0.0|0.0|0.0\n3|0.0|0.0|0.0|0.0");
  EXPECT_EQ(rows_of("predictive_window(9, 'ships', NULL, NULL, 50)"), "3|0.0|9.0|0.0|9.0");
  EXPECT_EQ(rows_of("predictive_window(9, 'ships', -9e999, 9e999, 50, 9e999)"), "3|0.0|9.0|0.0|9.0");
  EXPECT_EQ(rows_of("predictive_window(9) WHERE y0 = 50 AND tbl = 'ships'"), "3|0.0|9.0|0.0|9.0");
}

TEST_F(WindowInSql, MovesWithItsVelocityFromNowOn) {
  // The window moves with Ada, her side at its edge.
  EXPECT_EQ(rows_of("predictive_window(50, 'ships', 3, 4, -1, 1, NULL, NULL, 0, 1)"),
            "1|0.0|50.0|0.0|50.0\n2|2.5|4.0|2.5|4.0");
  EXPECT_EQ(
      db.rows("SELECT id, t, dt FROM predictive_window WHERE h = 50 AND x0 = 5 AND x1 = 6 AND y0 = -1 AND "
              "y1 = 1 AND now = 2 AND wvx = 1 ORDER BY id"),
      "1|2.0|0.0\n2|2.5|0.5");
}

TEST_F(WindowInSql, GoesOverTheRowsOfAnotherTable) {
  db.exec(
      "CREATE TABLE zones(name, x0, x1, y0, y1);"
      "INSERT INTO zones VALUES ('bar', 6, 8, -1, 1), ('roads', -5, 5, 90, NULL), ('lock', 50, 51, -1, 1)");
  EXPECT_EQ(
      db.rows("SELECT z.name, w.id, w.dt FROM zones z, predictive_window(30, 'ships', z.x0, z.x1, z.y0, "
              "z.y1) w ORDER BY 1, 2"),
      "bar|1|3.0\nbar|2|1.0\nroads|3|0.0");
  EXPECT_EQ(db.rows("SELECT z.name, s.name FROM zones z LEFT JOIN predictive_window(30, 'ships', z.x0, z.x1, "
                    "z.y0, z.y1) w LEFT JOIN ships s ON s.id = w.id ORDER BY 1, 2"),
            "bar|Ada\nbar|Bob\nlock|NULL\nroads|Cid");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window WHERE h = 30 AND x0 IN (6, 7)"), "4");
}

TEST_F(WindowInSql, PlansTheCheapSideFirst) {
  db.exec("CREATE TABLE owners(ship INTEGER PRIMARY KEY, owner); CREATE TABLE zones(x0, x1)");
  const std::string steps = plan(
      "SELECT * FROM owners o JOIN ships s ON s.id = o.ship JOIN predictive_window(30, 'ships', 6, 8) w ON "
      "w.id = s.id");
  EXPECT_LT(steps.find("SCAN w"), steps.find("ships")) << steps;
  EXPECT_LT(steps.find("SCAN w"), steps.find("SEARCH o")) << steps;
  const std::string lateral =
      plan("SELECT * FROM ships s, predictive_window(30, 'ships', z.x0, z.x1) w, zones z WHERE s.id = w.id");
  EXPECT_LT(lateral.find("SCAN z"), lateral.find("SCAN w")) << lateral;
  EXPECT_LT(lateral.find("SCAN w"), lateral.find("SCAN s")) << lateral;
}

TEST_F(WindowInSql, ExaminesOnlyTheObjectOfAGivenId) {
  const std::string steps =
      plan("SELECT * FROM ships s LEFT JOIN predictive_window(30, 'ships', 6, 8) w ON w.id = s.id");
  EXPECT_NE(steps.find("A="), std::string::npos) << steps;
  EXPECT_EQ(db.rows("SELECT s.name, w.dt, w.dt_end FROM ships s LEFT JOIN predictive_window(30, 'ships', 6, "
                    "8, -1, 1) w "
                    "ON w.id = s.id ORDER BY s.id"),
            "Ada|3.0|11.0\nBob|1.0|5.0\nCid|NULL|NULL");
  EXPECT_EQ(rows_of("predictive_window(100, 'ships', 6, 8, -1, 1) WHERE id = 2"), "2|1.0|5.0|1.0|5.0");
  EXPECT_EQ(rows_of("predictive_window(100, 'ships', 6, 8, -1, 1) WHERE id = '2'"), "2|1.0|5.0|1.0|5.0");
  for (const char* none : {"3", "99", "2.5", "NULL", "'x'"})
    EXPECT_EQ(rows_of(std::string("predictive_window(100, 'ships', 6, 8, -1, 1) WHERE id = ") + none), "")
        << none;
  EXPECT_EQ(db.rows("SELECT now FROM predictive_window(1, 'ships') WHERE id = 1"),
            db.rows("SELECT now FROM predictive_window(1, 'ships') WHERE +id = 1"));
  EXPECT_EQ(error("predictive_window(-1, 'ships') WHERE id = 1"), error("predictive_window(-1, 'ships')"));
  EXPECT_EQ(error("predictive_window(1, 'ships') WHERE id = 1 AND z0 = 2"),
            error("predictive_window(1, 'ships') WHERE z0 = 2"));
}

TEST_F(WindowInSql, KeepsTheRowsOfTwoCallsApart) {
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window WHERE (h = 0 AND x0 = 6) OR (h = 9 AND x0 = 6)"),
            db.rows("SELECT (SELECT count(*) FROM predictive_window(0, 'ships', 6)) + "
                    "(SELECT count(*) FROM predictive_window(9, 'ships', 6))"));
  EXPECT_EQ(db.rows("SELECT id FROM predictive_window(9) WHERE id = 2 OR id = 3 ORDER BY id"), "2\n3");
}

TEST_F(WindowInSql, IsUnchangedUnderALoopThatWrites) {
  db.exec(
      "CREATE TABLE seen(id, t); CREATE TRIGGER move AFTER INSERT ON seen BEGIN "
      "UPDATE ships SET x = 1000, y = 1000 WHERE id >= new.id; END;"
      "INSERT INTO seen SELECT id, t_end FROM predictive_window(9, 'ships')");
  EXPECT_EQ(db.rows("SELECT count(*), min(t), max(t) FROM seen"), "3|9.0|9.0");
  EXPECT_EQ(rows_of("predictive_window(9, 'ships', 0, 100)"), "");
  db.exec("INSERT INTO ships SELECT id + 100, t, 0, 0, 0, 0, 0, 'echo' FROM predictive_window(9, 'ships')");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "6");
}

TEST_F(WindowInSql, SaysWhatToWrite) {
  const std::string name = "predictive_window";
  EXPECT_EQ(
      error(name),
      "predictive_window: h is missing or NULL: write predictive_window(h, tbl, x0, x1, y0, y1, z0, z1, "
      "now, wvx, wvy, wvz, method, schema, zone, mask, contacts)");
  EXPECT_EQ(error(name + "(-1)"), "predictive_window: h must be a finite number >= 0, not -1");
  EXPECT_EQ(error(name + "(1, 'boats')"),
            "predictive_window: no such table: 'boats' (moving_objects tables here: 'ships')");
  EXPECT_EQ(error(name + "(1, 'ships', 5, 3)"),
            "predictive_window: x0 must not be greater than x1: x0 is 5, x1 is 3");
  EXPECT_EQ(error(name + "(1, 'ships', 9e999)"),
            "predictive_window: x0 must be a finite number, or left out for no bound, not inf");
  EXPECT_EQ(error(name + "(1, 'ships', 'west')"),
            "predictive_window: x0 must be a number, not 'west': write predictive_window(h, tbl, x0, x1, y0, "
            "...)");
  EXPECT_EQ(error(name + "(1) WHERE z0 = 5"), "predictive_window: ships has 2 axes (x, y): leave out z0");
  EXPECT_EQ(error(name + "(1) WHERE wvz = 5"), "predictive_window: ships has 2 axes (x, y): leave out wvz");
  EXPECT_EQ(error(name + "(1) WHERE wvx = 9e999"), "predictive_window: wvx must be a finite number, not inf");
  EXPECT_EQ(error(name + "(1) WHERE now = 9e999"), "predictive_window: now must be a finite number, not inf");
  EXPECT_NE(error(name + "(1) WHERE method = 'grid'"), "");
}

TEST_F(WindowInSql, AnEmptyTableGivesNoRows) {
  db.exec("DELETE FROM ships");
  EXPECT_EQ(rows_of("predictive_window(9, 'ships', 0, 1)"), "");
}

TEST_F(WindowInSql, IsStoppedByAnInterrupt) {
  int calls = 0;
  sqlite3_progress_handler(
      db.handle(), 1, [](void* count) { return ++*static_cast<int*>(count) > 2000 ? 1 : 0; }, &calls);
  EXPECT_EQ(db.code_of("WITH RECURSIVE i(n) AS (VALUES (1) UNION ALL SELECT n + 1 FROM i) "
                       "SELECT count(*) FROM i, predictive_window(9, 'ships', n)"),
            SQLITE_INTERRUPT);
  sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
}

}  // namespace
}  // namespace foresee::testing
