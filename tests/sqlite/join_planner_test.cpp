// What the planner does with predictive_join: ids asked for, orders, limits, views, lateral calls.
#include <algorithm>

#include "sqlite/harbour.h"
#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

struct JoinPlanner : ::testing::Test {
  JoinPlanner() {
    build_table(db, "ships",
                random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball},
                              .kind = SceneKind::clustered,
                              .count = 400,
                              .seed = 3}));
    db.exec("CREATE TEMP TABLE whole AS SELECT * FROM predictive_join(3)");
  }

  std::string both(const std::string& where) {
    const std::string asked = db.rows("SELECT * FROM predictive_join(3) " + where);
    EXPECT_EQ(asked, db.rows("SELECT * FROM whole " + where)) << where;
    return asked;
  }
  std::string plan(const std::string& sql) { return db.rows("EXPLAIN QUERY PLAN " + sql); }

  Database db;
};

TEST_F(JoinPlanner, FiltersRowsAsAnyTableDoes) {
  const std::string id = db.rows("SELECT a FROM whole GROUP BY a ORDER BY count(*) DESC, a LIMIT 1");
  const std::string end = " ORDER BY a, b";
  EXPECT_NE(both("WHERE a = " + id + end), "");
  both("WHERE b = " + id + end);
  EXPECT_NE(both("WHERE a = " + id + " OR b = " + id + end), "");
  both("WHERE a = " + id + " AND b = 7" + end);
  both("WHERE (a = " + id + " OR b = " + id + ") AND dt > 0" + end);
  both("WHERE a IN (1, 2, " + id + ", NULL)" + end);
  both("WHERE a = " + id + ".0" + end);
  both("WHERE a = '" + id + "'" + end);
  both("WHERE a = 1.5" + end);
  both("WHERE a = 'x'" + end);
  both("WHERE a = NULL" + end);
  both("WHERE a IS " + id + end);
  both("WHERE a = 100000" + end);
  EXPECT_NE(both("WHERE dt > 0" + end), "");
  both("WHERE dt > 1" + end);
  both("WHERE dt >= 0" + end);
  both("WHERE dt >= 1 AND t < 2" + end);
  both("WHERE dt = 0" + end);
  both("WHERE dt > -1" + end);
  both("WHERE dt BETWEEN 0.5 AND 2.5" + end);
  both("WHERE dt > '1'" + end);
  both("WHERE dt > 0 AND a = " + id + end);
}

TEST_F(JoinPlanner, FindsEveryPairOfAnId) {
  for (int id = 1; id <= 400; id += 23) {
    const std::string either = "WHERE a = " + std::to_string(id) + " OR b = " + std::to_string(id);
    both(either + " ORDER BY a, b");
  }
}

TEST_F(JoinPlanner, ProbesOneObjectWhenItsIdIsAskedFor) {
  EXPECT_NE(plan("SELECT * FROM predictive_join(3) WHERE a = 42 OR b = 42").find("MULTI-INDEX OR"),
            std::string::npos);
}

TEST_F(JoinPlanner, OrdersAndLimits) {
  EXPECT_NE(both("WHERE dt > 0 ORDER BY t, a, b LIMIT 10"), "");
  both("ORDER BY t, a, b LIMIT 5 OFFSET 7");
  both("WHERE a % 3 = 1 ORDER BY d_cpa LIMIT 3");
  EXPECT_EQ(db.rows("SELECT count(*) FROM (SELECT * FROM predictive_join(3) WHERE a % 2 LIMIT 4)"), "4");
  EXPECT_EQ(
      db.rows("SELECT count(*) FROM (SELECT * FROM predictive_join(3) WHERE b > 200 AND dt > 0 LIMIT 3)"),
      "3");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(3)"), db.rows("SELECT count(*) FROM whole"));
}

TEST_F(JoinPlanner, TellsTheRowsOfTwoHorizonsApart) {
  EXPECT_EQ(db.rows("SELECT h, count(*) FROM predictive_join WHERE h IN (1, 3) GROUP BY h"),
            db.rows("SELECT 1, count(*) FROM predictive_join(1) UNION ALL SELECT 3, count(*) FROM whole"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM (SELECT DISTINCT a, b FROM predictive_join WHERE h IN (1, 3))"),
            db.rows("SELECT count(*) FROM whole"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join WHERE (h = 1 AND now = 0) OR (h = 3 AND now = 0)"),
            db.rows("SELECT (SELECT count(*) FROM predictive_join(1)) + (SELECT count(*) FROM whole)"));
}

TEST_F(JoinPlanner, RunsTheJoinOnceWhenShipsAreLookedUp) {
  const std::string sql =
      "SELECT sa.x, sb.x FROM ships sa JOIN ships sb JOIN predictive_join(3, 'ships') j ON sa.id = j.a AND "
      "sb.id = j.b";
  const std::string steps = plan(sql);
  EXPECT_LT(steps.find("SCAN j"), steps.find("SCAN sa")) << steps;
  EXPECT_LT(steps.find("SCAN j"), steps.find("SCAN sb")) << steps;
  EXPECT_EQ(db.rows("SELECT count(*) FROM (" + sql + ")"), db.rows("SELECT count(*) FROM whole"));
}

TEST_F(JoinPlanner, IsCalledOncePerRowOfTheTableBefore) {
  db.exec(
      "CREATE TABLE questions(h, who); INSERT INTO questions VALUES (1, 'ships'), (3, 'ships'), (0, NULL)");
  EXPECT_EQ(
      db.rows("SELECT h, (SELECT count(*) FROM predictive_join(q.h, q.who)) FROM questions q"),
      db.rows("SELECT 1, count(*) FROM predictive_join(1) UNION ALL SELECT 3, count(*) FROM whole UNION ALL "
              "SELECT 0, count(*) FROM predictive_join(0)"));
  EXPECT_EQ(
      db.rows("SELECT q.h, count(*) FROM questions q, predictive_join(q.h, q.who) GROUP BY q.h ORDER BY q.h"),
      db.rows("SELECT h, count(*) FROM predictive_join WHERE h IN (0, 1, 3) GROUP BY h ORDER BY h"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM questions q LEFT JOIN predictive_join(q.h, q.who) j ON j.a < 0"),
            "3");
}

TEST_F(JoinPlanner, ServesViewsThatNobodyVouchesFor) {
  db.exec("CREATE VIEW soon AS SELECT a, b, t FROM predictive_join(3, 'ships'); PRAGMA trusted_schema = OFF");
  EXPECT_EQ(db.rows("SELECT count(*) FROM soon"), db.rows("SELECT count(*) FROM whole"));
}

TEST_F(JoinPlanner, ServesTriggersAndPreparedParameters) {
  db.exec(
      "CREATE TABLE clock(now); CREATE TABLE alarms(n); CREATE TRIGGER tick AFTER INSERT ON clock BEGIN "
      "INSERT INTO alarms SELECT count(*) FROM predictive_join(3, 'ships') WHERE now = new.now; END;"
      "INSERT INTO clock VALUES (0)");
  EXPECT_EQ(db.rows("SELECT n FROM alarms"), db.rows("SELECT count(*) FROM whole"));
}

}  // namespace
}  // namespace foresee::testing
