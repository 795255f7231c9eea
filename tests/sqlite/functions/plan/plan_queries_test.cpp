// Functions on tables with plans: one leg is a plain row, bit for bit, and legs as rows, merged, are plans.
#include <algorithm>

#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

/// Random plans in `robots`, and their legs as rows of `legs`.
struct PlanQueries : ::testing::Test {
  void make_plans(int movers, int legs, unsigned seed, const std::string& gap = "") {
    db.exec(
        "CREATE VIRTUAL TABLE robots USING moving_objects(id, t, x, y, vx, vy, plan, r, until);"
        "CREATE VIRTUAL TABLE legs USING moving_objects(id, t, x, y, vx, vy, r, until, +robot, +leg);"
        "CREATE TABLE knots(robot, t, x, y)");
    Random random(seed);
    std::string rows;
    for (int robot = 1; robot <= movers; ++robot) {
      double t = random.in(0, 5);
      for (int i = 0; i <= legs; ++i, t += random.in(0.5, 4))
        rows += (rows.empty() ? "(" : ", (") + std::to_string(robot) + ", " + std::to_string(t) + ", " +
                (i % 4 == 3 && !gap.empty()
                     ? "NULL, NULL"
                     : std::to_string(random.in(0, 30)) + ", " + std::to_string(random.in(0, 30))) +
                ")";
    }
    db.exec(
        "INSERT INTO knots VALUES " + rows +
        ";INSERT INTO robots(id, plan, r) SELECT robot, plan_points(t, x, y), 0.3 FROM knots GROUP BY robot;"
        "INSERT INTO legs(t, x, y, vx, vy, r, until, robot, leg) SELECT p.t, p.x, p.y, p.vx, p.vy, 0.3, "
        "p.until, "
        "robots.id, p.leg FROM robots, plan_rows(plan) AS p");
  }
  Database db;
};

TEST_F(PlanQueries, OneLegIsAPlainRow) {
  make_plans(60, 1, 3);
  db.exec(
      "CREATE VIRTUAL TABLE plain USING moving_objects(id, t, x, y, vx, vy, r, until);"
      "INSERT INTO plain SELECT robot, t, x, y, vx, vy, r, until FROM legs");
  for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"}) {
    const auto join = [&](const char* table) {
      return db.rows(
          std::string("SELECT a, b, t, t_end, dt, dt_end, t_cpa, dt_cpa, d_cpa FROM predictive_join(20, '") +
          table + "', 2) WHERE now = 1 AND method = '" + method + "' ORDER BY a, b");
    };
    EXPECT_EQ(join("robots"), join("plain")) << method;
    EXPECT_NE(join("plain"), "");
  }
  for (const std::string query :
       {"predictive_position(2.5, ?) ORDER BY id", "predictive_track(0, 8, 0.5, ?) ORDER BY id, t",
        "predictive_window(5, ?, 0, 15, 0, 15) WHERE now = 1 ORDER BY id",
        "predictive_nearest(5, ?, 10, 15, 15) WHERE now = 1 ORDER BY rank",
        "predictive_sweep(5, ?) WHERE now = 1 ORDER BY id"}) {
    const auto rows_of = [&](const std::string& table) {
      std::string sql = "SELECT * FROM " + query;
      return db.rows(sql.replace(sql.find('?'), 1, "'" + table + "'"));
    };
    EXPECT_EQ(rows_of("robots"), rows_of("plain")) << query;
    EXPECT_NE(rows_of("plain"), "") << query;
  }
}

/// The contacts of legs of different robots, those that meet in time merged.
constexpr const char* merged =
    "WITH c AS (SELECT min(l.robot, m.robot) AS a, max(l.robot, m.robot) AS b, j.t, j.t_end FROM "
    "predictive_join(40, "
    "'legs', 0.5) AS j, legs AS l, legs AS m WHERE j.now = 1 AND l.id = j.a AND m.id = j.b AND l.robot <> "
    "m.robot), "
    "s AS (SELECT *, t > coalesce(max(t_end) OVER (PARTITION BY a, b ORDER BY t, t_end ROWS BETWEEN "
    "UNBOUNDED PRECEDING "
    "AND 1 PRECEDING), -1) AS starts FROM c), n AS (SELECT *, sum(starts) OVER (PARTITION BY a, b ORDER BY "
    "t, t_end) AS "
    "number FROM s) SELECT a, b, min(t) AS t, max(t_end) AS t_end FROM n GROUP BY a, b, number";

TEST_F(PlanQueries, LegsAsRowsMergedArePlans) {
  make_plans(40, 21, 5, "with gaps");
  const std::string all = db.rows(std::string(merged) + " ORDER BY 1, 2, 3");
  EXPECT_GT(all.size(), 1000u);
  for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"}) {
    EXPECT_EQ(
        db.rows(std::string("SELECT a, b, t, t_end FROM predictive_join(40, 'robots', 0.5) WHERE now = 1 AND "
                            "contacts = 'all' AND method = '") +
                method + "' ORDER BY a, b, t"),
        all)
        << method;
    EXPECT_EQ(
        db.rows(std::string(
                    "SELECT a, b, t FROM predictive_join(40, 'robots', 0.5) WHERE now = 1 AND method = '") +
                method + "' ORDER BY a, b"),
        db.rows(std::string("SELECT a, b, min(t) FROM (") + merged + ") GROUP BY a, b ORDER BY a, b"))
        << method;
  }
}

TEST_F(PlanQueries, PositionsAreThoseOfLegs) {
  make_plans(40, 21, 7, "with gaps");
  EXPECT_EQ(db.rows("SELECT id, x, y, vx FROM predictive_position(17.25, 'robots') ORDER BY id"),
            db.rows("SELECT robot, p.x, p.y, p.vx FROM predictive_position(17.25, 'legs') p JOIN legs "
                    "USING(id) ORDER BY robot"));
  EXPECT_EQ(
      db.rows("SELECT id, x FROM predictive_position(5, 'robots') WHERE id = 3"),
      db.rows("SELECT robot, p.x FROM predictive_position(5, 'legs') p JOIN legs USING(id) WHERE robot = 3"));
  EXPECT_EQ(
      db.rows(
          "SELECT DISTINCT id FROM predictive_window(6, 'robots', 0, 9, 0, 9) WHERE now = 10 ORDER BY id"),
      db.rows("SELECT DISTINCT robot FROM predictive_window(6, 'legs', 0, 9, 0, 9) w JOIN legs USING(id) "
              "WHERE now = 10 ORDER BY robot"));
  EXPECT_EQ(
      db.rows(
          "SELECT id, distance FROM predictive_nearest(6, 'robots', 5, 9, 9) WHERE now = 10 ORDER BY rank"),
      db.rows("SELECT robot, min(distance) FROM predictive_nearest(6, 'legs', 200, 9, 9) n JOIN legs "
              "USING(id) WHERE now = 10 GROUP BY robot ORDER BY 2 LIMIT 5"));
}

TEST_F(PlanQueries, UntilCutsAndRestores) {
  make_plans(40, 20, 9);
  const std::string query =
      "SELECT a, b, t, t_end FROM predictive_join(40, 'robots', 0.5) WHERE now = 1 ORDER BY a, b";
  const std::string before = db.rows(query);
  db.exec("UPDATE robots SET until = t + 3");
  const std::string cut = db.rows(query);
  EXPECT_LT(cut.size(), before.size());
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_position(30, 'robots')"), "0");
  db.exec("UPDATE robots SET until = NULL");
  EXPECT_EQ(db.rows(query), before);
}

TEST_F(PlanQueries, ALoopOverAJoinThatRewritesPlansOfItsOwnTable) {
  make_plans(60, 20, 13);
  const std::string query =
      "SELECT a, b, t FROM predictive_join(40, 'robots', 0.5) WHERE now = 1 ORDER BY a, b";
  const std::string before = db.rows(query);
  for (const char* order : {"", " ORDER BY t LIMIT 50"}) {
    db.exec("BEGIN");
    sqlite3_stmt* join = nullptr;
    ASSERT_EQ(sqlite3_prepare_v2(
                  db.handle(),
                  (std::string("SELECT a, b FROM predictive_join(40, 'robots', 0.5) WHERE now = 1") + order)
                      .c_str(),
                  -1, &join, nullptr),
              SQLITE_OK);
    int rows = 0;
    while (sqlite3_step(join) == SQLITE_ROW) {
      db.exec("UPDATE robots SET plan = plan_shift(plan, 100) WHERE id = " +
              std::to_string(sqlite3_column_int(join, 0)));
      ++rows;
    }
    EXPECT_EQ(sqlite3_finalize(join), SQLITE_OK);
    EXPECT_GT(rows, 40);
    EXPECT_LT(db.rows(query).size(), before.size());
    db.exec("ROLLBACK");
    EXPECT_EQ(db.rows(query), before);
  }
}

TEST_F(PlanQueries, PairsOfOneMover) {
  make_plans(40, 21, 15, "with gaps");
  for (const std::string columns : {"a, b, t, t_end, dt, dt_end", "a, b, t_cpa, d_cpa, t", "a, b"})
    for (const char* one : {"a = 7", "b = 7", "a = 7 AND t > 20", "b = 33 AND t < 30"})
      for (const char* contacts : {"first", "all"}) {
        const auto join = [&](const std::string& method) {
          return db.rows("SELECT " + columns +
                         " FROM predictive_join(40, 'robots', 0.5) WHERE now = 1 AND contacts = '" +
                         contacts + "' AND " + one + " AND method = '" + method + "' ORDER BY a, b, t");
        };
        EXPECT_EQ(join("auto"), join("scan")) << columns << ' ' << one << ' ' << contacts;
      }
  EXPECT_NE(db.rows("SELECT a FROM predictive_join(40, 'robots', 0.5) WHERE now = 1 AND b = 33 AND t < 30"),
            "");
}

TEST_F(PlanQueries, PlansWithPlainRowsOfAnotherTable) {
  make_plans(40, 21, 17, "with gaps");
  db.exec(
      "CREATE VIRTUAL TABLE crates USING moving_objects(id, x, y, r);"
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 50) INSERT INTO crates "
      "SELECT i, "
      "i * 7 % 31, i * 11 % 29, 0.5 FROM n;"
      "INSERT INTO robots(id, t, x, y, vx, vy, r) SELECT 1000 + id, 0, x, y, 0, 0, 0.5 FROM crates");
  const std::string among = db.rows(
      "SELECT a, b - 1000, t, t_end FROM predictive_join(40, 'robots', 0.5) WHERE now = 1 AND contacts = "
      "'all' AND a < "
      "1000 AND b > 1000 ORDER BY a, b, t");
  EXPECT_NE(among, "");
  for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"}) {
    const std::string rest = std::string("now = 1 AND contacts = 'all' AND method = '") + method + "'";
    EXPECT_EQ(
        db.rows(
            "SELECT a, b, t, t_end FROM predictive_join(40, 'robots', 0.5, 'crates') WHERE a < 1000 AND " +
            rest + " ORDER BY a, b, t"),
        among)
        << method;
    EXPECT_EQ(
        db.rows(
            "SELECT b, a, t, t_end FROM predictive_join(40, 'crates', 0.5, 'robots') WHERE b < 1000 AND " +
            rest + " ORDER BY b, a, t"),
        among)
        << method;
  }
}

TEST_F(PlanQueries, AWatchReportsMovers) {
  make_plans(40, 21, 19, "with gaps");
  db.exec("CREATE VIRTUAL TABLE w USING predictive_watch(robots, horizon = 20, within = 0.5)");
  const auto expect_current = [&] {
    EXPECT_EQ(db.rows("SELECT a, b, t FROM w ORDER BY a, b"),
              db.rows("SELECT a, b, t FROM predictive_join(20, 'robots', 0.5) WHERE now = "
                      "(SELECT now FROM predictive_watches) ORDER BY a, b"));
    EXPECT_EQ(db.error_of("INSERT INTO w(w) VALUES ('integrity-check')"), "");
  };
  expect_current();
  db.exec(
      "UPDATE robots SET plan = plan_shift(plan, 0.25) WHERE id % 5 = 0; DELETE FROM robots WHERE id % 7 = "
      "0");
  expect_current();
  db.exec(
      "BEGIN; UPDATE robots SET plan = plan_shift(plan, -1); SAVEPOINT s; UPDATE robots SET until = t + 1; "
      "ROLLBACK TO s; COMMIT");
  expect_current();
  for (const char* now : {"9.5", "22.0", "40.0"}) {
    db.exec(std::string("INSERT INTO w(w, now) VALUES ('advance', ") + now + ")");
    EXPECT_EQ(db.rows("SELECT a, b, t FROM w ORDER BY a, b"),
              db.rows(std::string("SELECT a, b, t FROM predictive_join(20, 'robots', 0.5) WHERE now = ") +
                      now + " ORDER BY a, b"));
    EXPECT_EQ(db.error_of("INSERT INTO w(w) VALUES ('integrity-check')"), "");
  }
}

TEST_F(PlanQueries, AMoverThatWaitsMeetsNoOther) {
  make_plans(12, 3, 23);
  int clear = 0;
  for (int id = 1; id <= 12; ++id) {
    const std::string waits =
        " FROM predictive_avoid WHERE h = 60 AND tbl = 'robots' AND id = " + std::to_string(id) +
        " AND within = 0.5 AND how = 'wait' AND lo = 0 AND hi = 90 AND now = 0 AND clear";
    if (db.rows("SELECT 1" + waits + " LIMIT 1").empty()) continue;
    ++clear;
    db.exec("SAVEPOINT s; UPDATE robots SET plan = (SELECT plan" + waits +
            " LIMIT 1) WHERE id = " + std::to_string(id));
    EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(60, 'robots', 0.5) WHERE now = 0 AND a = " +
                      std::to_string(id) + " OR now = 0 AND b = " + std::to_string(id)),
              "");
    db.exec("ROLLBACK TO s; RELEASE s");
  }
  EXPECT_GT(clear, 3);
  EXPECT_EQ(db.error_of(
                "SELECT * FROM predictive_avoid WHERE h = 60 AND tbl = 'robots' AND id = 1 AND how = 'turn'"),
            "predictive_avoid: robots: row 1 has a plan: write 'wait' or 'delay' with lo and hi, as in "
            "'wait', 0, 600");
}

TEST_F(PlanQueries, ALoopOverASearchThatRewritesPlansOfItsOwnTable) {
  make_plans(80, 40, 25);
  for (const std::string query :
       {"predictive_window(30, 'robots', 0, 20, 0, 20) WHERE now = 4", "predictive_position(20, 'robots')",
        "predictive_nearest(30, 'robots', 60, 9, 9) WHERE now = 4",
        "predictive_sweep(30, 'robots') WHERE now = 4", "predictive_track(4, 30, 5, 'robots')"}) {
    const std::string expected = db.rows("SELECT * FROM " + query);
    EXPECT_FALSE(expected.starts_with("error")) << expected;
    db.exec("BEGIN");
    sqlite3_stmt* rows = nullptr;
    ASSERT_EQ(sqlite3_prepare_v2(db.handle(), ("SELECT * FROM " + query).c_str(), -1, &rows, nullptr),
              SQLITE_OK);
    std::size_t count = 0;
    while (sqlite3_step(rows) == SQLITE_ROW) {
      if (count % 3 == 0)
        db.exec("UPDATE robots SET plan = plan_shift(plan, 100) WHERE id % 7 = " + std::to_string(count % 7));
      ++count;
    }
    EXPECT_EQ(sqlite3_finalize(rows), SQLITE_OK) << query;
    EXPECT_EQ(count, static_cast<std::size_t>(std::count(expected.begin(), expected.end(), '\n')) + 1)
        << query;
    db.exec("ROLLBACK");
    EXPECT_EQ(db.rows("SELECT * FROM " + query), expected) << query;
  }
}

TEST_F(PlanQueries, EachHorizonReadsItsOwnLegs) {
  make_plans(40, 21, 27, "with gaps");
  std::string before = "none";
  for (const std::string times :
       {"(2) WHERE now = 3", "(40) WHERE now = 1", "(5) WHERE now = 20", "(1) WHERE now = 60"}) {
    const std::string query =
        "SELECT a, b, t FROM predictive_join" + times + " AND tbl = 'robots' AND within = 0.5 ORDER BY a, b";
    const std::string rows = db.rows(query);
    EXPECT_NE(rows, before) << times;
    db.exec("UPDATE robots SET r = r WHERE id = 1");  // no scene is kept over a change
    EXPECT_EQ(db.rows(query), rows) << times;
    before = rows;
  }
}

}  // namespace
}  // namespace foresee::testing
