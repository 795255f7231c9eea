// contacts = 'all' in predictive_join and predictive_window: every contact, by every method, and each order.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct Contacts : ::testing::Test {
  Database db;

  /// Balls on bent paths, in a small space: about 60 of 240 touch more than once.
  void throw_balls() {
    db.exec("CREATE VIRTUAL TABLE balls USING moving_objects(id, t, x, y, vx, vy, ax, ay, r, until)");
    db.exec(
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 120) INSERT INTO balls "
        "SELECT i, i % 3, i * 37 % 100, i * 61 % 100, i * 7 % 11 - 5, i * 5 % 13 - 6, i * 3 % 5 * 0.25 - "
        "0.5, "
        "i * 11 % 7 * 0.25 - 0.75, 2 + i % 3, CASE WHEN i % 4 = 0 THEN 15 + i % 3 END FROM n");
  }

  std::string all(const std::string& rest, const std::string& columns = "a, b, t, t_end, dt, dt_end") {
    return db.rows("SELECT " + columns +
                   " FROM predictive_join(20, 'balls') WHERE contacts = 'all' AND now = 2 " + rest);
  }
};

TEST_F(Contacts, OfABallOnItsAscentAndDescent) {
  db.exec("CREATE VIRTUAL TABLE b USING moving_objects(id, x, vx, ax, r)");
  db.exec(
      "INSERT INTO b VALUES (1, 0, 16, -2, 1), (2, 41, 0, 0, 1)");  // 16 s - s^2 is 39 at 3, 43 at 8 -+ 4.58, 39 at 13
  EXPECT_EQ(
      db.rows("SELECT a, b, round(t, 3), round(t_end, 3) FROM predictive_join(20) WHERE contacts = 'all'"),
      "1|2|3.0|3.417\n1|2|12.583|13.0");
  EXPECT_EQ(
      db.rows("SELECT a, b, round(t, 3), round(t_end, 3) FROM predictive_join(20) WHERE contacts = 'first'"),
      "1|2|3.0|3.417");
  EXPECT_EQ(db.rows("SELECT contacts, count(*) FROM predictive_join(20)"), "first|1");
  EXPECT_EQ(db.rows("SELECT contacts, count(*) FROM predictive_join(20) WHERE contacts = NULL"), "first|1");
  EXPECT_EQ(
      db.rows(
          "SELECT id, round(t, 3), round(t_end, 3) FROM predictive_window(20, 'b', 40, 42) WHERE contacts = "
          "'all' AND id = 1"),
      "1|3.0|3.417\n1|12.583|13.0");
}

TEST_F(Contacts, AreTheSameByEveryMethod) {
  throw_balls();
  const std::string scan = all("AND method = 'scan' ORDER BY a, b, t");
  for (const char* method : {"auto", "grid", "tree", "gpcd"})
    EXPECT_EQ(all(std::string("AND method = '") + method + "' ORDER BY a, b, t"), scan) << method;
  db.exec("PRAGMA threads = 3");
  EXPECT_EQ(all("AND method = 'grid' ORDER BY a, b, t"), scan);
  EXPECT_NE(all("", "count(*) > count(DISTINCT a * 1000 + b)"), "0");
}

TEST_F(Contacts, TheFirstIsThatOfFirst) {
  throw_balls();
  EXPECT_EQ(
      all("GROUP BY a, b ORDER BY a, b", "a, b, min(t), t_end, dt, dt_end"),
      db.rows(
          "SELECT a, b, t, t_end, dt, dt_end FROM predictive_join(20, 'balls') WHERE now = 2 ORDER BY a, b"));
}

TEST_F(Contacts, ComeInOrder) {
  throw_balls();
  db.exec(
      "CREATE TABLE every AS SELECT a, b, t, t_end, dt, dt_end, d_cpa FROM predictive_join(20, 'balls') "
      "WHERE contacts = 'all' AND now = 2");
  const std::string columns = "a, b, t, t_end, dt, dt_end, d_cpa";
  for (const char* limit : {"", " LIMIT 7", " LIMIT 5 OFFSET 9"}) {
    EXPECT_EQ(all(std::string("ORDER BY t, a, b") + limit, columns),
              db.rows("SELECT " + columns + " FROM every ORDER BY t, a, b" + limit));
    EXPECT_EQ(all(std::string("ORDER BY dt") + limit, "dt"),
              db.rows(std::string("SELECT dt FROM every ORDER BY dt") + limit));
  }
  EXPECT_EQ(all("AND dt > 3 AND t < 9 ORDER BY t, a, b", columns),
            db.rows("SELECT " + columns + " FROM every WHERE dt > 3 AND t < 9 ORDER BY t, a, b"));
  EXPECT_EQ(all("AND a = 7 ORDER BY b, t", columns),
            db.rows("SELECT " + columns + " FROM every WHERE a = 7 ORDER BY b, t"));
  EXPECT_EQ(all("AND (a = 7 OR b = 7) ORDER BY a, b, t", columns),
            db.rows("SELECT " + columns + " FROM every WHERE a = 7 OR b = 7 ORDER BY a, b, t"));
  EXPECT_EQ(all("AND other = 'balls' AND a < b ORDER BY a, b, t", "a, b, t, t_end"),
            db.rows("SELECT a, b, t, t_end FROM every ORDER BY a, b, t"));
}

TEST_F(Contacts, OfTilesAreThoseOfTheWhole) {
  throw_balls();
  db.exec(
      "CREATE TABLE tiled AS SELECT a, b, t, t_end FROM (SELECT NULL AS x0, 40 AS x1 UNION ALL SELECT 40, "
      "NULL) AS tile, "
      "predictive_join(20, 'balls') AS j WHERE j.contacts = 'all' AND j.now = 2 AND j.own_x0 = tile.x0 AND "
      "j.own_x1 = tile.x1");
  EXPECT_EQ(db.rows("SELECT * FROM tiled ORDER BY a, b, t"), all("ORDER BY a, b, t", "a, b, t, t_end"));
}

TEST_F(Contacts, OfAWindow) {
  throw_balls();
  const auto window = [&](const std::string& rest) {
    return db.rows(
        "SELECT id, t, t_end, dt, dt_end FROM predictive_window(20, 'balls', 30, 60, 20, 70) WHERE now = 2 " +
        rest);
  };
  const std::string every = window("AND contacts = 'all' ORDER BY id, t");
  EXPECT_EQ(window("AND contacts = 'all' AND method = 'scan' ORDER BY id, t"), every);
  EXPECT_GT(every.size(), window("ORDER BY id").size());
  EXPECT_EQ(
      db.rows("SELECT id, min(t), t_end, dt, dt_end FROM predictive_window(20, 'balls', 30, 60, 20, 70) "
              "WHERE now = 2 AND contacts = 'all' GROUP BY id ORDER BY id"),
      window("ORDER BY id"));
}

TEST_F(Contacts, OnStraightPathsAreTheFirst) {
  db.exec("CREATE VIRTUAL TABLE s USING moving_objects(id, x, y, vx, vy, r)");
  db.exec(
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 200) INSERT INTO s "
      "SELECT i, i * 37 % 100, i * 61 % 100, i * 7 % 11 - 5, i * 5 % 13 - 6, 1 FROM n");
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end, dt, dt_end, d_cpa FROM predictive_join(20) WHERE contacts = "
                    "'all' ORDER BY a, b"),
            db.rows("SELECT a, b, t, t_end, dt, dt_end, d_cpa FROM predictive_join(20) ORDER BY a, b"));
}

/// Two contacts whose times no double tells apart are one row; others stay.
TEST_F(Contacts, ThatRoundToOneTimeAreOneRow) {
  db.exec("CREATE VIRTUAL TABLE b USING moving_objects(id, t, x, vx, ax, r)");
  db.exec(
      "INSERT INTO b VALUES (1, 9007199254740992.0, 0, 4, -8, 0), (2, 9007199254740992.0, 0.9375, 0, 0, 0)");
  EXPECT_EQ(
      db.rows("SELECT t = 9007199254740992.0, dt, dt_end FROM predictive_join(4) WHERE contacts = 'all'"),
      "1|0.375|0.625");
  EXPECT_EQ(db.rows("SELECT dt, dt_end FROM predictive_join(4)"), "0.375|0.375");
}

TEST_F(Contacts, AreRefusedWhereTheyAreNotDefined) {
  db.exec("CREATE VIRTUAL TABLE hulls USING moving_objects(id, x, y, vx, vy, shape)");
  for (const char* function : {"predictive_join", "predictive_window"}) {
    const std::string call = std::string("SELECT * FROM ") + function + "(20, 'hulls') WHERE contacts = ";
    EXPECT_EQ(db.error_of(call + "'all'"),
              std::string(function) + ": contacts = 'all' is not for outlines and meshes: leave it out");
    EXPECT_EQ(db.error_of(call + "'last'"),
              std::string(function) + ": contacts must be 'first' or 'all', not 'last'");
    EXPECT_EQ(db.error_of(call + "2"), std::string(function) + ": contacts must be 'first' or 'all', not 2");
    EXPECT_EQ(db.error_of(call + "'first'"), "");
  }
}

}  // namespace
}  // namespace foresee::testing
