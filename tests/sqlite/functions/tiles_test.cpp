// Tiles of a join (own_* in SQL): together the tiles give the whole join, by every method, from a tree of
// several levels.
#include "sqlite/functions/tiled_tables.h"
#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

TEST(Tiles, TogetherAreTheWholeJoinByEveryMethod) {
  for (const Layout& layout : tiled_layouts)
    for (const SceneKind kind : {SceneKind::uniform, SceneKind::one_giant, SceneKind::identical_motions}) {
      TiledTables tables(layout, kind, sanitized ? 200 : 500);
      for (const char* method : {"NULL", "'grid'", "'tree'", "'scan'", "'gpcd'"})
        tables.expect_tiles_agree("NULL", method);
      tables.expect_tiles_agree("'objects'", "'tree'");
      tables.expect_tiles_agree("'others'", "NULL");
      tables.expect_tiles_agree("'others'", "'tree'");
      EXPECT_GT(tables.answered, 10000u) << name_of(layout) << ", " << name_of(kind);
    }
}

TEST(Tiles, TogetherAreTheWholeJoinOfOneObject) {
  TiledTables tables(tiled_layouts[0], SceneKind::clustered, 200);
  for (int id = 1; id < 200; id += 19)
    for (const char* other : {"NULL", "'objects'", "'others'"})
      for (const char* method : {"NULL", "'scan'"}) {
        tables.expect_tiles_agree(other, method, "WHERE a = " + std::to_string(id));
        tables.expect_tiles_agree(other, method, "WHERE b = " + std::to_string(id));
      }
  EXPECT_GT(tables.answered, 1000u);
}

// A box around the largest size and the whole path would be wider than the bounds of its node.
TEST(Tiles, AndSweepsFindAllThatGrows) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE s USING moving_objects(id, x, y, vx, vy, growth);"
      "WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n WHERE i < 1000) "
      "INSERT INTO s SELECT i, 100.0 * i, 0, 15, 0, 1 FROM n");
  const std::string sweep = "SELECT count(*) FROM predictive_sweep(600, 's', 0, 0) WHERE ";
  EXPECT_EQ(db.rows(sweep + "x0 < 7000 AND x1 >= 6000"), db.rows(sweep + "+x0 < 7000 AND +x1 >= 6000"));
  EXPECT_EQ(db.rows("SELECT round(x0, 6), round(x1, 6) FROM predictive_sweep(600, 's', 0, 0) WHERE id = 1"),
            "100.0|9700.0");
  EXPECT_EQ(
      db.rows("SELECT sum(n) FROM (SELECT (SELECT count(*) FROM predictive_join WHERE h = 600 AND tbl = 's'"
              " AND now = 0 AND own_x0 = iif(i = 0, NULL, i * 1000.0)"
              " AND own_x1 = iif(i = 110, NULL, i * 1000.0 + 1000)) AS n FROM"
              " (WITH RECURSIVE k(i) AS (VALUES(0) UNION ALL SELECT i + 1 FROM k WHERE i < 110) SELECT i"
              " FROM k))"),
      db.rows("SELECT count(*) FROM predictive_join(600, 's')"));
}

TEST(Tiles, KeepOrderLimitsAndBounds) {
  TiledTables tables(tiled_layouts[0], SceneKind::uniform);
  Database& db = tables.db;
  const std::string join = tables.join("NULL", "NULL", ", 10, 40, NULL, 50");
  const std::string sorted =
      db.rows("SELECT * FROM (SELECT t, a, b FROM " + join + "LIMIT -1) ORDER BY t, a, b LIMIT 20");
  EXPECT_EQ(db.rows("SELECT t, a, b FROM " + join + "ORDER BY t, a, b LIMIT 20"), sorted);
  EXPECT_EQ(std::count(sorted.begin(), sorted.end(), '\n'), 19);
  EXPECT_EQ(db.rows("SELECT a, b FROM " + join + "WHERE dt > 1 ORDER BY a, b"),
            db.rows("SELECT a, b FROM " + join + "WHERE +dt > 1 ORDER BY a, b"));
}

TEST(Tiles, AreExplainedByTheirOwnPairs) {
  TiledTables tables(tiled_layouts[0], SceneKind::uniform);
  for (const char* method : {"NULL", "'tree'", "'gpcd'"}) {
    const std::string whole = tables.join("NULL", method),
                      own = tables.join("NULL", method, ", x0, x1, y0, y1");
    const auto explained = [](std::string join) { return join.replace(0, 15, "predictive_explain"); };
    EXPECT_EQ(tables.db.rows("SELECT sum(n_after) FROM tiles CROSS JOIN " + explained(own) +
                             "WHERE stage = 'refinement'"),
              tables.db.rows("SELECT count(*) FROM " + whole));
  }
  // All pairs of the objects that the tile needs, by each access path.
  const std::string tile =
      "(3, 'objects', 0, NULL, 0, NULL, NULL, NULL, 10, 30, 10, 30) WHERE stage = 'candidates'";
  const std::string first = tables.db.rows("SELECT n_before FROM predictive_explain" + tile);
  tables.db.rows("SELECT count(*) FROM " + tables.join("NULL", "NULL"));
  EXPECT_EQ(tables.db.rows("SELECT n_before FROM predictive_explain" + tile), first);
  EXPECT_EQ(tables.db.rows(
                "SELECT n * (n - 1) / 2 FROM (SELECT count(*) AS n FROM predictive_sweep(3, 'objects', 0, 0)"
                " WHERE x0 < 30 AND x1 >= 10 AND y0 < 30 AND y1 >= 10)"),
            first);
}

TEST(Tiles, AnswerFromTheRowsThatWereSentToThem) {
  TiledTables tables(tiled_layouts[1], SceneKind::one_giant);
  Database& db = tables.db;
  const std::string whole = db.rows(std::string("SELECT ") + all_columns + " FROM " +
                                    tables.join("NULL", "NULL") + "ORDER BY a, b");
  db.exec("CREATE TEMP TABLE found AS SELECT * FROM " + tables.join("NULL", "NULL") +
          "WHERE 0;"
          "CREATE TABLE numbered AS SELECT row_number() OVER () AS n, * FROM tiles");
  const int count = std::stoi(db.rows("SELECT count(*) FROM tiles"));
  EXPECT_GT(count, 20);
  for (int n = 1; n <= count; ++n) {
    db.exec(
        "DROP TABLE IF EXISTS tile; CREATE VIRTUAL TABLE tile USING moving_objects(id, x, y, vx, vy, ax, ay, "
        "hx, hy, until);"
        "INSERT INTO tile SELECT o.* FROM numbered CROSS JOIN " +
        tables.sweep() +
        "s CROSS JOIN objects o ON o.id = s.id"
        " WHERE n = " +
        std::to_string(n) +
        " AND s.x0 < coalesce(numbered.x1, 1e999) AND s.x1 >= coalesce(numbered.x0, -1e999)"
        " AND s.y0 < coalesce(numbered.y1, 1e999) AND s.y1 >= coalesce(numbered.y0, -1e999)");
    std::string join = tables.join("NULL", "NULL", ", x0, x1, y0, y1");
    join.replace(join.find("'objects'"), 9, "'tile'");
    db.exec(std::string("INSERT INTO found SELECT ") + all_columns + " FROM numbered CROSS JOIN " + join +
            "WHERE n = " + std::to_string(n));
  }
  EXPECT_TRUE(db.rows(std::string("SELECT ") + all_columns + " FROM found ORDER BY a, b") == whole);
}

TEST(Tiles, OwnPairsOfOutlinesAndMeshes) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE hulls USING moving_objects(id, x, y, vx, vy, shape, heading);"
      "CREATE VIRTUAL TABLE bodies USING moving_objects(id, x, y, z, vx, vy, vz, shape);"
      "CREATE TABLE n AS WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n WHERE i < 150) "
      "SELECT i FROM n;"
      "INSERT INTO hulls SELECT i, i * 37 % 100, i * 61 % 97, i % 5 - 2, i % 3 - 1,"
      " iif(i % 2, 'POLYGON((-8 -2, 8 -2, 9 2, -8 2, -8 -2))', 'POLYGON((100 0, 110 4, 104 9, 100 0))'), i % "
      "360 FROM n;"
      "INSERT INTO bodies SELECT i, i * 37 % 50, i * 61 % 47, i % 7, i % 5 - 2, i % 3 - 1, 0,"
      " 'TIN Z(((0 0 0, 4 0 0, 0 4 0, 0 0 0)), ((0 0 0, 4 0 0, 0 0 4, 0 0 0)), ((0 0 0, 0 4 0, 0 0 4, 0 0 "
      "0)),"
      " ((4 0 0, 0 4 0, 0 0 4, 4 0 0)))' FROM n;"
      "CREATE TABLE tiles(x0, x1, y0, y1);"
      "INSERT INTO tiles VALUES (NULL, 20, NULL, 30), (NULL, 20, 30, NULL), (20, 60, NULL, NULL), (60, NULL, "
      "NULL, NULL)");
  for (const char* table : {"hulls", "bodies"})
    for (const char* method : {"auto", "tree", "scan"}) {
      const std::string join =
          std::string("predictive_join(4, '") + table + "', 0.5, NULL, 0, '" + method + "', NULL, NULL";
      const std::string whole =
          db.rows(std::string("SELECT ") + all_columns + " FROM " + join + ") ORDER BY a, b");
      EXPECT_GT(whole.size(), 5000u);
      EXPECT_TRUE(db.rows(std::string("SELECT ") + all_columns + " FROM tiles CROSS JOIN " + join +
                          ", x0, x1, y0, y1) ORDER BY a, b") == whole)
          << table << " by " << method;
    }
}

TEST_F(Harbour, TilesSayWhatIsWrong) {
  db.exec("CREATE VIRTUAL TABLE cars USING moving_objects(id, x)");
  const auto error_of = [&](const std::string& inputs, const std::string& tbl = "ships") {
    const std::string what = " WHERE h = 9 AND tbl = '" + tbl + "' AND " + inputs;
    const std::string error = db.error_of("SELECT * FROM predictive_join" + what);
    EXPECT_EQ(db.error_of("SELECT * FROM predictive_explain" + what).substr(18), error.substr(15));
    return error.substr(17);
  };
  EXPECT_EQ(error_of("own_x0 = 3"),
            "own_x0 needs an explicit now, the same for all tiles; write WHERE now = ...");
  EXPECT_EQ(error_of("own_y1 = 3"),
            "own_y1 needs an explicit now, the same for all tiles; write WHERE now = ...");
  EXPECT_EQ(error_of("now = 0 AND own_x0 = 3 AND own_x1 = 1"),
            "own_x0 must be less than own_x1: own_x0 is 3, own_x1 is 1");
  EXPECT_EQ(error_of("now = 0 AND own_y0 = 3 AND own_y1 = 3"),
            "own_y0 must be less than own_y1: own_y0 is 3, own_y1 is 3");
  EXPECT_EQ(error_of("now = 0 AND own_y0 = 3", "cars"), "cars has 1 axis (x): leave out own_y0");
  EXPECT_EQ(error_of("now = 0 AND own_y1 = 3", "cars"), "cars has 1 axis (x): leave out own_y1");
  EXPECT_EQ(error_of("now = 0 AND own_x0 = 'west'"), "own_x0 must be a number, not 'west'");
  EXPECT_EQ(error_of("now = 0 AND own_x0 = 3 AND own_x1 = 1 AND method = 'tree'"),
            "own_x0 must be less than own_x1: own_x0 is 3, own_x1 is 1");
}

TEST_F(Harbour, AnInfinityIsNoBound) {
  const std::string join = "SELECT a, b, t FROM predictive_join WHERE h = 9 AND tbl = 'ships'";
  EXPECT_EQ(db.rows(join), "1|2|3.0");
  EXPECT_EQ(db.rows(join + " AND own_x0 = -1e999 AND own_y0 = 1e999 AND own_x1 = NULL"), "1|2|3.0");
  EXPECT_EQ(db.rows(join + " AND now = 0 AND own_x0 = 200"), "");
  EXPECT_EQ(db.rows(join + " AND now = 0 AND own_x1 = 0.5 AND own_x0 = -1e999"), "1|2|3.0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_explain WHERE h = 9 AND tbl = 'ships' AND now = 0 AND "
                    "own_x0 = 200"),
            "0");
}

}  // namespace
}  // namespace foresee::testing
