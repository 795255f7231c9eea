// Join methods through SQL: every method gives the same rows, for every combination of axes, law of motion
// and shape.
#include "sanitized.h"
#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

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
