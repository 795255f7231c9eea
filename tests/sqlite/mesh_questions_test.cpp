// Queries of tables with meshes: every method, thread count and interface gives the same rows to the last
// bit. A mesh of a box, a ball or a prism gives the rows of that shape.
#include <sstream>

#include "sanitized.h"
#include "sqlite/database.h"
#include "sqlite/random_numbers.h"

namespace foresee::testing {
namespace {

using Place = std::array<double, 3>;

std::string mesh_text(const std::string& word, const std::vector<Place>& corners,
                      const std::vector<std::array<std::size_t, 3>>& faces) {
  const auto corner = [&](std::size_t i) {
    return shown_exactly(corners[i][0]) + ' ' + shown_exactly(corners[i][1]) + ' ' +
           shown_exactly(corners[i][2]);
  };
  std::string text = word;
  for (const auto& [a, b, c] : faces)
    text += (text == word ? "(((" : ", ((") + corner(a) + ", " + corner(b) + ", " + corner(c) + ", " +
            corner(a) + "))";
  return text + ')';
}

/// The mesh of a prism over a triangle, between two heights.
std::string prism(const std::array<Place, 3>& flat, double hz) {
  std::vector<Place> corners;
  for (const double z : {-hz, hz})
    for (const Place& place : flat) corners.push_back({place[0], place[1], z});
  return mesh_text("POLYHEDRALSURFACE Z", corners,
                   {{0, 1, 2}, {3, 5, 4}, {0, 1, 3}, {1, 3, 4}, {1, 2, 4}, {2, 4, 5}, {2, 0, 5}, {0, 5, 3}});
}

std::string box(double hx, double hy, double hz) {
  std::vector<Place> corners;
  for (const double z : {-hz, hz})
    for (const double y : {-hy, hy})
      for (const double x : {-hx, hx}) corners.push_back({x, y, z});
  return mesh_text("POLYHEDRALSURFACE Z", corners,
                   {{0, 1, 3},
                    {0, 3, 2},
                    {4, 5, 7},
                    {4, 7, 6},
                    {0, 1, 5},
                    {0, 5, 4},
                    {2, 3, 7},
                    {2, 7, 6},
                    {0, 2, 6},
                    {0, 6, 4},
                    {1, 3, 7},
                    {1, 7, 5}});
}

/// A tetrahedron, solid or not, or some triangles that cross, often away from the object's position.
std::string debris(Engine& random, double size) {
  std::vector<Place> corners;
  const double aside = drawn(random, 0, 1) * drawn(random, -2.0, 2.0) * size;
  for (int i = 0; i < 6; ++i)
    corners.push_back({aside + std::round(drawn(random, -size, size) * 8) / 8, drawn(random, -size, size),
                       drawn(random, -size, size)});
  const int kind = drawn(random, 0, 3);
  if (kind == 3) return mesh_text("TIN Z", corners, {{0, 1, 2}, {3, 4, 5}, {0, 3, 5}});
  const char* words[] = {"POLYHEDRALSURFACE Z", "MULTIPOLYGON Z", "TIN Z"};
  return mesh_text(words[kind], corners, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 2, 3}});
}

/// t, x, y, z, vx, vy, vz, in multiples of a quarter so that many objects touch exactly.
std::string motion(Engine& random, double land) {
  std::ostringstream row;
  row << drawn(random, -2, 2);
  for (const double limit : {land, land, land / 4})
    row << ", " << std::round(drawn(random, 0.0, limit) * 4) / 4;
  for (int axis = 0; axis < 3; ++axis) row << ", " << drawn(random, -4, 4);
  return row.str();
}

constexpr const char* moving = "id, t, x, y, z, vx, vy, vz, ";
constexpr int mesh_scenes = sanitized ? 2 : 4;

void make(Database& db, const std::string& table, const std::string& columns) {
  db.exec("CREATE VIRTUAL TABLE " + table + " USING moving_objects(" + moving + columns + ")");
}

struct Field {
  explicit Field(std::uint64_t seed) : random(seed) {
    make(db, "s", "shape, heading, r, until");
    count = drawn(random, 20, 90);
    const double size = drawn(random, 1.0, 5.0), land = 9 * std::sqrt(count);
    db.exec("BEGIN");
    for (int id = 1; id <= count; ++id) {
      std::ostringstream row;
      row << "INSERT INTO s VALUES(" << id << ", " << motion(random, land)
          << (id % 7 == 0 ? ", NULL" : ", '" + debris(random, size) + "'") << ", "
          << (id % 3 == 0   ? 0
              : id % 3 == 1 ? drawn(random, -4, 4) * 90
                            : drawn(random, -360.0, 360.0))
          << ", " << (id % 2 == 0 ? 0 : drawn(random, 0.0, size)) << (id % 5 == 0 ? ", 9)" : ", NULL)");
      db.exec(row.str());
    }
    db.exec("COMMIT");
  }
  std::string join(const std::string& method, const std::string& also = "") {
    return db.rows("SELECT * FROM predictive_join WHERE h = 20 AND tbl = 's' AND now = 3 AND within = " +
                   within + " AND method = '" + method + "'" + also + " ORDER BY a, b");
  }

  Engine random;
  int count;
  std::string within = drawn(random, 0, 1) == 0 ? "0" : "1.75";
  Database db;
};

TEST(MeshQuestions, EveryMethodGivesTheRowsOfAllPairs) {
  for (int seed = 0; seed < mesh_scenes; ++seed) {
    Field field(static_cast<std::uint64_t>(seed));
    const std::string plain = field.join("scan");
    EXPECT_GT(plain.size(), 100u);
    EXPECT_EQ(plain.find("error"), std::string::npos) << plain;
    for (const char* method : {"auto", "grid", "tree", "gpcd"})
      EXPECT_EQ(field.join(method), plain) << "seed " << seed << ' ' << method;
    field.db.exec("PRAGMA threads = 3");
    EXPECT_EQ(field.join("grid"), plain) << "seed " << seed << ", with helpers";
    for (const char* id : {"1", "7", "8"})
      for (const char* column : {" AND a = ", " AND b = "}) {
        const std::string side = std::string(column) + id;
        EXPECT_EQ(field.join("auto", side), field.join("scan", side)) << "seed " << seed << side;
      }
    EXPECT_EQ(field.db.rows("SELECT n_after FROM predictive_explain(20, 's', " + field.within +
                            ", NULL, 3) WHERE stage = 'refinement'"),
              field.db.rows("SELECT count(*) FROM predictive_join(20, 's', " + field.within + ", NULL, 3)"));
  }
}

TEST(MeshQuestions, TheSameTableAsOtherGivesBothOrders) {
  Field field(77);
  const std::string twice =
      "SELECT min(a, b) p, max(a, b) q, t, t_end FROM predictive_join(20, 's', 1, 's', 3)";
  EXPECT_EQ(field.db.rows("SELECT DISTINCT * FROM (" + twice + ") ORDER BY p, q"),
            field.db.rows("SELECT a, b, t, t_end FROM predictive_join(20, 's', 1, NULL, 3) ORDER BY a, b"));
}

TEST(MeshQuestions, WindowsByTheTreeGiveTheRowsOfAScan) {
  for (int seed = 0; seed < mesh_scenes; ++seed) {
    Field field(static_cast<std::uint64_t>(seed));
    for (const char* where :
         {" AND x0 = 10 AND x1 = 40 AND y1 = 50 AND z0 = 2", " AND x0 = 30", " AND z1 = 5 AND wvz = 1",
          " AND x0 = 0 AND x1 = 30 AND y0 = 0 AND y1 = 30 AND z0 = 0 AND z1 = 9 AND wvx = 3"}) {
      const auto rows_by = [&](const char* method) {
        return field.db.rows(
            "SELECT * FROM predictive_window WHERE h = 20 AND tbl = 's' AND now = 3 AND method = '" +
            std::string(method) + "'" + where + " ORDER BY id");
      };
      EXPECT_EQ(rows_by("tree"), rows_by("scan")) << "seed " << seed << where;
      EXPECT_EQ(rows_by("scan").find("error"), std::string::npos) << rows_by("scan");
      EXPECT_FALSE(rows_by("tree").empty());
    }
  }
}

TEST(MeshQuestions, ABoxIsTheMeshOfItsFaces) {
  for (int seed = 0; seed < mesh_scenes; ++seed) {
    Engine random(static_cast<std::uint64_t>(seed));
    Database db;
    make(db, "boxes", "hx, hy, hz"), make(db, "meshes", "shape, heading"), make(db, "points", "r");
    db.exec("BEGIN");
    for (int id = 1; id <= 60; ++id) {
      const std::string where = std::to_string(id) + ", " + motion(random, 50);
      const double x = drawn(random, 1, 12) / 4.0, y = drawn(random, 1, 12) / 4.0,
                   z = drawn(random, 1, 12) / 4.0;
      std::ostringstream half;
      half << x << ", " << y << ", " << z;
      db.exec("INSERT INTO boxes VALUES(" + where + ", " + half.str() + ")");
      // Turned by a right angle a box of other extents is the same.
      db.exec("INSERT INTO meshes VALUES(" + where + ", '" + (id % 3 == 0 ? box(y, x, z) : box(x, y, z)) +
              "', " +
              (id % 3 == 0   ? "90"
               : id % 3 == 1 ? "0"
                             : "-180") +
              ")");
      db.exec("INSERT INTO points VALUES(" + where + ", 0)");
    }
    db.exec("COMMIT");
    const auto join = [&](const std::string& a, const std::string& b) {
      return db.rows("SELECT * FROM predictive_join(20, '" + a + "', 0, '" + b +
                     "', 1) WHERE a <> b ORDER BY a, b");
    };
    const std::string plain = join("boxes", "boxes");
    EXPECT_GT(plain.size(), 500u);
    EXPECT_EQ(join("meshes", "meshes"), plain) << seed;
    EXPECT_EQ(join("meshes", "boxes"), plain) << seed;
    EXPECT_EQ(join("boxes", "meshes"), plain) << seed;
    EXPECT_EQ(join("meshes", "points"), join("boxes", "points")) << seed;
    EXPECT_EQ(join("points", "meshes"), join("points", "boxes")) << seed;
    for (const char* window :
         {"8, 'T', 10, 30, 10, 30, 2, 6, 1", "8, 'T', NULL, 20, NULL, NULL, 5, NULL, 1, 2, 0, -1"}) {
      const auto rows_by = [&](const std::string& table) {
        std::string arguments = window;
        arguments.replace(arguments.find('T'), 1, table);
        return db.rows("SELECT * FROM predictive_window(" + arguments + ") ORDER BY id");
      };
      EXPECT_EQ(rows_by("meshes"), rows_by("boxes")) << seed << ' ' << window;
      EXPECT_GT(rows_by("meshes").size(), 20u);
    }
  }
}

TEST(MeshQuestions, WithoutAMeshARowIsABall) {
  for (int seed = 0; seed < mesh_scenes; ++seed) {
    Engine random(static_cast<std::uint64_t>(seed));
    Database db;
    make(db, "balls", "r"), make(db, "meshes", "shape, r"), make(db, "points", "r"),
        make(db, "boxes", "hx, hy, hz");
    db.exec("BEGIN");
    for (int id = 1; id <= 60; ++id) {
      const std::string where = std::to_string(id) + ", " + motion(random, 50);
      const std::string r = std::to_string(id % 4);
      db.exec("INSERT INTO balls VALUES(" + where + ", " + r + ")");
      db.exec("INSERT INTO meshes VALUES(" + where + ", NULL, " + r + ")");
      db.exec("INSERT INTO boxes VALUES(" + where + ", 1, 2, 3)");
    }
    db.exec("COMMIT");
    for (const std::string within : {"0", "2.5"}) {
      const auto join = [&](const std::string& a, const std::string& b) {
        return db.rows("SELECT * FROM predictive_join(20, '" + a + "', " + within + ", '" + b +
                       "', 1) WHERE a <> b ORDER BY a, b");
      };
      EXPECT_EQ(join("meshes", "meshes"), join("balls", "balls")) << seed;
      EXPECT_EQ(join("meshes", "balls"), join("balls", "balls")) << seed;
      EXPECT_EQ(join("boxes", "meshes"), join("boxes", "balls")) << seed;
      EXPECT_GT(join("balls", "balls").size(), 300u);
    }
    const auto window = [&](const std::string& table) {
      return db.rows("SELECT * FROM predictive_window(8, '" + table +
                     "', 10, 30, 10, 30, 2, 6, 1) ORDER BY id");
    };
    EXPECT_EQ(window("meshes"), window("balls")) << seed;
  }
}

TEST(MeshQuestions, APrismIsTheMeshOfItsFaces) {
  for (int seed = 0; seed < mesh_scenes; ++seed) {
    Engine random(static_cast<std::uint64_t>(seed));
    Database db;
    make(db, "prisms", "shape, heading, hz"), make(db, "meshes", "shape, heading");
    db.exec("BEGIN");
    for (int id = 1; id <= 60; ++id) {
      std::array<Place, 3> flat;
      for (Place& place : flat) place = {drawn(random, -5.0, 5.0), drawn(random, -5.0, 5.0), 0};
      std::string outline = "POLYGON((";
      for (const Place& place : {flat[0], flat[1], flat[2]})
        outline += shown_exactly(place[0]) + ' ' + shown_exactly(place[1]) + ", ";
      outline += shown_exactly(flat[0][0]) + ' ' + shown_exactly(flat[0][1]) + "))";
      const std::string where = std::to_string(id) + ", " + motion(random, 50);
      const std::string heading = std::to_string(id * 17 % 360);
      db.exec("INSERT INTO prisms VALUES(" + where + ", '" + outline + "', " + heading + ", 1.5)");
      db.exec("INSERT INTO meshes VALUES(" + where + ", '" + prism(flat, 1.5) + "', " + heading + ")");
    }
    db.exec("COMMIT");
    const auto join = [&](const std::string& table) {
      return db.rows("SELECT * FROM predictive_join(20, '" + table + "', 0, NULL, 1) ORDER BY a, b");
    };
    EXPECT_EQ(join("meshes"), join("prisms")) << seed;
    EXPECT_GT(join("meshes").size(), 500u);
  }
}

// A terrain is a surface and touches no object below it; a solid touches the objects inside.
TEST(MeshQuestions, ASurfaceIsHollowAndASolidIsNot) {
  Database db;
  make(db, "s", "shape"), make(db, "p", "r");
  const std::string solid = box(5, 5, 5), hollow = "TIN Z" + solid.substr(19);
  db.exec("INSERT INTO s VALUES(1, 0, 0, 0, 0, 0, 0, 0, '" + solid + "'), (2, 0, 0, 0, 0, 0, 0, 0, '" +
          hollow + "')");
  db.exec("INSERT INTO p VALUES(1, 0, 0, 0, 0, 1, 0, 0, 0), (2, 0, 0, 0, 0, 0, 0, 0, 1)");
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end FROM predictive_join(10, 's', 0, 'p') ORDER BY a, b"),
            "1|1|0.0|5.0\n1|2|0.0|10.0\n2|1|5.0|5.0");
}

TEST(MeshQuestions, QueriesSeeChanges) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE s USING moving_objects(id, t, x, y, z, vx, vy, vz, shape, heading)");
  // A rod of ten along y, and a point ten beside it.
  db.exec(
      "INSERT INTO s VALUES(1, 0, 0, 0, 0, 0, 0, 0, 'TIN Z(((0 0 0, 0 10 0, 0 5 1, 0 0 0)))', 0), "
      "(2, 0, 10, 0, 0, 0, 0, 0, NULL, 0)");
  const std::string question = "SELECT a, b FROM predictive_join(5, 's')";
  EXPECT_EQ(db.rows(question), "");
  db.exec("UPDATE s SET heading = 90 WHERE id = 1");
  EXPECT_EQ(db.rows(question), "1|2");
  db.exec("BEGIN; UPDATE s SET shape = NULL");
  EXPECT_EQ(db.rows(question), "");
  db.exec("ROLLBACK");
  EXPECT_EQ(db.rows(question), "1|2");
}

}  // namespace
}  // namespace foresee::testing
