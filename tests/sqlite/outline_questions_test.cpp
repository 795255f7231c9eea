// Queries of tables with outlines: every method, thread count and interface gives the same rows to the last
// bit. An outline of a box, a disc or a window gives the rows of that shape.
#include <sstream>

#include "sanitized.h"
#include "sqlite/database.h"
#include "sqlite/random_numbers.h"

namespace foresee::testing {
namespace {

/// A concave star, often away from the object's position.
std::string star(Engine& random, double size) {
  const int corners = drawn(random, 3, 9);
  const double x = drawn(random, 0, 1) * drawn(random, -3.0, 3.0) * size, y = drawn(random, -1.0, 1.0) * size;
  std::string text = "POLYGON((", first;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.28 * i / corners, reach = size * drawn(random, 0.2, 1.0);
    const std::string corner = shown_exactly(std::round(8 * (x + reach * std::cos(angle))) / 8) + " " +
                               shown_exactly(y + reach * std::sin(angle));
    if (i == 0) first = corner;
    text += corner + ", ";
  }
  return text + first + "))";
}

struct Scene {
  explicit Scene(std::uint64_t seed) : random(seed) {
    axes = drawn(random, 2, 3);
    db.exec("CREATE VIRTUAL TABLE s USING moving_objects(id, t, x, y" + z(", z") + ", vx, vy" + z(", vz") +
            ", shape, heading, r" + z(", hz") + ", until)");
    count = drawn(random, 20, 150);
    size = drawn(random, 1, 8);
    const double land = 12 * std::sqrt(count);
    db.exec("BEGIN");
    for (int id = 1; id <= count; ++id) {
      std::ostringstream row;
      row << "INSERT OR IGNORE INTO s VALUES(" << id << ", " << drawn(random, -3, 3);
      for (int axis = 0; axis < axes; ++axis) row << ", " << drawn(random, 0.0, axis < 2 ? land : 8);
      for (int axis = 0; axis < axes; ++axis) row << ", " << drawn(random, -4, 4);
      row << (id % 7 == 0 ? ", NULL" : ", '" + star(random, size) + "'");
      row << ", "
          << (id % 3 == 0   ? 0
              : id % 3 == 1 ? drawn(random, -4, 4) * 90
                            : drawn(random, -360.0, 360.0));
      row << ", " << (id % 2 == 0 ? 0 : drawn(random, 0.0, 1.0 * size)) << z(", 1.5");
      row << (id % 5 == 0 ? ", 9)" : ", NULL)");
      db.exec(row.str());
    }
    db.exec("COMMIT");
  }

  std::string z(const std::string& text) const { return axes == 3 ? text : ""; }
  std::string join(const std::string& method, const std::string& also = "") {
    return db.rows("SELECT * FROM predictive_join WHERE h = 20 AND tbl = 's' AND now = 3 AND within = " +
                   within + " AND method = '" + method + "'" + also + " ORDER BY a, b");
  }

  Engine random;
  int axes, count, size;
  std::string within = drawn(random, 0, 1) == 0 ? "0" : "1.75";
  Database db;
};

constexpr int scenes = sanitized ? 3 : 10;

TEST(OutlineQuestions, EveryMethodGivesTheRowsOfAllPairs) {
  for (int seed = 0; seed < scenes; ++seed) {
    Scene scene(static_cast<std::uint64_t>(seed));
    const std::string plain = scene.join("scan");
    EXPECT_GT(plain.size(), 100u);
    for (const char* method : {"auto", "grid", "tree", "gpcd"})
      EXPECT_EQ(scene.join(method), plain) << "seed " << seed << ' ' << method;
    scene.db.exec("PRAGMA threads = 3");
    EXPECT_EQ(scene.join("grid"), plain) << "seed " << seed << ", with helpers";
    for (const char* id : {"1", "7", "8"}) {
      const std::string side = std::string(" AND a = ") + id;
      EXPECT_EQ(scene.join("auto", side), scene.join("scan", side)) << "seed " << seed << " id " << id;
    }
    EXPECT_EQ(scene.db.rows("SELECT n_after FROM predictive_explain(20, 's', " + scene.within +
                            ", NULL, 3) WHERE stage = 'refinement'"),
              scene.db.rows("SELECT count(*) FROM predictive_join(20, 's', " + scene.within + ", NULL, 3)"));
  }
}

TEST(OutlineQuestions, TheSameTableAsOtherGivesBothOrders) {
  Scene scene(77);
  const std::string twice =
      "SELECT min(a, b) p, max(a, b) q, t, t_end FROM predictive_join(20, 's', 1, 's', 3)";
  EXPECT_EQ(scene.db.rows("SELECT DISTINCT * FROM (" + twice + ") ORDER BY p, q"),
            scene.db.rows("SELECT a, b, t, t_end FROM predictive_join(20, 's', 1, NULL, 3) ORDER BY a, b"));
}

TEST(OutlineQuestions, WindowsAndZonesByTheTreeGiveTheRowsOfAScan) {
  for (int seed = 0; seed < scenes; ++seed) {
    Scene scene(static_cast<std::uint64_t>(seed));
    const std::string zone = star(scene.random, 40);
    for (const auto& where :
         {std::string(" AND x0 = 10 AND x1 = 60 AND y1 = 50"), std::string(" AND x0 = 30"),
          std::string(" AND y1 = 20"), " AND zone = '" + zone + "'",
          " AND zone = '" + zone + "' AND wvx = 2" + scene.z(" AND z0 = 4")}) {
      const auto rows_by = [&](const char* method) {
        return scene.db.rows(
            "SELECT * FROM predictive_window WHERE h = 20 AND tbl = 's' AND now = 3 AND "
            "method = '" +
            std::string(method) + "'" + where + " ORDER BY id");
      };
      EXPECT_EQ(rows_by("tree"), rows_by("scan")) << "seed " << seed << where;
      EXPECT_TRUE(where.find("zone") != std::string::npos || !rows_by("tree").empty());
    }
  }
}

// A window without a bound on one side has no limit there, even where an object's reach overflows a double.
TEST(OutlineQuestions, AWindowWithoutAFaceIsOpenHoweverFarItIs) {
  Database db;
  for (const char* kind : {"shape", "hx, hy"}) {
    db.exec("CREATE VIRTUAL TABLE s USING moving_objects(id, t, x, y, vx, vy, " + std::string(kind) + ")");
    db.exec("INSERT INTO s(id, t, x, y) VALUES (1, -1.7e308, 10, 0), (2, 1.7e308, 1e300, 0)");
    EXPECT_EQ(
        db.rows(
            "SELECT id, dt, dt_end FROM predictive_window WHERE h = 1 AND tbl = 's' AND now = 1.7e308 AND "
            "x0 = 2 ORDER BY id"),
        "1|0.0|1.0\n2|0.0|1.0")
        << kind;
    db.exec("DROP TABLE s");
  }
}

// An outline may be far from the position of its object.
TEST(OutlineQuestions, NearestAndPositionUsePositions) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE s USING moving_objects(id, x, y, shape);"
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000) INSERT INTO s SELECT i, i, 0, "
      "'POLYGON((9000 0, 9010 0, 9010 10, 9000 0))' FROM n UNION ALL SELECT 5000 + i, 5000 + i, 0, NULL FROM "
      "n;"
      "INSERT INTO s(s) VALUES('optimize')");
  for (const char* method : {"tree", "scan"})
    EXPECT_EQ(
        db.rows("SELECT id, distance FROM predictive_nearest WHERE h = 0 AND tbl = 's' AND k = 3 AND x = 0 "
                "AND y = 0 AND method = '" +
                std::string(method) + "'"),
        "1|1.0\n2|2.0\n3|3.0")
        << method;
  EXPECT_EQ(db.rows("SELECT x, y FROM predictive_position(0, 's') WHERE id = 7"), "7.0|0.0");
}

// A window and the zone of its corners give the same rows for every shape, with and without corners.
TEST(OutlineQuestions, AZoneOfFourCornersIsAWindow) {
  for (int seed = 0; seed < scenes; ++seed) {
    Scene scene(static_cast<std::uint64_t>(seed));
    scene.db.exec(
        "CREATE VIRTUAL TABLE points USING moving_objects(id, t, x, y, vx, vy);"
        "INSERT INTO points SELECT id, t, x, y, vx, vy FROM s;"
        "CREATE VIRTUAL TABLE boxes USING moving_objects(id, t, x, y, vx, vy, hx, hy);"
        "INSERT INTO boxes SELECT id, t, x, y, vx, vy, r, 1 FROM s;"
        "CREATE VIRTUAL TABLE discs USING moving_objects(id, t, x, y, vx, vy, r);"
        "INSERT INTO discs SELECT id, t, x, y, vx, vy, r FROM s");
    for (const char* table : {"points", "boxes", "discs", "s"}) {
      const std::string about =
          " WHERE h = 20 AND now = 3 AND wvy = 0.5 AND tbl = '" + std::string(table) + "'";
      const std::string window =
          scene.db.rows("SELECT * FROM predictive_window" + about +
                        " AND x0 = 10.25 AND x1 = 50 AND y0 = -4 AND y1 = 61.5 ORDER BY id");
      EXPECT_FALSE(window.empty());
      EXPECT_EQ(scene.db.rows(
                    "SELECT * FROM predictive_window" + about +
                    " AND zone = 'POLYGON((10.25 -4, 50 -4, 50 61.5, 10.25 61.5, 10.25 -4))' ORDER BY id"),
                window)
          << "seed " << seed << ' ' << table;
    }
  }
}

TEST(OutlineQuestions, BoxesAndDiscsAsOutlinesAreBoxesAndDiscs) {
  for (int seed = 0; seed < scenes; ++seed) {
    Scene scene(static_cast<std::uint64_t>(seed));
    Database& db = scene.db;
    db.exec(
        "CREATE VIRTUAL TABLE boxes USING moving_objects(id, t, x, y, vx, vy, hx, hy);"
        "INSERT INTO boxes SELECT id, t, x, y, vx, vy, 1 + id % 4, 2.5 FROM s;"
        "CREATE VIRTUAL TABLE discs USING moving_objects(id, t, x, y, vx, vy, r);"
        "INSERT INTO discs SELECT id, t, x, y, vx, vy, r FROM s;"
        "CREATE VIRTUAL TABLE outlines USING moving_objects(id, t, x, y, vx, vy, shape, r);"
        "INSERT INTO outlines SELECT id, t, x, y, vx, vy, format('POLYGON((-%d -2.5, %d -2.5, %d 2.5, -%d "
        "2.5, -%d -2.5))', hx, hx, hx, hx, hx), 0 FROM boxes;");
    const auto join = [&](const std::string& table, const std::string& more) {
      return db.rows("SELECT a, b, t, t_end FROM predictive_join WHERE h = 20 AND now = 3 AND tbl = '" +
                     table + "'" + more + " ORDER BY a, b");
    };
    EXPECT_EQ(join("outlines", ""), join("boxes", "")) << "seed " << seed;
    EXPECT_EQ(join("outlines", " AND other = 'boxes' AND a <> b"), join("boxes", " AND other = 'boxes'"));
    EXPECT_EQ(join("outlines", " AND other = 'discs' AND within = 0.5"),
              join("boxes", " AND other = 'discs' AND within = 0.5"));
    db.exec("UPDATE outlines SET shape = NULL, r = (SELECT r FROM discs WHERE discs.id = outlines.id)");
    EXPECT_EQ(join("outlines", " AND within = 0.5"), join("discs", " AND within = 0.5"));
  }
}

// An endless prism's window is that of its outline.
TEST(OutlineQuestions, PrismsOfEndlessHeightAreFlat) {
  Scene scene(4);
  Database& db = scene.db;
  db.exec(
      "CREATE VIRTUAL TABLE flat USING moving_objects(id, t, x, y, vx, vy, shape, heading, r);"
      "CREATE VIRTUAL TABLE tall USING moving_objects(id, t, x, y, z, vx, vy, vz, shape, heading, r, hz);"
      "INSERT INTO flat SELECT id, t, x, y, vx, vy, shape, heading, r FROM s;"
      "INSERT INTO tall SELECT id, t, x, y, 0, vx, vy, id % 3, shape, heading, r, 1000 FROM s");
  const char* rows = "SELECT a, b, t, t_end FROM predictive_join(20, '%s', 1, NULL, 3) ORDER BY a, b";
  const auto join = [&](const char* table) {
    std::string sql = rows;
    return db.rows(sql.replace(sql.find("%s"), 2, table));
  };
  EXPECT_EQ(join("tall"), join("flat"));
}

// A box that covers a whole outline certifies the contact without a test of the outline.
TEST(OutlineQuestions, AreCountedWhereAGiantHoldsThem) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE s USING moving_objects(id, x, y, shape);"
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 3000) INSERT INTO s SELECT i, i % 60 * "
      "3, "
      "i / 60 * 3, 'POLYGON((0 0, 1 0, 0 1, 0 0))' FROM n;"
      "CREATE VIRTUAL TABLE boxes USING moving_objects(id, x, y, hx, hy);"
      "INSERT INTO boxes VALUES (1, 90, 90, 1000, 1000), (2, 0, 0, 1, 1), (3, 50, 50, 2, 2)");
  const std::string joined = db.rows("SELECT count(*) FROM predictive_join(5, 's', 0, 'boxes', 0, 'scan')");
  for (const char* method : {"auto", "grid", "gpcd"})
    EXPECT_EQ(db.rows("SELECT n_after FROM predictive_explain(5, 's', 0, 'boxes', 0, '" +
                      std::string(method) + "') WHERE stage = 'refinement'"),
              joined)
        << method;
}

TEST(OutlineQuestions, HaveNoDistanceToBallsOnThreeAxes) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE prisms USING moving_objects(id, x, y, z, shape, hz);"
      "CREATE VIRTUAL TABLE balls USING moving_objects(id, x, y, z, r);"
      "CREATE VIRTUAL TABLE poles USING moving_objects(id, x, y, z, r, hz)");
  EXPECT_EQ(
      db.error_of("SELECT * FROM predictive_join(1, 'prisms', 0, 'balls')"),
      "predictive_join: no distance is defined between prisms (prisms) and balls (balls): declare hz in "
      "balls to make them cylinders");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_join(1, 'prisms', 0, 'poles')"), "");
  const std::string zone = " AND zone = 'POLYGON((0 0, 4 0, 0 3, 0 0))'";
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_window WHERE h = 1 AND tbl = 'balls' AND z0 = 1" + zone),
            "predictive_window: no distance is defined between balls and a zone with z0 or z1: leave z0 and "
            "z1 out, "
            "or declare hz in the table to make its balls cylinders");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_window WHERE h = 1 AND tbl = 'balls'" + zone), "");
}

TEST(OutlineQuestions, ZonesAreReadStrictly) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE s USING moving_objects(id, x, y);"
      "CREATE VIRTUAL TABLE line USING moving_objects(id, x)");
  const auto error = [&](const std::string& zone, const std::string& more = "", const char* table = "s") {
    return db.error_of("SELECT * FROM predictive_window WHERE h = 1 AND tbl = '" + std::string(table) +
                       "' AND zone = " + zone + more);
  };
  const std::string triangle = "'POLYGON((0 0, 4 0, 0 3, 0 0))'";
  EXPECT_EQ(error(triangle), "");
  EXPECT_EQ(error("'POLYGON((0 0, 4 0, 0 3))'"),
            "predictive_window: zone: ring 1 is not closed: write the first corner (0 0) again at its end");
  EXPECT_EQ(error("''"),
            "predictive_window: zone: at character 1: expected POLYGON or MULTIPOLYGON, found the end");
  EXPECT_EQ(error("7"),
            "predictive_window: zone must be well-known text as in 'POLYGON((0 0, 4 0, 0 3, 0 0))', or left "
            "out, not 7");
  EXPECT_EQ(error(triangle, " AND x1 = 3"),
            "predictive_window: zone says where the window is in x and y: leave out x1, or zone");
  EXPECT_EQ(error(triangle, "", "line"),
            "predictive_window: zone: line has one axis: write x0 and x1 in place of zone");
}

}  // namespace
}  // namespace foresee::testing
