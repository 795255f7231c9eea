// predictive_sweep: each box contains its object, and bounds on box corners find the same rows as a check of
// every row.
#include "sqlite/functions/tiled_tables.h"
#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

TEST(Sweeps, AreFoundByTheirCorners) {
  for (const Layout& layout : tiled_layouts) {
    TiledTables tables(layout, SceneKind::one_fast, 1500);
    if (layout.has_t)  // reference times long before now, so that most digits cancel at now
      tables.db.exec("UPDATE objects SET t = t - 1e9, x = x - 1e9 * vx WHERE id % 5 = 0");
    Random random(9);
    for (int i = 0; i < 40; ++i) {
      std::string by_tree, by_row;
      for (const char* corner : {"x0", "x1", "y0", "y1"})
        for (const char* op : {" < ", " >= ", " > ", " <= "}) {
          if (random.below(6) || (layout.axes == 1 && *corner == 'y')) continue;
          // A corner of some object, or a random number.
          const std::string id = std::to_string(1 + random.below(1500));
          const std::string place =
              "(SELECT " + std::string(corner) + " FROM " + tables.sweep() + "WHERE +id = " + id + ")";
          by_tree += (by_tree.empty() ? "WHERE " : " AND ") + std::string(corner) + op + place;
          by_row += (by_row.empty() ? "WHERE +" : " AND +") + std::string(corner) + op + place;
        }
      const std::string select = "SELECT * FROM " + tables.sweep();
      EXPECT_TRUE(tables.db.rows(select + by_tree + " ORDER BY id") ==
                  tables.db.rows(select + by_row + " ORDER BY id"))
          << by_tree;
    }
  }
}

TEST(Sweeps, ContainTheirObjectsAndLittleMore) {
  Database db;
  build_table(db, "objects", random_scene({.layout = tiled_layouts[0], .count = 300, .seed = 4}));
  const std::string sweep = "predictive_sweep(3, 'objects', 2, 0) s";
  for (const char* time : {"0", "0.7", "1.5", "2.9", "3"})
    EXPECT_EQ(db.rows("SELECT count(*), sum(p.x - r - 1 >= s.x0 AND p.x + r + 1 <= s.x1 AND p.y - r - 1 >= "
                      "s.y0 AND p.y + r + 1 <= s.y1)"
                      " - count(*) FROM predictive_position(" +
                      std::string(time) + ") p JOIN objects USING (id) JOIN " + sweep + " USING (id)")
                  .substr(3),
              "|0");
  EXPECT_EQ(
      db.rows("SELECT max(s.x1 - s.x0 - 2 * r - 2 - abs(vx) * (3 - max(t, 0))) < 1e-12 FROM objects JOIN " +
              sweep + " USING (id)"),
      "1");
  EXPECT_EQ(db.rows("SELECT count(*) FROM objects WHERE t > 3 OR id NOT IN (SELECT id FROM " + sweep + ")"),
            "0");
}

TEST_F(Harbour, SweepsReturnTheInputsThatTheyUse) {
  const std::string inputs = db.rows("SELECT DISTINCT tbl, schema, now, within FROM predictive_join(1e6)");
  EXPECT_EQ(db.rows("SELECT DISTINCT tbl, schema, now, within FROM predictive_sweep(10)"), inputs);
}

TEST_F(Harbour, SweepsHaveTheColumnsOfTheirTable) {
  EXPECT_EQ(
      db.rows(
          "SELECT id, round(x0, 6), round(x1, 6), round(y0, 6), round(y1, 6), z0, z1 FROM predictive_sweep"
          " WHERE h = 10 AND within = 2 ORDER BY id"),
      "1|-4.0|14.0|-4.0|4.0|NULL|NULL\n2|-2.0|12.0|-2.0|2.0|NULL|NULL\n3|-2.0|2.0|97.0|101.0|NULL|NULL");
  db.exec(
      "CREATE VIRTUAL TABLE drones USING moving_objects(id, x, y, z); INSERT INTO drones VALUES (1, 0, 0, "
      "9), (2, 1e308, -1e308, 0)");
  EXPECT_EQ(db.rows("SELECT id, round(x1, 6), round(z0, 6), round(z1, 6) FROM predictive_sweep(10, 'drones', "
                    "2, 0, 8) WHERE id = 1"),
            "1|1.0|5.0|13.0");
  EXPECT_EQ(db.rows("SELECT x0, x1, y0, y1 FROM predictive_sweep(10, 'drones', 1.7e308, 0) WHERE id = 2"),
            "1.4999999999999907e+307|inf|-inf|-1.4999999999999907e+307");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_sweep(10, 'drones', 1.7e308, 0) WHERE x0 < -1e300 AND "
                    "x1 >= 1e307"),
            "1");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_sweep(10, 'ships') WHERE x0 < NULL"), "");
}

TEST_F(Harbour, SweepsSayWhatIsWrong) {
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_sweep"),
            "predictive_sweep: h is missing or NULL: write predictive_sweep(h, tbl, within, now, within_z, "
            "schema)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_sweep(-1)"),
            "predictive_sweep: h must be a finite number >= 0, not -1");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_sweep(1, 'ships', -1)"),
            "predictive_sweep: within must be a finite number >= 0, not -1");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_sweep(1, 'ships', 0, 0, 5)"),
            "predictive_sweep: within_z is for tables with x, y and z; leave it out here (within covers "
            "every axis)");
}

}  // namespace
}  // namespace foresee::testing
