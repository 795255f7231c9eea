// Query plans of predictive_join with ORDER BY and LIMIT.
#include "sqlite/functions/join_planner.h"

namespace foresee::testing {
namespace {

using JoinOrder = JoinPlanner;

TEST_F(JoinOrder, OrdersAndLimits) {
  EXPECT_NE(both("WHERE dt > 0 ORDER BY t, a, b LIMIT 10"), "");
  both("ORDER BY t, a, b LIMIT 5 OFFSET 7");
  both("WHERE a % 3 = 1 ORDER BY d_cpa LIMIT 3");
  EXPECT_EQ(db.rows("SELECT count(*) FROM (SELECT * FROM predictive_join(3) WHERE a % 2 LIMIT 4)"), "4");
  EXPECT_EQ(
      db.rows("SELECT count(*) FROM (SELECT * FROM predictive_join(3) WHERE b > 200 AND dt > 0 LIMIT 3)"),
      "3");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(3)"), db.rows("SELECT count(*) FROM whole"));
}

TEST_F(JoinOrder, GivesRowsInTheOrderOfTimeWithoutSorting) {
  const auto sorts = [this](const std::string& rest) {
    return plan("SELECT a, t, dt FROM predictive_join(3) " + rest).find("TEMP B-TREE") != std::string::npos;
  };
  for (const std::string order : {"t", "dt", "t, a", "t, a, b", "t ASC"}) {
    EXPECT_FALSE(sorts("ORDER BY " + order)) << order;
    EXPECT_FALSE(sorts("WHERE dt > 0 ORDER BY " + order + " LIMIT 10")) << order;
  }
  for (const std::string order : {"t DESC", "t, b", "dt, a", "a", "d_cpa", "t, a DESC", "t + 1"})
    EXPECT_TRUE(sorts("ORDER BY " + order)) << order;
  for (const std::string where :
       {"", "WHERE dt > 0", "WHERE dt >= 1", "WHERE dt < 1", "WHERE dt BETWEEN 1 AND 2",
        "WHERE t > 1 AND t <= 2.5", "WHERE dt = 0", "WHERE a > 200", "WHERE a = 7"}) {
    both(where + " ORDER BY t, a, b");
    both(where + " ORDER BY t, a, b LIMIT 20 OFFSET 3");
    for (const std::string by : {"t", "dt"})
      EXPECT_EQ(db.rows("SELECT " + by + " FROM predictive_join(3) " + where + " ORDER BY " + by),
                db.rows("SELECT " + by + " FROM whole " + where + " ORDER BY " + by));
  }
  EXPECT_EQ(
      db.rows("SELECT h, t FROM predictive_join WHERE h IN (1, 3) ORDER BY t"),
      db.rows(
          "SELECT * FROM (SELECT 1, t FROM predictive_join(1) UNION ALL SELECT 3, t FROM whole) ORDER BY 2"));
  EXPECT_EQ(db.rows("SELECT t, count(*) FROM predictive_join(3) GROUP BY t"),
            db.rows("SELECT t, count(*) FROM whole GROUP BY t"));
  EXPECT_EQ(db.rows("SELECT DISTINCT dt FROM predictive_join(3) ORDER BY dt"),
            db.rows("SELECT DISTINCT dt FROM whole ORDER BY dt"));
  EXPECT_EQ(
      db.rows(
          "SELECT q.h, j.t FROM (SELECT 1 AS h UNION ALL SELECT 2) q, predictive_join(q.h) j ORDER BY j.t"),
      db.rows("SELECT h, t FROM predictive_join WHERE h IN (1, 2) ORDER BY t, h"));
  EXPECT_EQ(
      db.rows("SELECT sa.id, sb.id, j.t FROM predictive_join(3) j JOIN ships sa ON sa.id = j.a JOIN ships sb "
              "ON sb.id = j.b WHERE j.dt > 0 ORDER BY j.t, j.a, j.b LIMIT 5"),
      db.rows("SELECT a, b, t FROM whole WHERE dt > 0 ORDER BY t, a, b LIMIT 5"));
}

/// "@n" and "@o" in the plan: SQLite passes LIMIT and OFFSET to the function
/// (sqlite/functions/function_call.h).
TEST_F(JoinOrder, GivesACallInAnOrderTheNumberOfRowsToRead) {
  const auto passes_limit = [&](const std::string& rest, const std::string& what = "SELECT a, t") {
    return plan(what + " FROM predictive_join(3) " + rest).find("@n") != std::string::npos;
  };
  EXPECT_TRUE(passes_limit("ORDER BY t LIMIT 5"));
  EXPECT_TRUE(passes_limit("WHERE dt > 0 AND t < 2 ORDER BY t, a, b LIMIT 5 OFFSET 3"));
  EXPECT_TRUE(passes_limit("WHERE a = 7 ORDER BY dt LIMIT 5"));
  EXPECT_FALSE(passes_limit("LIMIT 5")) << "no ORDER BY";
  EXPECT_FALSE(passes_limit("ORDER BY t DESC LIMIT 5")) << "SQLite sorts";
  EXPECT_FALSE(passes_limit("WHERE t_end > 1 ORDER BY t LIMIT 5")) << "more rows are read than come";
  EXPECT_FALSE(passes_limit("WHERE a > 7 ORDER BY t LIMIT 5"));
  EXPECT_FALSE(passes_limit("WHERE b % 2 = 0 ORDER BY t LIMIT 5"));
  EXPECT_FALSE(passes_limit("ORDER BY t LIMIT 5", "SELECT DISTINCT t"));
}

TEST_F(JoinOrder, LimitsRowsThatAllStartAtOnceAsAnyTableDoes) {
  Database crowd;
  crowd.exec(
      "CREATE VIRTUAL TABLE discs USING moving_objects(id, t, x, y, r);"
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 300)"
      "INSERT INTO discs SELECT i, 5, i, i * 7 % 300, 400 FROM n;"
      "CREATE TEMP TABLE whole AS SELECT * FROM predictive_join(3, 'discs', 0, NULL, 3)");
  ASSERT_EQ(crowd.rows("SELECT count(*) FROM whole WHERE t = 5"), "44850");
  const auto both = [&](const std::string& rest) {
    const std::string queried =
        crowd.rows("SELECT a, b, t FROM predictive_join(3, 'discs', 0, NULL, 3) " + rest);
    EXPECT_EQ(queried, crowd.rows("SELECT a, b, t FROM whole " + rest)) << rest;
    EXPECT_NE(queried.substr(0, 5), "error");
  };
  for (const char* limit :
       {"0", "1", "300", "5000", "100000", "-1", "3 OFFSET 2", "3 OFFSET 44848", "2 OFFSET -7",
        "-1 OFFSET 44840", "9223372036854775807 OFFSET 9223372036854775807", "(SELECT 4)", "abs(-2)"})
    both("ORDER BY t, a, b LIMIT " + std::string(limit));
  both("WHERE a = 7 OR b = 7 ORDER BY t, a, b LIMIT 9");
  both("WHERE t_end > 5 AND a + b = 301 ORDER BY t, a, b LIMIT 100");
  EXPECT_EQ(crowd.rows("SELECT count(*), count(DISTINCT a * 1000 + b), max(t) FROM (SELECT * FROM "
                       "predictive_join(3, 'discs', 0, NULL, 3) ORDER BY t LIMIT 20000)"),
            "20000|20000|5.0")
      << "any of them, but none twice";
}

}  // namespace
}  // namespace foresee::testing
