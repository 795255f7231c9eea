// predictive_avoid for outlines and prisms: against exact contact of single changes, against equal shapes of
// other kinds, and written back. FORESEE_LONG=1: a hundred times as many scenes.
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "sanitized.h"
#include "sqlite/database.h"
#include "sqlite/random_numbers.h"

namespace foresee::testing {
namespace {

constexpr const char* shapes[] = {
    "'POLYGON((-2 -6, 2 -6, 2 4, 0 6, -2 4, -2 -6))'",                              // a hull
    "'POLYGON((-1 -1, 1 -1, 1 1, -1 1, -1 -1))'",                                   // a box
    "'POLYGON((-5 -5, 5 -5, 5 5, 3 5, 3 -3, -3 -3, -3 5, -5 5, -5 -5))'",           // a dock
    "'POLYGON((-6 -6, 6 -6, 6 6, -6 6, -6 -6), (-4 -4, 4 -4, 4 4, -4 4, -4 -4))'",  // a ring
    "'MULTIPOLYGON(((2 2, 4 2, 3 5, 2 2)), ((-4 -4, -2 -4, -3 -1, -4 -4)))'",       // two parts
    "'POLYGON((10 0, 12 0, 11 3, 10 0))'",                                          // beside its position
    "'POLYGON((0 0, 1 4, 5 5, 1 6, 0 10, -1 6, -5 5, -1 4, 0 0))'",                 // a star
    "NULL"};

struct Scene {
  explicit Scene(std::uint64_t seed) : random(seed) {
    axes = drawn(random, 2, 3);
    const bool has_r = drawn(random, 0, 2) == 0, has_heading = drawn(random, 0, 3) > 0;
    const std::string places = "t, x, y" + z(", z") + ", vx, vy" + z(", vz");
    db.exec("CREATE VIRTUAL TABLE own USING moving_objects(id, " + places + ", shape" +
            (has_heading ? ", heading" : "") + (has_r ? ", r" : "") + z(", hz") + ")");
    also = drawn(random, 0, 1) == 0 ? "NULL" : "'boxes'";
    db.exec("CREATE VIRTUAL TABLE boxes USING moving_objects(id, " + places + ", hx, hy" + z(", hz") + ")");
    const int count = drawn(random, 3, 10);
    for (int id = 1; id <= count; ++id)
      for (const bool box : {false, true}) {
        std::ostringstream row;
        row.precision(17);
        row << "INSERT INTO " << (box ? "boxes" : "own") << " VALUES(" << id << ", " << drawn(random, -2, 1);
        for (int axis = 0; axis < axes; ++axis) row << ", " << number(axis < 2 ? 20 : 6);
        for (int axis = 0; axis < axes; ++axis) row << ", " << number(3);
        if (box)
          row << ", " << drawn(random, 0, 3) << ", " << std::abs(number(3));
        else
          row << ", " << shapes[drawn(random, 0, 7)];
        if (!box && has_heading)
          row << ", " << (drawn(random, 0, 1) ? 45 * drawn(random, -8, 8) : number(360));
        if (!box && has_r) row << ", " << drawn(random, 0, 2);
        db.exec(row.str() + z(", 1") + ")");
      }
    within = drawn(random, 0, 1) == 0 ? "0" : "2.5";
    moved = places + (has_heading ? ", heading" : "");
    id = std::to_string(drawn(random, 1, count));
  }

  std::string z(const std::string& text) const { return axes == 3 ? text : ""; }
  double number(double limit) {
    const double drawn_number = drawn(random, -limit, limit);
    return drawn(random, 0, 2) == 0 ? std::round(drawn_number) : drawn_number;
  }
  /// As in FROM. `range`: how, lo, hi.
  std::string avoid(const std::string& range) const {
    return "predictive_avoid(12, 'own', " + id + ", " + within + ", " + range + ", 1, " + also + ", NULL, '" +
           touching + "')";
  }
  bool is_clear(const std::string& how, double k) {
    const std::string at = shown_exactly(k);
    return db.rows("SELECT clear FROM " + avoid("'" + how + "', " + at + ", " + at)) == "1";
  }
  /// The objects that the object touches within h from the change on.
  std::string touching_objects(const std::string& h) {
    const std::string self = "(SELECT max(1, t) FROM own WHERE id = " + id + ")";
    std::string sql = "SELECT 'own', a + b - " + id + " AS other FROM predictive_join(" + h + ", 'own', " +
                      within + ") WHERE now = " + self + " AND (a = " + id + " OR b = " + id + ")";
    if (also != "NULL")
      sql += " UNION ALL SELECT 'boxes', b FROM predictive_join(" + h + ", 'own', " + within +
             ") WHERE other = 'boxes' AND now = " + self + " AND a = " + id;
    return db.rows(sql + " ORDER BY 1, 2");
  }

  Engine random;
  int axes;
  std::string also, within, moved, id, touching = "part";
  Database db;
};

struct Row {
  bool clear;
  double from, to, k;
};

std::vector<Row> rows_of(Database& db, const std::string& from) {
  std::vector<Row> rows;
  sqlite3_stmt* statement = nullptr;
  const std::string sql = "SELECT clear, k_from, k_to, k FROM " + from;
  EXPECT_EQ(sqlite3_prepare_v2(db.handle(), sql.c_str(), -1, &statement, nullptr), SQLITE_OK) << sql;
  while (sqlite3_step(statement) == SQLITE_ROW)
    rows.push_back({sqlite3_column_int(statement, 0) != 0, sqlite3_column_double(statement, 1),
                    sqlite3_column_double(statement, 2), sqlite3_column_double(statement, 3)});
  EXPECT_EQ(sqlite3_finalize(statement), SQLITE_OK) << sqlite3_errmsg(db.handle());
  return rows;
}

struct Range {
  const char* how;
  double lo, hi;

  std::string text() const {
    return "'" + std::string(how) + "', " + shown_exactly(lo) + ", " + shown_exactly(hi);
  }
};

constexpr Range ranges[] = {{"turn", -180, 180}, {"turn", -360, 30}, {"speed", -3, 3}, {"delay", 0, 8}};
const int scenes = (std::getenv("FORESEE_LONG") ? 100 : 1) * (sanitized ? 20 : 40);

/// Changes of a row: its ends, near them and between them.
std::vector<double> queried_of(Engine& random, const Row& row) {
  std::vector<double> queried{row.from, row.to, row.k};
  const double width = row.to - row.from;
  for (int i = 0; i < 3; ++i) {
    queried.push_back(row.from + width * drawn(random, 0.0, 1.0));
    const double near = width * std::exp2(-drawn(random, 1.0, 45.0));
    queried.push_back(row.from + near), queried.push_back(row.to - near);
  }
  std::erase_if(queried, [&](double k) { return k < row.from || k > row.to; });
  return queried;
}

/// A blocked row ends next to changes that touch, and contains no clear range wider than 10^-6.
void expect_tight(Scene& scene, const Range& range, const Row& row) {
  const double width = 1e-6 * (range.hi - range.lo);
  if (row.to - row.from <= width) return;
  for (const bool upward : {true, false}) {
    bool touches = false;
    for (const double share : {0.0, 1e-5, 1e-3, 1e-2, 0.1, 1.0})
      touches =
          touches || !scene.is_clear(range.how, upward ? row.from + share * width : row.to - share * width);
    EXPECT_TRUE(touches) << range.text() << ": an end of " << row.from << " to " << row.to;
  }
  const double k = drawn(scene.random, row.from + width, row.to - width);
  bool clear = true;
  for (int step = -4; step <= 4 && clear; ++step) clear = scene.is_clear(range.how, k + 0.25 * step * width);
  EXPECT_FALSE(clear) << range.text() << ": " << k << " in " << row.from << " to " << row.to;
}

/// Objects that it touches once a change is stored touched before.
void expect_clear_once_stored(Scene& scene, const Range& range, double k) {
  const std::string before = '\n' + scene.touching_objects("0") + '\n', at = shown_exactly(k);
  scene.db.exec("SAVEPOINT before");
  scene.db.exec("UPDATE own SET (" + scene.moved + ") = (SELECT " + scene.moved + " FROM " +
                scene.avoid(Range{range.how, k, k}.text()) + " WHERE clear) WHERE id = " + scene.id);
  std::istringstream after(
      scene.touching_objects("12 - max(0, (SELECT t FROM own WHERE id = " + scene.id + ") - 1)"));
  for (std::string line; std::getline(after, line);)
    EXPECT_NE(before.find('\n' + line + '\n'), std::string::npos)
        << range.text() << " at " << at << ": " << line;
  scene.db.exec("ROLLBACK TO before; RELEASE before");
}

TEST(AvoidOutlines, IsSoundAndTightAgainstSingleChanges) {
  int clear = 0, blocked = 0;
  for (int seed = 0; seed < scenes; ++seed) {
    Scene scene(static_cast<std::uint64_t>(seed));
    scene.touching = seed % 2 == 0 ? "part" : "ignore";
    const Range& range = ranges[seed / 2 % std::size(ranges)];
    SCOPED_TRACE("scene " + std::to_string(seed));
    if (std::string(range.how) == "delay") scene.db.exec("UPDATE own SET t = 1.5 WHERE id = " + scene.id);
    const std::vector<Row> rows = rows_of(scene.db, scene.avoid(range.text()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i].from, i == 0 ? range.lo : rows[i - 1].to);
      if (!rows[i].clear && scene.touching == "ignore") ++blocked, expect_tight(scene, range, rows[i]);
      if (!rows[i].clear) continue;
      for (const double k : queried_of(scene.random, rows[i])) {
        ++clear;
        EXPECT_TRUE(scene.is_clear(range.how, k)) << range.text() << ": " << shown_exactly(k);
      }
      if (scene.touching == "part" && std::string(range.how) != "delay")
        expect_clear_once_stored(scene, range, rows[i].k);
    }
    EXPECT_TRUE(rows.empty() || rows.back().to == range.hi);
  }
  EXPECT_GT(clear, 4 * scenes);
  EXPECT_GT(blocked, scenes / 8);
}

/// The rows of two tables with the same motions: ends as near as both are tight.
void expect_same_rows(Database& db, const std::string& one, const std::string& other, const Range& range) {
  for (int id = 1; id <= 30; ++id) {
    const auto queried = [&](const std::string& table) {
      return rows_of(
          db, "predictive_avoid(20, '" + table + "', " + std::to_string(id) + ", 1.5, " + range.text() + ")");
    };
    const std::vector<Row> rows = queried(one), others = queried(other);
    ASSERT_EQ(rows.size(), others.size()) << one << ' ' << other << ' ' << range.text() << ' ' << id;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i].clear, others[i].clear);
      EXPECT_NEAR(rows[i].from, others[i].from, 1e-9 * (range.hi - range.lo));
    }
  }
}

struct AvoidOutlinesAlike : ::testing::Test {
  AvoidOutlinesAlike() {
    db.exec(
        "CREATE TABLE motions AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM n WHERE id < "
        "30)"
        "  SELECT id, id * 7919 % 101 - 50.5 AS x, id * 104729 % 103 - 50.25 AS y, id % 7 - 3.125 AS vx,"
        "    id * 13 % 9 - 4.0625 AS vy, id % 4 * 0.5 AS size FROM n");
  }
  void make(const std::string& table, const std::string& columns, const std::string& values) {
    db.exec("CREATE VIRTUAL TABLE " + table + " USING moving_objects(id, x, y, vx, vy, " + columns +
            "); INSERT INTO " + table + " SELECT id, x, y, vx, vy, " + values + " FROM motions");
  }

  Database db;
};

TEST_F(AvoidOutlinesAlike, WithoutAnOutlineIsADisc) {
  make("discs", "r", "size");
  make("shapeless", "shape, heading, r", "NULL, id, size");
  for (const Range& range : {ranges[0], ranges[2]}) expect_same_rows(db, "discs", "shapeless", range);
}

TEST_F(AvoidOutlinesAlike, OfPiecesIsTheirUnion) {
  make("whole", "shape, heading", "'POLYGON((-2 -1, 2 -1, 2 1, -2 1, -2 -1))', 12 * id");
  make("more", "shape, heading", "'POLYGON((-2 -1, 0 -1, 2 -1, 2 0, 2 1, -2 1, -2 0.5, -2 -1))', 12 * id");
  for (const Range& range : {ranges[0], ranges[2]}) expect_same_rows(db, "whole", "more", range);
  db.exec(
      "CREATE VIRTUAL TABLE docks USING moving_objects(id, x, y, shape);"
      "CREATE VIRTUAL TABLE walls USING moving_objects(id, x, y, shape);"
      "INSERT INTO docks VALUES (1, 70, 70, 'POLYGON((-5 -5, 5 -5, 5 5, 3 5, 3 -3, -3 -3, -3 5, -5 5, -5 "
      "-5))');"
      "INSERT INTO walls VALUES (1, 70, 70, 'POLYGON((-5 -5, 5 -5, 5 -3, -5 -3, -5 -5))'),"
      "  (2, 70, 70, 'POLYGON((3 -3, 5 -3, 5 5, 3 5, 3 -3))'), (3, 70, 70, 'POLYGON((-5 -3, -3 -3, -3 5, -5 "
      "5, -5 -3))');"
      "UPDATE whole SET x = 90, y = 72, vx = -1, vy = 0 WHERE id = 1");
  for (const char* how : {"'turn', -180, 180", "'speed', -1, 4"}) {
    const auto against = [&](const std::string& table) {
      return db.rows(
          "SELECT clear, round(k_from, 7), round(k_to, 7) FROM predictive_avoid(20, 'whole', 1, 0, " +
          std::string(how) + ", 0, '" + table + "')");
    };
    EXPECT_EQ(against("docks"), against("walls"));
    EXPECT_NE(against("docks").find("\n0|"), std::string::npos);
  }
}

TEST_F(AvoidOutlinesAlike, ThatIsTurnedByRightAnglesAndItsSceneToo) {
  make("north", "shape, heading", "'POLYGON((-1 -3, 1 -3, 1 2, 0 3, -1 2, -1 -3))', 5 * id");
  db.exec(
      "CREATE VIRTUAL TABLE east USING moving_objects(id, x, y, vx, vy, shape, heading);"
      "INSERT INTO east SELECT id, y, -x, vy, -vx, shape, heading + 90 FROM north");
  for (const Range& range : {ranges[0], ranges[2]}) expect_same_rows(db, "north", "east", range);
}

}  // namespace
}  // namespace foresee::testing
