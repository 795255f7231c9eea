// predictive_track in SQL, and the hidden input columns of all functions where an input was left out.
#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

struct TrackTest : Harbour {};

TEST_F(TrackTest, GivesTheRowsOfPositionForEachTime) {
  EXPECT_EQ(db.rows("SELECT id, t, x, y, z FROM predictive_track(0, 5, 2) WHERE id < 3"),
            "1|0.0|0.0|0.0|NULL\n2|0.0|10.0|0.0|NULL\n1|2.0|2.0|0.0|NULL\n2|2.0|8.0|0.0|NULL\n"
            "1|4.0|4.0|0.0|NULL\n2|4.0|6.0|0.0|NULL\n1|5.0|5.0|0.0|NULL\n2|5.0|5.0|0.0|NULL");
  db.exec("CREATE TABLE moments(s); INSERT INTO moments VALUES (0.0), (0.375), (0.75), (1.0)");
  EXPECT_EQ(db.rows("SELECT t, id, x, y FROM predictive_track(0, 1, 0.375, 'ships') ORDER BY t, id"),
            db.rows("SELECT s, id, x, y FROM moments, predictive_position(s, 'ships') ORDER BY s, id"));
}

TEST_F(TrackTest, FindsIds) {
  EXPECT_EQ(db.rows("SELECT t, x FROM predictive_track(0, 2, 1, 'ships') WHERE id = 2"),
            "0.0|10.0\n1.0|9.0\n2.0|8.0");
  EXPECT_EQ(db.rows("SELECT id, t FROM predictive_track(0, 1, 1) WHERE id IN (3, 1) ORDER BY t, id"),
            "1|0.0\n3|0.0\n1|1.0\n3|1.0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_track(0, 1, 1) WHERE id = 1 OR id = 2"), "4");
}

TEST_F(TrackTest, ComesByTimeThenIdWithoutSorting) {
  const std::string plan =
      db.rows("EXPLAIN QUERY PLAN SELECT * FROM predictive_track(0, 5, 2, 'ships') ORDER BY t, id");
  EXPECT_EQ(plan.find("TEMP B-TREE"), std::string::npos) << plan;
  EXPECT_EQ(db.rows("SELECT id FROM predictive_track(0, 5, 2) ORDER BY t DESC, id DESC LIMIT 1"), "3");
}

TEST_F(TrackTest, SaysWhatIsWrong) {
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_track(0, 1)"),
            "predictive_track: step is missing or NULL: write predictive_track(t0, t1, step, tbl, schema)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_track(0, 1, 0)"),
            "predictive_track: step must be a finite number > 0, not 0");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_track(2, 1, 1)"),
            "predictive_track: t0 must not be greater than t1: t0 is 2, t1 is 1");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_track(0, 1, 1e-300)"),
            "predictive_track: step is too small: a track has fewer than 2^53 times");
}

TEST_F(TrackTest, FeedsItsOwnTableAndEnds) {
  db.exec("INSERT INTO ships SELECT id + 10 * t, t, x, y, 0, 0, 0, 'copy' FROM predictive_track(1, 2, 1)");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships WHERE id > 10"), "6");
}

TEST_F(TrackTest, IsStoppedByAnInterruptEvenWithoutObjects) {
  int calls = 0;
  sqlite3_progress_handler(
      db.handle(), 1, [](void* count) { return ++*static_cast<int*>(count) > 500 ? 1 : 0; }, &calls);
  EXPECT_EQ(db.code_of("SELECT * FROM predictive_track(-1e15, -1, 1, 'ships')"), SQLITE_INTERRUPT);
  sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
}

struct UsedInputsTest : Harbour {};

TEST_F(UsedInputsTest, ReadBackWhereTheyWereLeftOut) {
  db.exec("UPDATE ships SET t = 2 WHERE id = 3");
  EXPECT_EQ(db.rows("SELECT h, tbl, within, now, method, schema FROM predictive_join(20)"),
            "20|ships|0.0|2.0|auto|main");
  EXPECT_EQ(db.rows("SELECT tbl, now, method, schema, wvx FROM predictive_window(20) WHERE id = 1"),
            "ships|2.0|auto|main|0.0");
  EXPECT_EQ(db.rows("SELECT tbl, now, method, schema, qvy FROM predictive_nearest(20, NULL, 1, 0, 0)"),
            "ships|2.0|auto|main|0.0");
  EXPECT_EQ(db.rows("SELECT at, tbl, schema FROM predictive_position(20) WHERE id = 1"), "20|ships|main");
  EXPECT_EQ(db.rows("SELECT DISTINCT tbl, now FROM predictive_explain(20)"), "ships|2.0");
}

// Where SQLite keeps a comparison to itself, an input that was left out would be compared, and every row lost.
TEST_F(UsedInputsTest, WithoutAValueAreNotReadWhereTheyWereLeftOut) {
  const auto refusal = [](const std::string& function, const std::string& input) {
    return function + ": " + input + " is read, but has no value: write " + input +
           " = ... with AND; inside OR or an expression, or in WHERE on a LEFT JOIN, it does not reach the "
           "function";
  };
  EXPECT_EQ(db.error_of("SELECT id FROM predictive_nearest(20, 'ships', 3, 0, 0) WHERE mask = 2 OR id = 3"),
            refusal("predictive_nearest", "mask"));
  EXPECT_EQ(db.error_of("SELECT s.id FROM ships s LEFT JOIN predictive_nearest(20, 'ships', 3, 0, 0) n "
                        "ON n.id = s.id WHERE n.mask = 2"),
            refusal("predictive_nearest", "mask"));
  EXPECT_EQ(db.error_of("SELECT id FROM ships LEFT JOIN predictive_join(20, 'ships') j ON j.a = id "
                        "WHERE j.within_z = 2"),
            refusal("predictive_join", "within_z"));
  EXPECT_EQ(db.error_of("SELECT id FROM predictive_sweep(20, 'ships') WHERE +within_z = 2"),
            refusal("predictive_sweep", "within_z"));
  EXPECT_EQ(db.error_of("SELECT k FROM predictive_avoid(20, 'ships', 1, 0) WHERE +how = 'turn'"),
            refusal("predictive_avoid", "how"));
  for (const char* list : {"foresee_tables", "predictive_watches"})
    EXPECT_EQ(
        db.error_of(std::string("SELECT name FROM ") + list + " WHERE schema_name = 'main' OR name = 'x'"),
        refusal(list, "schema_name"));
  EXPECT_EQ(db.rows("SELECT x0, id FROM predictive_window(20, 'ships', 0) WHERE id = 1"), "0|1");
  EXPECT_EQ(db.error_of("SELECT x1 FROM predictive_window(20, 'ships', 0)"),
            refusal("predictive_window", "x1"));
}

TEST_F(UsedInputsTest, ReadBackAsGivenWhereTheyWere) {
  EXPECT_EQ(
      db.rows("SELECT tbl, now, method, within FROM predictive_join('20', 'SHIPS', 0, NULL, '1', 'tree')"),
      "SHIPS|1|tree|0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(20) WHERE method IN ('auto', 'tree') AND "
                    "tbl = 'Ships'"),
            "2");
}

// A text is the same whatever the encoding of the database, and whether it was given or left out.
TEST(UsedInputs, AreTheSameCallInUtf16) {
  Database db;
  db.exec(
      "PRAGMA encoding = 'UTF-16le'; CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, r);"
      "INSERT INTO ships WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 4000) "
      "SELECT i, 3 * i, 0, 2 FROM n");
  const std::string sides =
      "SELECT a, b FROM predictive_join(5) WHERE (a = 7 AND tbl = 'ships') OR a = 7 OR b = 7";
  EXPECT_NE(db.rows("EXPLAIN QUERY PLAN " + sides).find("MULTI-INDEX OR"), std::string::npos);
  EXPECT_EQ(db.rows(sides + " ORDER BY a"), "6|7\n7|8");
}

TEST_F(UsedInputsTest, LoseNoRowAndRepeatNone) {
  const std::string all = db.rows("SELECT a, b FROM predictive_join(20)");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(20) WHERE a = 1 OR t < 100"), all);
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(20) WHERE b = 2 OR a = 1 OR t > -1"), all);
  EXPECT_EQ(
      db.rows("SELECT w.id FROM predictive_join(20) j, predictive_window(20) w WHERE w.now = +j.now AND "
              "w.tbl = +j.tbl AND w.id = j.a"),
      "1");
}

}  // namespace
}  // namespace foresee::testing
