// The columns shape and heading of tables with meshes: accepted values, errors, and values as read back.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

const std::string roof = "TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)), ((4 0 3, 0 0 3, 0 -5 4, 4 0 3)))";
const std::string pyramid =
    "POLYHEDRALSURFACE Z(((-1 -1 0, 1 -1 0, 0 0 2, -1 -1 0)), ((1 -1 0, 1 1 0, 0 0 2, 1 -1 0)), "
    "((1 1 0, -1 1 0, 0 0 2, 1 1 0)), ((-1 1 0, -1 -1 0, 0 0 2, -1 1 0)), ((-1 -1 0, 1 1 0, 1 -1 0, -1 -1 "
    "0)), "
    "((1 1 0, -1 -1 0, -1 1 0, 1 1 0)))";

struct MeshColumns : ::testing::Test {
  MeshColumns() {
    db.exec(
        "CREATE VIRTUAL TABLE drones USING moving_objects(id, t, x, y, z, vx, vy, vz, shape, heading, r, "
        "+name)");
  }

  void insert(int id, const std::string& shape, const std::string& heading = "NULL") {
    db.exec("INSERT INTO drones(id, t, x, y, z, vx, shape, heading) VALUES(" + std::to_string(id) +
            ", 0, 0, 0, 0, 6, " + shape + ", " + heading + ")");
  }
  /// The error for this shape in row 7.
  std::string fault(const std::string& text, const std::string& heading = "0") {
    return db.error_of("INSERT INTO drones(id, t, x, y, z, shape, heading) VALUES(7, 0, 0, 0, 0, " + text +
                       ", " + heading + ")");
  }

  Database db;
};

TEST_F(MeshColumns, StandWithThreeAxesAndWithoutHz) {
  for (const char* columns :
       {"id, x, y, z, shape", "id, x, y, z, shape TEXT, heading REAL", "id, x, y, z, r, shape",
        "id, t, x, y, z, vx, vy, vz, ax, ay, az, shape, heading, r, until"}) {
    EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE s USING moving_objects(" + std::string(columns) + ")"), "");
    EXPECT_EQ(db.rows("SELECT value FROM s_meta WHERE key = 'features'"), "blocks,shapes,meshes");
    db.exec("DROP TABLE s");
  }
  // With hz an outline is a prism.
  db.exec("CREATE VIRTUAL TABLE sheds USING moving_objects(id, x, y, z, shape, hz)");
  EXPECT_EQ(db.rows("SELECT value FROM sheds_meta WHERE key = 'features'"), "blocks,shapes");
  EXPECT_EQ(
      db.error_of("INSERT INTO sheds VALUES(7, 0, 0, 0, '" + roof + "', 3)"),
      "sheds.shape of row 7: at character 1: TIN is a mesh, as tables with x, y, z and without hz have: "
      "leave hz out, or write POLYGON or MULTIPOLYGON");
}

TEST_F(MeshColumns, ComeBackAsCanonicalTextAsWritten) {
  insert(1, "' srid=1;tin  z ( ( ( 0 0 3.0,4 -0 3e0, 0 5 4, 0 0 3) ), ((4 0 3, 0 0 3, 0 -5 4, 4 0 3)))'",
         "37.5");
  insert(2, "'" + pyramid + "'");
  insert(3, "NULL");
  insert(4, "''", "45");
  EXPECT_EQ(db.rows("SELECT id, shape, heading FROM drones"),
            "1|" + roof + "|37.5\n2|" + pyramid + "|0.0\n3|NULL|0.0\n4|NULL|45.0");
  EXPECT_EQ(db.rows("SELECT typeof(shape) FROM drones WHERE id = 1"), "text");
  db.exec("INSERT INTO drones(drones) VALUES('integrity-check')");
}

TEST_F(MeshColumns, SayWhatIsWrongAndWhere) {
  EXPECT_EQ(
      fault("7"),
      "drones.shape of row 7: 7 is no text: write well-known text as in 'TIN Z(((0 0 0, 4 0 0, 0 3 1, 0 0 "
      "0)))', or NULL");
  EXPECT_EQ(fault("x'01'").substr(0, 44), "drones.shape of row 7: a blob of 1 bytes is ");
  EXPECT_EQ(
      fault("'POLYGON((0 0, 4 0, 0 3, 0 0))'"),
      "drones.shape of row 7: at character 1: POLYGON is a flat outline, which needs hz: declare hz in the "
      "table, or write TIN Z, POLYHEDRALSURFACE Z or MULTIPOLYGON Z");
  EXPECT_EQ(fault("'TIN Z(((0 0 0, 1 1 1, 2 2 2, 0 0 0)))'"),
            "drones.shape of row 7: face 1 (0 0 0, 1 1 1, 2 2 2) has no area: its corners lie on one line");
  EXPECT_EQ(fault("'POLYHEDRALSURFACE Z(((0 0 0, 1 0 0, 0 1 0, 0 0 0)))'").substr(0, 67),
            "drones.shape of row 7: edge (0 0 0, 1 0 0) belongs to 1 triangle, i");
  EXPECT_EQ(fault("'" + roof + "'", "361"),
            "drones.heading of row 7 is 361: beyond a full turn; write degrees from -360 to 360");
  EXPECT_EQ(fault("'TIN Z(((0 0 0, 4 0 0, 1 1e-30 0, 0 0 0)))'", "45").substr(0, 59),
            "drones.shape of row 7: turned by 45 degrees its face 1 (0 0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM drones"), "0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM drones_shape"), "0");
}

TEST_F(MeshColumns, AreNotReadByAnUpdateThatDoesNotNameThem) {
  insert(1, "'" + roof + "'", "37.5");
  insert(2, "NULL");
  sqlite3_set_authorizer(
      db.handle(),
      [](void*, int, const char* table, const char*, const char*, const char*) {
        return table != nullptr && std::string(table) == "drones_shape" ? SQLITE_DENY : SQLITE_OK;
      },
      nullptr);
  db.exec("UPDATE drones SET x = x + 1, vz = 2");
  sqlite3_set_authorizer(db.handle(), nullptr, nullptr);
  EXPECT_EQ(db.rows("SELECT id, x, shape, heading FROM drones ORDER BY id"),
            "1|1.0|" + roof + "|37.5\n2|1.0|NULL|0.0");
  db.exec("UPDATE drones SET heading = 90");
  EXPECT_EQ(db.rows("SELECT count(*) FROM drones_shape"), "1");
  db.exec("INSERT INTO drones(drones) VALUES('integrity-check')");
}

TEST_F(MeshColumns, HaveALimitOfTriangles) {
  const auto fan = [](int triangles) {
    return "WITH n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < " + std::to_string(triangles - 1) +
           ") SELECT 'TIN Z(' || group_concat('((0 0 5, ' || i || ' 1 0, ' || (i + 1) || ' 1 0, 0 0 5))', ', "
           "') || "
           "')' FROM n";
  };
  EXPECT_EQ(fault("(" + fan(65537) + ")"),
            "drones.shape of row 7: 65537 triangles; at most 65536: simplify the mesh");
  EXPECT_EQ(fault("(" + fan(65536) + ")", "30"), "");
  db.exec("INSERT INTO drones(drones) VALUES('integrity-check')");
}

TEST_F(MeshColumns, AreRefusedWithZonesAndLimitsAlongZ) {
  insert(1, "'" + roof + "'");
  EXPECT_EQ(
      db.error_of(
          "SELECT * FROM predictive_window(9, 'drones') WHERE zone = 'POLYGON((0 0, 4 0, 0 3, 0 0))'"),
      "predictive_window: no distance is defined between meshes and a zone, which is flat: write x0 to z1, "
      "or declare hz in the table to make prisms");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_join(9, 'drones', 0, NULL, 0, NULL, 5)"),
            "predictive_join: within_z is not for meshes: leave it out; within covers every axis");
}

TEST_F(MeshColumns, HaveNoDistanceFromUprightShapes) {
  db.exec("CREATE VIRTUAL TABLE tanks USING moving_objects(id, x, y, z, r, hz)");
  db.exec("CREATE VIRTUAL TABLE sheds USING moving_objects(id, x, y, z, shape, hz)");
  for (const bool filled : {false, true}) {
    if (filled) insert(1, "'" + roof + "'");
    EXPECT_EQ(
        db.error_of("SELECT * FROM predictive_join(9, 'drones', 0, 'tanks')"),
        "predictive_join: no distance is defined between drones (meshes) and tanks (cylinders): leave hz out "
        "of tanks to make them balls");
    EXPECT_EQ(
        db.error_of("SELECT * FROM predictive_join(9, 'sheds', 0, 'drones')"),
        "predictive_join: no distance is defined between drones (meshes) and sheds (prisms): leave hz out of "
        "sheds and declare meshes");
  }
}

}  // namespace
}  // namespace foresee::testing
