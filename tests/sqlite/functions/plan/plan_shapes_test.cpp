// Plans of boxes, outlines, prisms and meshes: each function gives the rows of the legs as plain rows, merged.
#include <array>

#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct ShapeColumns {
  const char* name;
  bool in_space;
  const char* columns;
  /// The values of the columns, as SQL.
  std::array<const char*, 3> values;
};

const ShapeColumns shape_columns[] = {
    {"boxes", false, "hx, hy", {"0.8, 0.2", "0.3, 0.3", "0.1, 1.5"}},
    {"outlines",
     false,
     "shape, heading, r",
     {"'POLYGON((-1 -0.5, 1 -0.5, 1 0.5, 0 0.1, -1 0.5, -1 -0.5))', 30, 0", "NULL, 0, 0.4",
      "'MULTIPOLYGON(((-1 0, 0 0, 0 0.5, -1 0)), ((1 0, 2 0, 2 0.3, 1 0)))', 245, 0.1"}},
    {"balls in space", true, "r", {"0.75", "0", "1.5"}},
    {"boxes in space", true, "hx, hy, hz", {"0.8, 0.2, 2", "0.3, 0.3, 0.3", "2, 0.5, 1"}},
    {"prisms",
     true,
     "shape, heading, hz",
     {"'POLYGON((-1 -1, 1 -1, 1 1, 0 0, -1 1, -1 -1))', 10, 2", "'POLYGON((0 -2, 1 2, -1 2, 0 -2))', 200, 1",
      "NULL, 0, 3"}},
    {"meshes",
     true,
     "shape, r",
     {"'TIN Z(((0 0 0, 2 0 0, 0 2 0, 0 0 0)), ((0 0 0, 0 2 0, 0 0 2, 0 0 0)))', 0.1", "NULL, 0.5",
      "'POLYHEDRALSURFACE Z(((0 0 0, 0 1 0, 1 0 0, 0 0 0)), ((0 0 0, 1 0 0, 0 0 1, 0 0 0)), "
      "((0 0 0, 0 0 1, 0 1 0, 0 0 0)), ((1 0 0, 0 1 0, 0 0 1, 1 0 0)))', 0"}},
};

/// Random plans in `robots` with these columns, and their legs as rows of `legs`.
class PlanShapes : public ::testing::TestWithParam<ShapeColumns> {
 protected:
  void make_plans(int movers, int legs, std::uint64_t seed, double side) {
    const ShapeColumns& shapes = GetParam();
    const std::string z = shapes.in_space ? ", z" : "", vz = shapes.in_space ? ", vz" : "",
                      columns = shapes.columns;
    db.exec("CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y" + z + ", plan, " + columns +
            ");CREATE VIRTUAL TABLE legs USING moving_objects(id, t, x, y" + z + ", vx, vy" + vz + ", " +
            columns + ", until, +robot);CREATE TABLE knots(robot, t, x, y, z)");
    Random random(seed);
    for (int robot = 1; robot <= movers; ++robot) {
      double t = random.in(0, 5);
      for (int i = 0; i <= legs; ++i, t += random.in(0.5, 4)) {
        std::string place;
        for (int axis = 0; axis < 3; ++axis)
          place += ", " + (i % 4 == 3 ? "NULL" : std::to_string(random.in(0, axis == 2 ? side / 4 : side)));
        db.exec("INSERT INTO knots VALUES (" + std::to_string(robot) + ", " + std::to_string(t) + place +
                ")");
      }
      const std::string id = std::to_string(robot),
                        values = shapes.values[static_cast<std::size_t>(robot) % shapes.values.size()];
      db.exec("INSERT INTO robots(id, plan, " + columns + ") SELECT " + id + ", plan_points(t, x, y" + z +
              "), " + values + " FROM knots WHERE robot = " + id);
      db.exec("INSERT INTO legs(t, x, y" + z + ", vx, vy" + vz + ", until, robot, " + columns +
              ") SELECT p.t, p.x, p.y" + z_of("p.z") + ", p.vx, p.vy" + z_of("p.vz") + ", p.until, " + id +
              ", " + values + " FROM robots, plan_rows(plan) AS p WHERE robots.id = " + id);
    }
  }
  std::string z_of(const std::string& column) const { return GetParam().in_space ? ", " + column : ""; }
  /// Inputs of a box in space, or of a rectangle.
  std::string within(const char* lower, const char* upper) const {
    std::string inputs;
    for (const char* axis : {"x", "y", "z"})
      if (*axis != 'z' || GetParam().in_space)
        inputs += std::string(" AND ") + axis + "0 = " + lower + " AND " + axis + "1 = " + upper;
    return inputs;
  }

  Database db;
};

INSTANTIATE_TEST_SUITE_P(All, PlanShapes, ::testing::ValuesIn(shape_columns), [](const auto& given) {
  std::string name = given.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

/// The first contact of each pair of robots: that of their legs, and those that follow it without a gap.
constexpr const char* first_contacts =
    "WITH c AS (SELECT min(l.robot, m.robot) AS a, max(l.robot, m.robot) AS b, j.t, j.t_end FROM "
    "predictive_join(40, 'legs', 0.25) AS j, legs AS l, legs AS m WHERE j.now = 1 AND l.id = j.a AND "
    "m.id = j.b AND l.robot <> m.robot), s AS (SELECT *, t > coalesce(max(t_end) OVER (PARTITION BY a, b "
    "ORDER BY t, t_end ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING), -1) AS starts FROM c), n AS "
    "(SELECT *, sum(starts) OVER (PARTITION BY a, b ORDER BY t, t_end) AS number FROM s) SELECT a, b, min(t) "
    "AS t, max(t_end) AS t_end FROM n WHERE number = 1 GROUP BY a, b";

TEST_P(PlanShapes, JoinAsTheirLegsDo) {
  make_plans(40, 14, 31, 40);
  const std::string expected = db.rows(std::string(first_contacts) + " ORDER BY a, b");
  EXPECT_GT(std::count(expected.begin(), expected.end(), '\n'), 40);
  for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"})
    EXPECT_EQ(
        db.rows(std::string("SELECT a, b, t, t_end FROM predictive_join(40, 'robots', 0.25) WHERE now = "
                            "1 AND method = '") +
                method + "' ORDER BY a, b"),
        expected)
        << method;
  std::string of_each;
  for (int id = 1; id <= 40; ++id) {
    const std::string rows = db.rows(
        "SELECT a, b, t, t_end FROM predictive_join(40, 'robots', 0.25) WHERE now = "
        "1 AND a = " +
        std::to_string(id) + " ORDER BY b");
    of_each += (of_each.empty() || rows.empty() ? "" : "\n") + rows;
  }
  EXPECT_EQ(of_each, expected);
  EXPECT_EQ(
      db.rows(
          "SELECT n_after FROM predictive_explain(40, 'robots', 0.25) WHERE now = 1 AND stage = 'movers'"),
      std::to_string(std::count(expected.begin(), expected.end(), '\n') + 1));
}

TEST_P(PlanShapes, SearchesFindTheirLegs) {
  make_plans(40, 14, 33, 40);
  const std::string times = " WHERE h = 12 AND now = 6";
  const auto expect_equal = [&](const std::string& robots, const std::string& legs) {
    const std::string rows = db.rows(robots);
    EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 3) << robots;
    EXPECT_EQ(rows, db.rows(legs)) << robots;
  };
  const std::string window = times + within("2", "15");
  expect_equal("SELECT id, t FROM predictive_window" + window + " AND tbl = 'robots' ORDER BY id",
               "SELECT robot, min(w.t) FROM predictive_window AS w JOIN legs USING(id)" + window +
                   " AND tbl = 'legs' GROUP BY robot ORDER BY robot");
  const std::string in_window = " FROM predictive_window AS w" + window + " AND tbl = 'robots'";
  EXPECT_EQ(db.rows("SELECT (SELECT t_end" + in_window +
                    " AND w.id = robots.id) AS t FROM robots WHERE t > 0 ORDER BY id"),
            db.rows("SELECT t_end" + in_window + " ORDER BY id"))
      << "one object after another";
  const std::string place =
      times + " AND n.x = 20 AND n.y = 21" + (GetParam().in_space ? " AND n.z = 4" : "");
  expect_equal("SELECT id, distance FROM predictive_nearest AS n" + place +
                   " AND tbl = 'robots' AND k = 9 ORDER BY rank",
               "SELECT robot, min(distance) FROM predictive_nearest AS n JOIN legs USING(id)" + place +
                   " AND tbl = 'legs' AND k = 500 GROUP BY robot ORDER BY 2 LIMIT 9");
  expect_equal("SELECT id, x, vy FROM predictive_position(17.25, 'robots') ORDER BY id",
               "SELECT robot, p.x, p.vy FROM predictive_position(17.25, 'legs') AS p JOIN legs USING(id) "
               "ORDER BY robot");
  expect_equal(
      "SELECT id, x0, x1, y0, y1 FROM predictive_sweep" + times + " AND tbl = 'robots' ORDER BY id",
      "SELECT robot, min(s.x0), max(s.x1), min(s.y0), max(s.y1) FROM predictive_sweep AS s JOIN legs "
      "USING(id)" +
          times + " AND tbl = 'legs' GROUP BY robot ORDER BY robot");
}

TEST_P(PlanShapes, AWatchIsTheJoin) {
  make_plans(40, 14, 35, 40);
  db.exec("CREATE VIRTUAL TABLE w USING predictive_watch(robots, horizon = 15, within = 0.25)");
  const auto expect_current = [&] {
    const std::string pairs = db.rows("SELECT a, b, t FROM w ORDER BY a, b");
    EXPECT_NE(pairs, "");
    EXPECT_EQ(pairs,
              db.rows("SELECT a, b, t FROM predictive_join(15, 'robots', 0.25) WHERE now = (SELECT now "
                      "FROM predictive_watches) ORDER BY a, b"));
    EXPECT_EQ(db.error_of("INSERT INTO w(w) VALUES ('integrity-check')"), "");
    EXPECT_EQ(db.error_of("INSERT INTO robots(robots) VALUES ('integrity-check')"), "");
  };
  expect_current();
  db.exec("UPDATE robots SET plan = plan_shift(plan, 0.5) WHERE id % 3 = 0");
  expect_current();
  db.exec(std::string("BEGIN; UPDATE robots SET (") + GetParam().columns + ") = (" + GetParam().values[1] +
          ") WHERE id % 4 = 0; SAVEPOINT s; DELETE FROM robots WHERE id < 9; ROLLBACK TO s; COMMIT");
  expect_current();
  db.exec("INSERT INTO w(w, now) VALUES ('advance', 11)");
  expect_current();
}

TEST_P(PlanShapes, AWaitThatIsClearMeetsNoOther) {
  make_plans(16, 3, 37, 40);
  if (std::string(GetParam().name) == "meshes") {
    EXPECT_TRUE(
        db.error_of("SELECT * FROM predictive_avoid WHERE h = 60 AND tbl = 'robots' AND id = 1 AND how "
                    "= 'wait' AND lo = 0 AND hi = 90 AND now = 0")
            .starts_with("predictive_avoid: meshes of robots are not examined"));
    return;
  }
  int clear = 0;
  for (int id = 1; id <= 16; ++id) {
    const std::string
        row = std::to_string(id),
        waits = " FROM predictive_avoid WHERE h = 60 AND tbl = 'robots' AND id = " + row +
                " AND within = 0.25 AND how = 'wait' AND lo = 0 AND hi = 90 AND now = 0 AND clear LIMIT 1";
    if (db.rows("SELECT 1" + waits).empty()) continue;
    ++clear;
    db.exec("SAVEPOINT s; UPDATE robots SET plan = (SELECT plan" + waits + ") WHERE id = " + row);
    EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(60, 'robots', 0.25) WHERE now = 0 AND (a = " + row +
                      " OR b = " + row + ")"),
              "");
    db.exec("ROLLBACK TO s; RELEASE s");
  }
  EXPECT_GT(clear, 2);
}

}  // namespace
}  // namespace foresee::testing
