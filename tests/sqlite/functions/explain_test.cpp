// predictive_explain in SQL: columns, inputs and errors.
#include "sqlite/harbour_scene.h"
#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

struct ExplainInSql : Harbour {};

TEST_F(ExplainInSql, ListsTheStagesInOrder) {
  EXPECT_EQ(db.rows("SELECT stage FROM predictive_explain(60, 'ships')"),
            "candidates\nprojection overlap\ncentre point\ntime interval\ntrajectory intersection\nexact "
            "time\nrefinement");
  EXPECT_EQ(db.rows("SELECT n_after - n_before, seconds, detail FROM predictive_explain(60, 'ships') WHERE "
                    "stage = 'refinement'"),
            "0|0.0|left out: no outlines; step 6");
}

TEST_F(ExplainInSql, CountsTheTestsOfRefinement) {
  db.exec(
      "CREATE VIRTUAL TABLE hulls USING moving_objects(id, x, y, z, vx, vy, vz, hz, shape);"
      "INSERT INTO hulls VALUES (1, 0, 0, 0, 1, 0, 0, 1, 'POLYGON((0 0, 4 0, 4 1, 1 1, 1 4, 0 4, 0 0))'),"
      "  (2, 2, 2, 0, 1, 0, 0, 1, 'POLYGON((0 0, -1.5 0, 0 -1.5, 0 0))'), (3, 50, 0, 0, 0, 0, 0, 1, NULL)");
  EXPECT_EQ(db.rows("SELECT stage, n_before, n_after, detail FROM predictive_explain(9, 'hulls') WHERE stage "
                    "IN ('exact time', 'refinement')"),
            "exact time|1|1|of the smallest rectangles around outlines; 1 touch at now already; step 5e\n"
            "refinement|1|1|3.0 pieces, 6.0 node tests and 1.0 leaf tests a pair; step 6");
}

TEST_F(ExplainInSql, CountsNoLeafTestsOfHullsThatPlainDoublesDecide) {
  db.exec(
      "CREATE VIRTUAL TABLE hulls USING moving_objects(id, x, y, vx, vy, shape);"
      "INSERT INTO hulls VALUES (1, 0, 0, 1, 0, 'POLYGON((0 0, 4 0, 4 1, 1 1, 1 4, 0 4, 0 0))'),"
      "  (2, 2, 2, 1, 0, 'POLYGON((0 0, -1.5 0, 0 -1.5, 0 0))')");
  EXPECT_EQ(db.rows("SELECT detail FROM predictive_explain(9, 'hulls') WHERE stage = 'refinement'"),
            "3.0 pieces, 3.0 node tests and 0.0 leaf tests a pair; step 6");
}

TEST_F(ExplainInSql, EndsWithTheCountOfTheJoin) {
  for (const std::string method : {"auto", "grid", "scan", "gpcd"}) {
    const std::string inputs = "(60, 'ships', 5, NULL, 0, '" + method + "')";
    EXPECT_EQ(db.rows("SELECT n_after FROM predictive_explain" + inputs + " WHERE stage = 'refinement'"),
              db.rows("SELECT count(*) FROM predictive_join" + inputs));
    EXPECT_EQ(db.rows("SELECT n_before FROM predictive_explain" + inputs + " WHERE stage = 'candidates'"),
              db.rows("SELECT count(*) * (count(*) - 1) / 2 FROM ships"));
  }
}

TEST_F(ExplainInSql, PrunePowerIsAPercentageAndNullWhereThereIsNothingToPrune) {
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_explain(60, 'ships', 5) WHERE n_before > 0 AND "
                    "prune_power IS NOT 100.0 * (n_before - n_after) / n_before"),
            "0");
  db.exec("CREATE VIRTUAL TABLE lonely USING moving_objects(id, x); INSERT INTO lonely VALUES (1, 0)");
  EXPECT_EQ(db.rows("SELECT DISTINCT n_before, n_after, prune_power FROM predictive_explain(60, 'lonely')"),
            "0|0|NULL");
}

TEST_F(ExplainInSql, GivesTimesAndDetails) {
  EXPECT_EQ(db.rows("SELECT DISTINCT typeof(n_before), typeof(n_after), typeof(seconds), typeof(detail) "
                    "FROM predictive_explain(60, 'ships')"),
            "integer|integer|real|text");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_explain(60, 'ships') WHERE seconds < 0"), "0");
}

TEST_F(ExplainInSql, HasNoRowsForAnEmptyTable) {
  db.exec("CREATE VIRTUAL TABLE nobody USING moving_objects(id, x, y)");
  EXPECT_EQ(db.rows("SELECT * FROM predictive_explain(60, 'nobody')"), "");
}

TEST_F(ExplainInSql, SaysWhatIsWrongWithACall) {
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_explain"),
            "predictive_explain: h is missing or NULL: write predictive_explain(h, tbl, within, other, now, "
            "method, "
            "within_z, schema, own_x0, own_x1, own_y0, own_y1)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_explain(-1, 'ships')"),
            "predictive_explain: h must be a finite number >= 0, not -1");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_explain(1, 'boats')")
                .find("predictive_explain: no such table: 'boats'"),
            0u);
}

TEST(ExplainInSqlOfManyObjects, AgreesWithTheJoinByEveryMethod) {
  Database db;
  const RandomScene scene = random_scene(
      {.layout = {.axes = 3, .law = Law::forced, .shape = Shape::cylinder, .has_t = true, .has_until = true},
       .kind = SceneKind::clustered,
       .count = 800,
       .seed = 41});
  build_table(db, "objects", scene);
  const std::string joined = db.rows("SELECT count(*) FROM predictive_join(3, 'objects', 0.5, NULL, 0)");
  for (const std::string method : {"auto", "grid", "scan", "gpcd"})
    EXPECT_EQ(db.rows("SELECT n_after FROM predictive_explain(3, 'objects', 0.5, NULL, 0, '" + method +
                      "') WHERE stage = 'refinement'"),
              joined);
}

}  // namespace
}  // namespace foresee::testing
