// The columns shape and heading of tables with outlines: which tables may have them, accepted values, and
// values as read back.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* hull = "POLYGON((-8 -90, 8 -90, 8 60, 0 90, -8 60, -8 -90))";

struct OutlineColumns : ::testing::Test {
  OutlineColumns() {
    db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, shape, heading, r, +name)");
  }

  std::string create_error(const std::string& columns) {
    return db.error_of("CREATE VIRTUAL TABLE s USING moving_objects(" + columns + ")");
  }
  void insert(int id, const std::string& shape, const std::string& heading = "NULL") {
    db.exec("INSERT INTO ships VALUES(" + std::to_string(id) + ", 0, 0, 0, 6, 0, " + shape + ", " + heading +
            ", NULL, 'Anna')");
  }
  /// The error for this shape in row 7.
  std::string fault(const std::string& text, const std::string& heading = "0") {
    return db.error_of("INSERT INTO ships(id, t, x, y, shape, heading) VALUES(7, 0, 0, 0, " + text + ", " +
                       heading + ")");
  }

  Database db;
};

TEST_F(OutlineColumns, StandWithTwoAxesOrWithPrisms) {
  for (const char* columns : {"id, x, y, shape", "id, x, y, shape TEXT, heading REAL", "id, x, y, shape, r",
                              "id, x, y, z, shape, hz", "id, x, y, z, shape, heading, r, hz"}) {
    EXPECT_EQ(create_error(columns), "");
    db.exec("DROP TABLE s");
  }
}

TEST_F(OutlineColumns, AreRefusedWithWhatToWriteInstead) {
  EXPECT_EQ(create_error("id, x, shape"),
            "s: \"shape\": an outline needs two axes or three; add y, or write hx in place of shape");
  EXPECT_EQ(create_error("id, x, y, shape, hx, hy"),
            "s: \"shape\": a table has either outlines (shape) or boxes (hx, hy); leave one out: a box is an "
            "outline of four corners");
  EXPECT_EQ(create_error("id, x, y, shape, hz"), "s: \"hz\": there is no axis z; add z or leave hz out");
  EXPECT_EQ(create_error("id, x, y, heading"),
            "s: \"heading\": a heading turns an outline; add shape or leave heading out");
  EXPECT_EQ(create_error("id, x, y, shape REAL"),
            "s: \"shape REAL\": shape holds well-known text; write shape or shape TEXT");
}

TEST_F(OutlineColumns, ComeBackAsCanonicalTextAsWritten) {
  insert(1, "'  polygon ( ( -8 -90.0,8 -9e1, 8 60, 0 90, -8 60, -8 -90) ) '", "37.5");
  EXPECT_EQ(db.rows("SELECT shape, heading, r FROM ships"), std::string(hull) + "|37.5|0.0");
  EXPECT_EQ(db.rows("SELECT typeof(shape) FROM ships WHERE id = 1"), "text");
  insert(
      2,
      "'MULTIPOLYGON(((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5), (5.1 5.1, 5.2 5.1, 5.1 5.2, 5.1 5.1)))'");
  EXPECT_EQ(db.rows("SELECT shape FROM ships WHERE id = 2"),
            "MULTIPOLYGON(((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5), (5.1 5.1, 5.2 5.1, 5.1 5.2, 5.1 "
            "5.1)))");
}

TEST_F(OutlineColumns, MayBeNullOrEmpty) {
  insert(1, "NULL", "NULL");
  insert(2, "''", "45");
  EXPECT_EQ(db.rows("SELECT id, shape, heading FROM ships"), "1|NULL|0.0\n2|NULL|45.0");
}

TEST_F(OutlineColumns, SayWhatIsWrongAndWhere) {
  EXPECT_EQ(
      fault("7"),
      "ships.shape of row 7: 7 is no text: write well-known text as in 'POLYGON((0 0, 4 0, 0 3, 0 0))', "
      "or NULL");
  EXPECT_EQ(fault("x'01'").substr(0, 43), "ships.shape of row 7: a blob of 1 bytes is ");
  EXPECT_EQ(fault("'POLYGON((0 0, 4 0, 0 3))'"),
            "ships.shape of row 7: ring 1 is not closed: write the first corner (0 0) again at its end");
  EXPECT_EQ(fault("'POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))'"),
            "ships.shape of row 7: edges (0 0, 2 2) and (2 0, 0 2) cross");
  EXPECT_EQ(fault("'POLYGON((0 0, nan 2, 2 0, 0 0))'"),
            "ships.shape of row 7: at character 15: expected a number, found 'nan'");
  EXPECT_EQ(fault("'POLYGON Z((0 0 1, 2 2 1, 2 0 1, 0 0 1))'"),
            "ships.shape of row 7: at character 9: corners of a flat outline have two numbers: leave Z out");
  EXPECT_EQ(fault("'TIN Z(((0 0 0, 1 0 0, 0 1 0, 0 0 0)))'"),
            "ships.shape of row 7: at character 1: TIN is a mesh, as tables with x, y, z and without hz "
            "have: leave hz out, or write POLYGON or MULTIPOLYGON");
  EXPECT_EQ(fault("NULL", "511"),
            "ships.heading of row 7 is 511: write -360 to 360 (511 is \"not available\" in AIS: write the "
            "course, or NULL for shape and half the length as r)");
  EXPECT_EQ(fault("NULL", "-361"),
            "ships.heading of row 7 is -361: beyond a full turn; write degrees from -360 to 360");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships_shape"), "0");
}

TEST_F(OutlineColumns, AreRefusedWhereATurnWouldJoinRings) {
  // The hole touches an edge between its corners: after a rotation, an ulp would separate them or make them
  // overlap.
  const std::string touching = "'POLYGON((0 0, 9 0, 9 9, 0 9, 0 0), (0 4, 3 3, 3 5, 0 4))'";
  EXPECT_EQ(fault(touching, "90"), "");
  db.exec("DELETE FROM ships");
  EXPECT_NE(fault(touching, "30").find("ships.shape of row 7: turned by 30 degrees"), std::string::npos)
      << fault(touching, "30");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
}

TEST_F(OutlineColumns, AreNotReadByAnUpdateThatDoesNotNameThem) {
  insert(1, "'" + std::string(hull) + "'", "37.5");
  insert(2, "NULL");
  sqlite3_set_authorizer(
      db.handle(),
      [](void*, int, const char* table, const char*, const char*, const char*) {
        return table != nullptr && std::string(table) == "ships_shape" ? SQLITE_DENY : SQLITE_OK;
      },
      nullptr);
  db.exec("UPDATE ships SET x = x + 1, vx = 0");
  db.exec("UPDATE ships SET id = 11 WHERE id = 1");
  sqlite3_set_authorizer(db.handle(), nullptr, nullptr);
  EXPECT_EQ(db.rows("SELECT id, x, shape, heading FROM ships ORDER BY id"),
            "2|1.0|NULL|0.0\n11|1.0|" + std::string(hull) + "|37.5");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST_F(OutlineColumns, ChangeSeparately) {
  insert(1, "'POLYGON((0 0, 10 0, 0 10, 0 0))'");
  const std::string zone = "SELECT count(*) FROM predictive_window(0, 'ships', 1, 2, -2, -1)";
  EXPECT_EQ(db.rows(zone), "0");
  db.exec("UPDATE ships SET heading = 90");
  EXPECT_EQ(db.rows(zone), "1");
  EXPECT_EQ(db.rows("SELECT shape FROM ships"), "POLYGON((0 0, 10 0, 0 10, 0 0))");
  db.exec("UPDATE ships SET shape = NULL");
  EXPECT_EQ(db.rows(zone), "0");
  EXPECT_EQ(db.rows("SELECT shape, heading FROM ships"), "NULL|90.0");
  db.exec("UPDATE ships SET heading = -90, shape = 'POLYGON((0 0, -4 0, 0 4, 0 0))'");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_window(0, 'ships', -4, -3, -1, 0)"), "1");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST_F(OutlineColumns, AreCopiedFromAnotherTableRowByRow) {
  db.exec("CREATE TABLE feed(id, shape, heading)");
  db.exec("INSERT INTO feed VALUES(1, 'POLYGON((0 0, 1 0, 0 1, 0 0))', 10), (2, NULL, 20)");
  db.exec("INSERT INTO ships(id, t, x, y, shape, heading) SELECT id, 0, id, 0, shape, heading FROM feed");
  db.exec("UPDATE ships SET heading = feed.heading + 1 FROM feed WHERE feed.id = ships.id");
  db.exec(
      "INSERT OR REPLACE INTO ships(id, t, x, y, shape) VALUES(2, 0, 0, 0, 'POLYGON((0 0, 2 0, 0 2, 0 0))')");
  EXPECT_EQ(db.rows("SELECT id, shape, heading FROM ships ORDER BY id"),
            "1|POLYGON((0 0, 1 0, 0 1, 0 0))|11.0\n2|POLYGON((0 0, 2 0, 0 2, 0 0))|0.0");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST_F(OutlineColumns, HaveALimitOfCorners) {
  const auto long_quay = [](int corners) {
    const std::string last = std::to_string(corners - 3);
    return "WITH n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < " + last +
           ") SELECT 'POLYGON((-1 -1, ' || group_concat(i || ' 0', ', ') || ', " + last +
           " -1, -1 -1))' FROM n";
  };
  // Corners on one straight line count as corners.
  EXPECT_EQ(fault("(" + long_quay(65537) + ")").find("ships.shape of row 7: 65537 corners; at most 65536"),
            0u)
      << fault("(" + long_quay(65537) + ")");
  EXPECT_EQ(fault("(" + long_quay(65536) + ")"), "");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "1");
}

TEST(OutlineStorage, IsListedInTheFeaturesOfItsTables) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, shape, heading, r)");
  EXPECT_EQ(db.rows("SELECT value FROM ships_meta WHERE key = 'features'"), "blocks,shapes");
  db.exec("CREATE VIRTUAL TABLE plain USING moving_objects(id, x, y, r)");
  EXPECT_EQ(db.rows("SELECT value FROM plain_meta WHERE key = 'features'"), "blocks");
  EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema WHERE name = 'plain_shape'"), "0");
}

}  // namespace
}  // namespace foresee::testing
