// Tables with category and mask: every function gives what the same table without them gives, filtered in SQL
// afterwards.
#include "shape/kinds.h"

#include <gtest/gtest.h>

#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

constexpr const char* may_meet_in_sql = "(one.category & two.mask) <> 0 AND (two.category & one.mask) <> 0";

/// The numbers of the scene without category and mask.
RandomScene without_kinds(const RandomScene& scene) {
  RandomScene plain = scene;
  plain.layout.has_category = plain.layout.has_mask = false;
  const auto all = static_cast<std::size_t>(record_offsets(scene.layout).size);
  const auto kept = static_cast<std::size_t>(record_offsets(plain.layout).size);
  plain.records.clear();
  for (std::size_t i = 0; i < scene.size(); ++i)
    plain.records.insert(plain.records.end(), scene.records.begin() + static_cast<std::ptrdiff_t>(i * all),
                         scene.records.begin() + static_cast<std::ptrdiff_t>(i * all + kept));
  return plain;
}

/// `ships` with kinds, `plain` without, and an ordinary table `ships_kinds`; the same for `buoys`.
class KindsOfScene {
 public:
  KindsOfScene(const Layout& layout, SceneKind kind, std::uint64_t seed) {
    scene_ = random_scene({.layout = layout, .kind = kind, .count = 110, .seed = seed});
    add("ships", "plain", scene_);
    Layout few = layout;
    few.has_mask = false;
    const RandomScene others = random_scene({.layout = few, .kind = kind, .count = 60, .seed = seed + 1});
    add("buoys", "plain_buoys", others);
    db_.exec(
        "CREATE TABLE plain_buoys_kinds AS SELECT id, 1 AS category, 4294967295 AS mask FROM plain_buoys");
  }

  Database& db() { return db_; }
  const RandomScene& scene() const { return scene_; }

  std::string inputs(const std::string& table, const std::string& other = "") const {
    return " WHERE tbl = '" + table + "' AND h = " + std::to_string(scene_.h) +
           " AND within = " + std::to_string(scene_.within) + " AND now = 0" +
           (other.empty() ? "" : " AND other = '" + other + "'");
  }

  std::string join(const std::string& more, const std::string& other = "") {
    return db_.rows("SELECT a, b, t, t_end, dt, d_cpa FROM predictive_join" + inputs("ships", other) + more +
                    " ORDER BY a, b");
  }

  /// The join of the tables without kinds, filtered.
  std::string filtered(const std::string& more, const std::string& plain_other = "",
                       const std::string& kinds_of_other = "ships_kinds") {
    return db_.rows("SELECT a, b, t, t_end, dt, d_cpa FROM predictive_join, ships_kinds AS one, " +
                    kinds_of_other + " AS two" + inputs("plain", plain_other) + more +
                    " AND one.id = a AND two.id = b AND " + may_meet_in_sql + " ORDER BY a, b");
  }

 private:
  void add(const std::string& table, const std::string& plain, const RandomScene& scene) {
    build_table(db_, table, scene);
    build_table(db_, plain, without_kinds(scene));
    db_.exec("CREATE TABLE " + table + "_kinds AS SELECT id, " +
             (scene.layout.has_category ? "category" : "1 AS category") + ", " +
             (scene.layout.has_mask ? "mask" : "4294967295 AS mask") + " FROM " + table);
  }

  Database db_;
  RandomScene scene_;
};

std::vector<Layout> layouts_with_kinds() {
  std::vector<Layout> layouts{
      {.axes = 1, .law = Law::uniform, .shape = Shape::box, .has_t = true},
      {.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true},
      {.axes = 2, .law = Law::rest, .shape = Shape::box, .has_until = true},
      {.axes = 2, .law = Law::accelerated, .shape = Shape::point, .has_t = true, .has_until = true},
      {.axes = 3, .law = Law::forced, .shape = Shape::cylinder},
      {.axes = 3, .law = Law::uniform, .shape = Shape::ball, .has_growth = true},
  };
  for (std::size_t i = 0; i < layouts.size(); ++i)
    layouts[i].has_category = i % 3 != 2, layouts[i].has_mask = i % 3 != 1 || i == 1;
  return layouts;
}

class KindsOfEveryLayout : public ::testing::TestWithParam<Layout> {};
INSTANTIATE_TEST_SUITE_P(AxesLawShape, KindsOfEveryLayout, ::testing::ValuesIn(layouts_with_kinds()));

TEST_P(KindsOfEveryLayout, EveryMethodJoinsThePairsThatMayMeet) {
  std::size_t found = 0;
  for (const SceneKind kind :
       {SceneKind::uniform, SceneKind::clustered, SceneKind::one_giant, SceneKind::one_fast}) {
    SCOPED_TRACE(name_of(GetParam()) + ", " + name_of(kind));
    KindsOfScene scene(GetParam(), kind, 3);
    const std::string within = scene.filtered(""), itself = scene.filtered("", "plain");
    const std::string between = scene.filtered("", "plain_buoys", "buoys_kinds");
    const std::string with_plain = scene.filtered("", "plain_buoys", "plain_buoys_kinds");
    found += within.size();
    for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"}) {
      SCOPED_TRACE(method);
      const std::string by = std::string(" AND method = '") + method + "'";
      EXPECT_EQ(scene.join(by), within);
      EXPECT_EQ(scene.join(by, "ships"), itself);
      EXPECT_EQ(scene.join(by, "buoys"), between);
      EXPECT_EQ(scene.join(by, "plain_buoys"), with_plain);
      for (const char* one : {" AND a = 17", " AND b = 60", " AND t > 1", " AND a = 5 AND b = 9"})
        EXPECT_EQ(scene.join(by + one), scene.filtered(one)) << one;
      EXPECT_EQ(scene.join(by + " AND b = 7", "buoys"),
                scene.filtered(" AND b = 7", "plain_buoys", "buoys_kinds"));
    }
  }
  EXPECT_GT(found, 1000u);
}

TEST_P(KindsOfEveryLayout, ExplainHasAStageOfItsOwn) {
  KindsOfScene scene(GetParam(), SceneKind::clustered, 5);
  Database& db = scene.db();
  for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"}) {
    SCOPED_TRACE(method);
    db.exec(
        "DROP TABLE IF EXISTS stages; CREATE TABLE stages AS SELECT row_number() OVER () AS n, * FROM "
        "predictive_explain" +
        scene.inputs("ships") + " AND method = '" + method + "'");
    EXPECT_EQ(db.rows("SELECT stage, n_before, n_after FROM stages WHERE n = 1"),
              "kinds|5995|" +
                  db.rows("SELECT count(*) FROM ships_kinds AS one, ships_kinds AS two WHERE one.id < two.id "
                          "AND " +
                          std::string(may_meet_in_sql)));
    EXPECT_EQ(
        db.rows(
            "SELECT count(*) FROM stages AS one, stages AS two WHERE two.n = one.n + 1 AND one.n_after <> "
            "two.n_before"),
        "0");
    EXPECT_EQ(db.rows("SELECT n_after FROM stages ORDER BY n DESC LIMIT 1"),
              db.rows("SELECT count(*) FROM predictive_join" + scene.inputs("ships")));
  }
  EXPECT_EQ(
      db.rows("SELECT count(*) FROM predictive_explain" + scene.inputs("plain") + " AND stage = 'kinds'"),
      "0");
}

TEST_P(KindsOfEveryLayout, TilesGiveTheWholeJoin) {
  KindsOfScene scene(GetParam(), SceneKind::clustered, 6);
  const double side = scene.scene().side;
  for (const char* other : {"", "buoys"}) {
    std::string tiles;
    for (int tile = 0; tile < 4; ++tile) {
      std::string bounds = tile > 0 ? " AND own_x0 = " + std::to_string(side * tile / 4) : "";
      if (tile < 3) bounds += " AND own_x1 = " + std::to_string(side * (tile + 1) / 4);
      tiles += (tile > 0 ? " UNION ALL " : "") + ("SELECT a, b, t, t_end, dt, d_cpa FROM predictive_join" +
                                                  scene.inputs("ships", other) + bounds);
    }
    EXPECT_EQ(scene.db().rows("SELECT * FROM (" + tiles + ") ORDER BY a, b"), scene.join("", other)) << other;
    EXPECT_EQ(scene.db().rows("SELECT min(n_after) FROM predictive_explain" + scene.inputs("ships", other) +
                              " AND own_x0 = " + std::to_string(side / 2)),
              scene.db().rows("SELECT count(*) FROM predictive_join" + scene.inputs("ships", other) +
                              " AND own_x0 = " + std::to_string(side / 2)));
    EXPECT_EQ(scene.db().rows("SELECT * FROM predictive_explain" + scene.inputs("ships", other) +
                              " AND own_x0 = 1e9"),
              "")
        << "a tile that needs no object";
  }
}

TEST_P(KindsOfEveryLayout, WindowAndNearestTestTheCategoryAlone) {
  KindsOfScene scene(GetParam(), SceneKind::uniform, 7);
  Database& db = scene.db();
  const std::string middle = std::to_string(scene.scene().side / 2);
  std::string point;
  for (int axis = 0; axis < GetParam().axes; ++axis)
    point += std::string(" AND ") + "xyz"[axis] + " = " + middle;
  for (const char* mask : {"0", "1", "6", "2147483648", "4294967295", "'3'", "2.0"})
    for (const char* method : {"auto", "tree", "scan"}) {
      SCOPED_TRACE(std::string(mask) + ", " + method);
      const std::string how = std::string(" AND now = 0 AND h = 2 AND method = '") + method + "'",
                        accepted = std::string(" AND (category & ") + mask + ") <> 0",
                        masked = std::string(" AND mask = ") + mask;
      EXPECT_EQ(
          db.rows("SELECT id, t, t_end FROM predictive_window WHERE tbl = 'ships' AND x1 = " + middle + how +
                  masked + " ORDER BY id"),
          db.rows(
              "SELECT w.id, t, t_end FROM predictive_window AS w, ships_kinds AS k WHERE tbl = 'plain' AND "
              "x1 = " +
              middle + how + " AND k.id = w.id" + accepted + " ORDER BY w.id"));
      EXPECT_EQ(
          db.rows("SELECT id, rank, distance, t FROM predictive_nearest WHERE tbl = 'ships' AND k = 7" +
                  point + how + masked + " ORDER BY rank"),
          db.rows("SELECT n.id, row_number() OVER (ORDER BY rank), distance, t FROM predictive_nearest AS n, "
                  "ships_kinds AS k WHERE tbl = 'plain' AND k = 1000" +
                  point + how + " AND k.id = n.id" + accepted + " ORDER BY rank LIMIT 7"));
    }
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window WHERE tbl = 'plain' AND h = 2 AND mask = 2"),
            "0");
  EXPECT_EQ(
      db.rows(
          "SELECT count(*) FROM predictive_window WHERE tbl = 'plain' AND h = 2 AND now = 0 AND mask = 1"),
      db.rows("SELECT count(*) FROM predictive_window WHERE tbl = 'plain' AND h = 2 AND now = 0"));
}

TEST_P(KindsOfEveryLayout, AvoidMeetsTheObjectsThatMayMeet) {
  if (GetParam().law == Law::rest) return;
  KindsOfScene scene(GetParam(), SceneKind::clustered, 8);
  Database& db = scene.db();
  const std::string columns = columns_of(scene.scene().layout);
  const std::string plain = columns_of(without_kinds(scene.scene()).layout);
  const std::string outputs =
      "SELECT manoeuvre, clear, k_from, k_to, k, below, t_below, above, t_above FROM "
      "predictive_avoid";
  const std::string how = GetParam().axes == 1 ? " AND how = 'speed'" : " AND how = 'turn'";
  std::string any;
  for (const int id : {4, 33, 71}) {
    SCOPED_TRACE(id);
    const std::string own = std::to_string(id);
    for (const char* table : {"ships", "buoys"}) {
      const std::string left = std::string("left_") + table;
      db.exec("CREATE VIRTUAL TABLE " + left + " USING moving_objects(id, " + plain + "); INSERT INTO " +
              left + "(id, " + plain + ") SELECT t.id, " + plain + " FROM " + table +
              " AS t, ships_kinds AS one, " + table + "_kinds AS two WHERE one.id = " + own +
              " AND two.id = t.id AND (" + may_meet_in_sql +
              (std::string(table) == "ships" ? " OR t.id = one.id)" : ")"));
    }
    const std::string found = db.rows(outputs + scene.inputs("ships") + how + " AND id = " + own);
    any += found;
    EXPECT_EQ(found, db.rows(outputs + scene.inputs("left_ships") + how + " AND id = " + own));
    EXPECT_EQ(
        db.rows(outputs + scene.inputs("ships") + how + " AND also = 'buoys' AND id = " + own),
        db.rows(outputs + scene.inputs("left_ships") + how + " AND also = 'left_buoys' AND id = " + own));
    db.exec("DROP TABLE left_ships; DROP TABLE left_buoys");
  }
  EXPECT_NE(any, "");
}

TEST(Kinds, InputMaskIs32Bits) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, category)");
  for (const char* value : {"-1", "4294967296", "1.5", "'1.5'", "'all'", "x'01'"})
    for (const char* call : {"predictive_window WHERE h = 1",
                             "predictive_nearest WHERE h = 1 AND k = 1 AND x = 0 AND "
                             "y = 0"})
      EXPECT_NE(db.rows(std::string("SELECT id FROM ") + call + " AND mask = " + value)
                    .find(": mask must be a whole number from 0 to 4294967295, not "),
                std::string::npos)
          << value;
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window WHERE h = 1 AND mask = NULL"), "0");
}

}  // namespace
}  // namespace foresee::testing
