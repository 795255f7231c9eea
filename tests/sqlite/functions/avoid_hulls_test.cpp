// predictive_avoid for outlines, by hand: a hull that rotates with its course, gaps, holes, quays, and
// outlines that cannot be rotated.
#if defined(__linux__)
#include <sys/resource.h>
#endif

#include "sanitized.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

/// The peak memory of this process, in KiB; 0 where it is not known.
long max_memory() {
#if defined(__linux__)
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
#else
  return 0;
#endif
}

struct AvoidHulls : ::testing::Test {
  /// A hull of 2 by 12 that moves north at 5, and the obstacles.
  void make(const std::string& heading, const std::string& others) {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, shape" + heading +
        ", +name); INSERT INTO ships VALUES (1, 0, 0, 0, 0, 5, 'POLYGON((-1 -6, 1 -6, 1 6, -1 6, -1 -6))'" +
        (heading.empty() ? "" : ", 0") + ", 'Anna');");
    db.exec("CREATE VIRTUAL TABLE quays USING moving_objects(id, x, y, shape); INSERT INTO quays VALUES " +
            others);
  }
  std::string avoid(const std::string& more) {
    return db.rows(
        "SELECT clear, round(k_from, 4), round(k_to, 4), below, above, below_tbl FROM "
        "predictive_avoid(10, 'ships', 1, 0, " +
        more + ")");
  }

  Database db;
};

/// The quay is 2 to the right of the path. Turned to port, the stern swings to it at asin(2 / |(1, 6)|) -
/// atan(1 / 6).
TEST_F(AvoidHulls, TurnWithTheirCourse) {
  make(", heading", "(1, 0, 0, 'POLYGON((2 -50, 3 -50, 3 50, 2 50, 2 -50))')");
  EXPECT_EQ(avoid("'turn', -90, 0, NULL, 'quays'"), "0|-90.0|-9.7335|1|1|quays\n1|-9.7335|0.0|1|NULL|quays");
  EXPECT_EQ(
      db.rows("SELECT heading, round(vx, 6), x FROM predictive_avoid(10, 'ships', 1, 0, 'turn', -9, -9)"),
      "-9.0|-0.782172|0.0");
}

TEST_F(AvoidHulls, WithoutAHeadingKeepTheirs) {
  make("", "(1, 0, 0, 'POLYGON((2 -50, 3 -50, 3 50, 2 50, 2 -50))')");
  EXPECT_EQ(avoid("'turn', -90, 0, NULL, 'quays'"), "1|-90.0|0.0|NULL|NULL|NULL");
}

TEST_F(AvoidHulls, PassThroughAGapThatTheirBoxesDoNot) {
  make(", heading",
       "(1, 0, 30, 'POLYGON((-50 0, -1.5 0, -1.5 4, -50 4, -50 0))'), (2, 0, 30, 'POLYGON((1.5 0, 50 0, 50 "
       "4, 1.5 4, 1.5 0))')");
  EXPECT_EQ(avoid("'turn', -45, 45, NULL, 'quays'"),
            "0|-45.0|-0.8423|1|1|quays\n1|-0.8423|0.8423|1|2|quays\n0|0.8423|45.0|2|2|quays");
  EXPECT_EQ(avoid("'speed', -5, 5, NULL, 'quays'"), "1|-5.0|5.0|NULL|NULL|NULL");
}

/// Inside a lock: an object that keeps clear of the outline around it remains inside.
TEST_F(AvoidHulls, KeepWithinAHole) {
  make(", heading",
       "(1, 0, 0, 'POLYGON((-20 -20, 20 -20, 20 60, -20 60, -20 -20), (-10 -10, 10 -10, 10 54, -10 54, -10 "
       "-10))')");
  EXPECT_EQ(avoid("'speed', -5, 5, NULL, 'quays'"), "1|-5.0|-0.2|NULL|1|NULL\n0|-0.2|5.0|1|1|quays");
}

/// Moored alongside a quay of two parts: away from it, not along it.
TEST_F(AvoidHulls, PartFromWhatTheyTouch) {
  make("", "(1, 10, 0, 'POLYGON((-9 -10, -1 -10, -1 10, -5 10, -5 0, -9 0, -9 -10))')");
  EXPECT_EQ(avoid("'turn', -180, 0, NULL, 'quays'"),
            "0|-180.0|-180.0|1|NULL|quays\n1|-180.0|-0.0|NULL|NULL|NULL\n0|-0.0|0.0|NULL|1|NULL");
}

TEST_F(AvoidHulls, TurnOnTheSpot) {
  make(", heading", "(1, 4, 0, 'POLYGON((-1 -1, 1 -1, 1 1, -1 1, -1 -1))')");
  db.exec("UPDATE ships SET vy = 0");
  EXPECT_EQ(
      db.rows("SELECT count(*) > 3, max(clear), min(clear) FROM predictive_avoid(10, 'ships', 1, 0, 'turn', "
              "-180, 180, NULL, 'quays')"),
      "1|1|0");
}

TEST_F(AvoidHulls, ThatCannotBeTurnedAreNotClear) {
  make(", heading", "(1, 900, 0, 'POLYGON((-1 -1, 1 -1, 1 1, -1 1, -1 -1))')");
  db.exec("UPDATE ships SET shape = 'POLYGON((0 0, 9 0, 9 9, 0 9, 0 0), (0 4, 3 3, 3 5, 0 4))'");
  EXPECT_NE(db.error_of("UPDATE ships SET heading = 30"), "");
  EXPECT_EQ(avoid("'turn', 30, 30"), "0|30.0|30.0|NULL|NULL|NULL");
  EXPECT_EQ(avoid("'turn', 90, 90"), "1|90.0|90.0|NULL|NULL|NULL");
}

TEST_F(AvoidHulls, AreInterrupted) {
  make(", heading", "(1, 0, 30, 'POLYGON((-50 0, -1.5 0, -1.5 4, -50 4, -50 0))')");
  sqlite3_progress_handler(
      db.handle(), 1, [](void*) { return 1; }, nullptr);
  EXPECT_NE(db.error_of("SELECT * FROM predictive_avoid(10, 'ships', 1, 0, 'turn', -45, 45, NULL, 'quays')"),
            "");
  sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
}

TEST_F(AvoidHulls, OfTrianglesInSpaceAreRefused) {
  db.exec("CREATE VIRTUAL TABLE rocks USING moving_objects(id, x, y, z, vx, vy, vz, shape)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_avoid(60, 'rocks', 1)"),
            "predictive_avoid: meshes of rocks are not examined: declare hz beside shape for prisms, or "
            "query a table "
            "with r around each");
}

/// At now the position is rounded, and touches the hull around it, which the stored row just left. A ship
/// that turns touches already, also in a query of one change.
TEST_F(AvoidHulls, TouchAlreadyWhatTheirRoundedPlaceTouches) {
  db.exec(
      "CREATE VIRTUAL TABLE boats USING moving_objects(id, t, x, y, z, vx, vy, vz, shape, heading, hz);"
      "INSERT INTO boats VALUES"
      "  (1, 0, 4, 21, -3300000, 2, 2, 1.999999999998181, 'POLYGON((-6 -6, 6 -6, 6 6, -6 6, -6 -6))', 0, 0),"
      "  (2, 0, 0, 0, -3299999, 2, 2, 2, 'POLYGON((-40 -60, 40 -60, 40 60, -40 60, -40 -60))', 0, 1)");
  const std::string queried = "SELECT clear FROM predictive_avoid(1, 'boats', 1, 0, 'turn', ";
  EXPECT_EQ(db.rows(queried + "-5, -1, 1)"), "1");
  EXPECT_EQ(db.rows(queried + "-2, -2, 1)"), "1");
  EXPECT_EQ(db.rows(queried + "2, 2, 1)"), "0");
}

/// Shapes of many pieces, of which each pair is undecided for some turns: few of the pairs are kept in
/// memory.
TEST_F(AvoidHulls, OfManyPiecesTakeLittleMemory) {
  db.exec(
      "CREATE VIRTUAL TABLE stars USING moving_objects(id, x, y, vx, vy, shape, heading);"
      "WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 800),"
      "  star(corners) AS (SELECT group_concat(printf('%.17g %.17g',"
      "    iif(i % 2, 50, 25) * cos(pi() * (i % 800) / 400), iif(i % 2, 50, 25) * sin(pi() * (i % 800) / "
      "400)),"
      "    ', ') FROM n)"
      "  INSERT INTO stars SELECT id, 400 * id, 40 * id, 1 - 2 * id, 0, 'POLYGON((' || corners || '))', 3 * "
      "id"
      "    FROM star, (SELECT 0 AS id UNION ALL SELECT 1)");
  const long before = max_memory();
  EXPECT_EQ(db.rows("SELECT count(*), sum(clear) FROM predictive_avoid(600, 'stars', 0, 0, 'turn')"), "3|2");
  if (!sanitized) {
    EXPECT_LT(max_memory() - before, 40 << 10);
  }
}

/// Two flat objects that pass the same height at one time touch without depth for many rates of climb. A
/// guess of the first of these is noise. (0.2.0 split the range at each guess until the stack overflowed.)
TEST_F(AvoidHulls, FlatOnesThatPassOneHeightTouchWithoutDepth) {
  db.exec(
      "CREATE VIRTUAL TABLE kites USING moving_objects(id, t, x, y, z, vx, vy, vz, shape, heading, hz);"
      "INSERT INTO kites VALUES (1, 0, -14.617, 2.496613979412, 3.9, 0, 0, -1, 'POLYGON((10 0, 12 0, 11 3, "
      "10 0))', 37.5, 0);"
      "CREATE VIRTUAL TABLE rings USING moving_objects(id, t, x, y, z, vx, vy, vz, r, hz);"
      "INSERT INTO rings VALUES (2, 2.5, 1.386740452396, -0.745925144678, 4.4, -1.208, 0, -1, 1, 0)");
  EXPECT_EQ(db.rows("SELECT clear, round(k_from, 6), round(k_to, 6) FROM "
                    "predictive_avoid(30, 'kites', 1, 1, 'climb', -2, 2, 3.3, 'rings', NULL, 'ignore')"),
            "1|-2.0|0.56041\n0|0.56041|1.295738\n1|1.295738|2.0");
}

}  // namespace
}  // namespace foresee::testing
