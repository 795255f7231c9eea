// predictive_join in SQL: outputs, inputs by position and by name, defaults; every method gives the same rows, for
// every combination of axes, law of motion and shape.
#include "sanitized.h"
#include "sqlite/harbour_scene.h"
#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

struct JoinTest : Harbour {};

TEST_F(JoinTest, GivesEveryOutput) {
  EXPECT_EQ(db.rows("SELECT * FROM predictive_join(20)"), "1|2|3.0|7.0|3.0|7.0|5.0|5.0|0.0");
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end, dt, dt_end, t_cpa, dt_cpa, d_cpa FROM "
                    "predictive_join(20, 'ships', 0, NULL, 1)"),
            "1|2|3.0|7.0|2.0|6.0|5.0|4.0|0.0");
}

TEST_F(JoinTest, GivesEachOutputAlone) {
  const std::pair<const char*, const char*> outputs[] = {
      {"a", "1"},        {"b", "2"},       {"t", "3.0"},      {"t_end", "7.0"}, {"dt", "2.0"},
      {"dt_end", "6.0"}, {"t_cpa", "5.0"}, {"dt_cpa", "4.0"}, {"d_cpa", "0.0"}};
  for (const auto& [name, value] : outputs)
    EXPECT_EQ(db.rows(std::string("SELECT ") + name + " FROM predictive_join(20, NULL, NULL, NULL, 1)"),
              value)
        << name;
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(20)"), "1");
}

TEST_F(JoinTest, ClipsTimesToTheHorizon) {
  EXPECT_EQ(db.rows("SELECT t, t_end, t_cpa, d_cpa FROM predictive_join(1, 'ships', 0, NULL, 3.5)"),
            "3.5|4.5|4.5|1.0");
}

TEST_F(JoinTest, TakesEveryInputByName) {
  build_crates(db);
  EXPECT_EQ(
      db.rows("SELECT a, b, t, t_end FROM predictive_join WHERE h = 9 AND tbl = 'ships' AND within = 0.5 AND "
              "other = 'crates' AND now = 0 AND method = 'scan' AND schema = 'main'"),
      "1|11|4.5|5.5");
  EXPECT_EQ(
      db.rows(
          "SELECT a, b, t, t_end FROM predictive_join(9, 'ships', 0.5, 'crates', 0, 'scan', NULL, 'main')"),
      "1|11|4.5|5.5");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(9, 'ships') WHERE now = 100"), "");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join WHERE 'ships' = tbl AND 9 = h"), "1|2");
}

TEST_F(JoinTest, CountsNullAsLeftOut) {
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(20, NULL, NULL, NULL, NULL, NULL, NULL, NULL)"), "1|2");
}

TEST_F(JoinTest, TakesTheNewestTimeAsNow) {
  db.exec("INSERT INTO ships VALUES (4, 5, 1000, 1000, 0, 0, 1, 'Dan')");
  EXPECT_EQ(db.rows("SELECT a, b, t, dt FROM predictive_join(1)"), "1|2|5.0|0.0");
  db.exec(
      "CREATE VIRTUAL TABLE buoys USING moving_objects(id, t, x, y); INSERT INTO buoys VALUES (1, 6, 6, 0)");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM predictive_join(1, 'ships', 0, 'buoys')"), "1|1|6.0")
      << "of both tables";
  EXPECT_EQ(db.rows("SELECT a, b, t FROM predictive_join(1, 'buoys', 0, 'ships')"), "1|1|6.0");
}

TEST_F(JoinTest, FindsPairsOnlyWhileBothExist) {
  db.exec("CREATE VIRTUAL TABLE lives USING moving_objects(id, t, x, vx, r, until)");
  db.exec(
      "INSERT INTO lives VALUES (1, 0, 0, 1, 1, 4), (2, 0, 10, -1, 1, NULL), (3, 3, 2, 0, 1, 5), (4, 50, 0, "
      "0, 1, NULL)");
  // 1 and 2 meet at 4, the end of 1; 3 starts at 3, next to 1.
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end FROM predictive_join(10, 'lives', 0, NULL, 0) ORDER BY a, b"),
            "1|2|4.0|4.0\n1|3|3.0|4.0");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM predictive_join(10, 'lives', 0, NULL, 4.5) ORDER BY a, b"), "");
}

TEST_F(JoinTest, QueriesAnInstantWithAHorizonOfZero) {
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end FROM predictive_join(0, 'ships', 0, NULL, 3)"), "1|2|3.0|3.0");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(0, 'ships', 0, NULL, 2.9)"), "");
}

TEST_F(JoinTest, AcceptsAHugeHorizon) {
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end FROM predictive_join(1e300)"), "1|2|3.0|7.0");
}

TEST_F(JoinTest, WithinCountsComingThatClose) {
  EXPECT_EQ(db.rows("SELECT t, t_end FROM predictive_join(20, 'ships', 2)"), "2.0|8.0");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(0, 'ships', 95) ORDER BY a, b"), "1|2\n1|3");
}

TEST_F(JoinTest, WithinZKeepsHeightsApart) {
  db.exec(
      "CREATE VIRTUAL TABLE planes USING moving_objects(id, x, y, z, vx, vy, vz);"
      "INSERT INTO planes VALUES (1, 0, 0, 0, 1, 0, 0), (2, 10, 0, 3, -1, 0, 0)");
  EXPECT_EQ(db.rows("SELECT t, t_end FROM predictive_join(20, 'planes', 4, NULL, 0, 'grid', 3)"), "3.0|7.0");
  EXPECT_EQ(db.rows("SELECT t, t_end FROM predictive_join(20, 'planes', 4, NULL, 0, 'scan', 3)"), "3.0|7.0");
  EXPECT_EQ(db.rows("SELECT t, t_end FROM predictive_join(20, 'planes', 4, NULL, 0, 'auto', 2.9)"), "");
  EXPECT_EQ(db.rows("SELECT t, t_end FROM predictive_join(20, 'planes', 5)"), "3.0|7.0")
      << "a ball of 5: 4, 3, 5";
}

TEST_F(JoinTest, OfTwoTablesHasTheFirstAsA) {
  build_crates(db);
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(9, 'crates', 0.5, 'ships')"), "11|1");
}

TEST_F(JoinTest, OfATableWithItselfAsOtherGivesBothOrders) {
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(20, 'ships', 0, 'ships') ORDER BY a"), "1|2\n2|1");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(20, 'ships', 0, 'SHIPS') WHERE a = 2"), "2|1");
}

TEST_F(JoinTest, OfAnEmptyTableHasNoRows) {
  db.exec("DELETE FROM ships");
  EXPECT_EQ(db.rows("SELECT * FROM predictive_join(20)"), "");
  EXPECT_EQ(db.rows("SELECT * FROM predictive_join(20) WHERE a = 1"), "");
  db.exec("INSERT INTO ships(id, t, x, y) VALUES (1, 0, 0, 0)");
  EXPECT_EQ(db.rows("SELECT * FROM predictive_join(20)"), "");
}

TEST_F(JoinTest, KeepsLargeIdsWhole) {
  db.exec(
      "UPDATE ships SET id = 9223372036854775807 WHERE id = 1; UPDATE ships SET id = -9223372036854775808 "
      "WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(20)"), "-9223372036854775808|9223372036854775807");
  EXPECT_EQ(db.rows("SELECT a FROM predictive_join(20) WHERE b = 9223372036854775807"),
            "-9223372036854775808");
}

std::string rows_by(Database& db, const std::string& method, const RandomScene& scene) {
  char call[200];
  sqlite3_snprintf(sizeof call, call, "predictive_join(%!.17g, 'objects', %!.17g, NULL, %!.17g, '%s')",
                   scene.h, scene.within, scene.now, method.c_str());
  return db.rows(std::string("SELECT * FROM ") + call + " ORDER BY a, b");
}

class JoinInSqlOfEveryLayout : public ::testing::TestWithParam<Layout> {};

TEST_P(JoinInSqlOfEveryLayout, EveryMethodAgreesWithScan) {
  std::size_t size = 0;
  for (SceneKind kind : all_scene_kinds) {
    Database db;
    const RandomScene scene = random_scene({.layout = GetParam(), .kind = kind, .count = 60, .seed = 21});
    build_table(db, "objects", scene);
    const std::string scanned = rows_by(db, "scan", scene);
    EXPECT_EQ(rows_by(db, "grid", scene), scanned) << name_of(kind);
    EXPECT_EQ(rows_by(db, "tree", scene), scanned) << name_of(kind);
    EXPECT_EQ(rows_by(db, "gpcd", scene), scanned) << name_of(kind);
    EXPECT_EQ(rows_by(db, "auto", scene), scanned) << name_of(kind);
    size += scanned.size();
  }
  EXPECT_GT(size, 0u);
}

INSTANTIATE_TEST_SUITE_P(AxesLawShapeTimes, JoinInSqlOfEveryLayout, ::testing::ValuesIn(all_layouts()));

TEST(JoinInSqlOfManyObjects, GridAndTreeAgreeWithScan) {
  const std::pair<Layout, SceneKind> cases[] = {
      {{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true}, SceneKind::uniform},
      {{.axes = 3, .law = Law::forced, .shape = Shape::cylinder}, SceneKind::clustered},
      {{.axes = 2, .law = Law::accelerated, .shape = Shape::box, .has_until = true}, SceneKind::one_giant}};
  for (const auto& [layout, kind] : cases) {
    Database db;
    const RandomScene scene =
        random_scene({.layout = layout, .kind = kind, .count = sanitized ? 1200u : 5000u, .seed = 22});
    build_table(db, "objects", scene);
    const std::string scanned = rows_by(db, "scan", scene);
    EXPECT_EQ(rows_by(db, "grid", scene), scanned) << name_of(layout) << ", " << name_of(kind);
    EXPECT_EQ(rows_by(db, "tree", scene), scanned) << name_of(layout) << ", " << name_of(kind);
  }
}

}  // namespace
}  // namespace foresee::testing
