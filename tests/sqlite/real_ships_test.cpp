// 1,135 real ships of the Lower Mississippi: rows of joins against pairs and times of an exhaustive search.
// The files are not in the repository: the test reads ../shared/data, or the folder in FORESEE_SHARED_DATA.
// Without them it is skipped.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

using Row = std::vector<std::string>;

std::vector<Row> read_csv(const std::string& path) {
  std::vector<Row> rows;
  std::ifstream file(path);
  std::string line, cell;
  std::getline(file, line);  // the header
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(cell);
  }
  return rows;
}

struct RealShips : ::testing::Test {
  void SetUp() override {
    const char* named = std::getenv("FORESEE_SHARED_DATA");
    folder = named ? named : FORESEE_SOURCE_DIR "/../shared/data";
    ships = read_csv(folder + "/ships_mississippi.csv");
    if (ships.empty()) GTEST_SKIP() << "no ships_mississippi.csv in " << folder;
    ASSERT_EQ(ships.size(), 1135u);
  }

  /// Creates the table of ships, with the columns and values that `extents` adds to each row.
  void build(const std::string& columns, const std::string& extents) {
    std::string sql =
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy" + columns + "); BEGIN;";
    for (const Row& ship : ships) {
      sql += "INSERT INTO ships VALUES (" + ship[0];
      for (int i = 1; i <= 5; ++i) sql += "," + ship[static_cast<std::size_t>(i)];
      sql += extents + ");";
    }
    db.exec(sql + "COMMIT");
  }

  /// The rows of `call` must be those of the file: i, j, start and end after 600, and d_cpa if the file has
  /// it.
  void expect_rows(const std::string& call, const std::vector<Row>& expected) {
    db.exec("CREATE TEMP TABLE found AS SELECT a, b, dt, dt_end, dt_cpa, d_cpa FROM " + call);
    EXPECT_EQ(db.rows("SELECT count(*) FROM found"), std::to_string(expected.size()));
    sqlite3_stmt* find = nullptr;
    db.exec("CREATE INDEX temp.by_pair ON found(a, b)");
    ASSERT_EQ(sqlite3_prepare_v2(db.handle(), "SELECT * FROM found WHERE a = min(?1, ?2) AND b = max(?1, ?2)",
                                 -1, &find, nullptr),
              SQLITE_OK);
    for (const Row& row : expected) {
      sqlite3_bind_int64(find, 1, std::stoll(row[0]));
      sqlite3_bind_int64(find, 2, std::stoll(row[1]));
      ASSERT_EQ(sqlite3_step(find), SQLITE_ROW) << row[0] << ", " << row[1];
      EXPECT_NEAR(sqlite3_column_double(find, 2), std::stod(row[2]), 1e-6) << row[0] << ", " << row[1];
      EXPECT_NEAR(sqlite3_column_double(find, 3), std::stod(row[3]), 1e-6) << row[0] << ", " << row[1];
      if (row.size() > 5 && !row[5].empty()) {
        EXPECT_NEAR(sqlite3_column_double(find, 5), std::stod(row[5]), 1e-6) << row[0] << ", " << row[1];
      }
      sqlite3_reset(find);
    }
    sqlite3_finalize(find);
    db.exec("DROP TABLE temp.found");
  }

  std::string folder;
  std::vector<Row> ships;
  Database db;
};

TEST_F(RealShips, ComeWithin926MetresAsExhaustiveSearchFound) {
  build("", "");
  const auto expected = read_csv(folder + "/ships_mississippi_within926_h600.csv");
  ASSERT_EQ(expected.size(), 3993u);
  for (const std::string method : {"auto", "grid", "scan"})
    expect_rows("predictive_join(600, 'ships', 926, NULL, 600, '" + method + "')", expected);
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(600, 'ships', 926, NULL, 600) WHERE dt > 0"),
            "337");
}

TEST_F(RealShips, MeetAsBoxesAsExhaustiveSearchFound) {
  build(", hx, hy", ", 463, 463");
  const auto expected = read_csv(folder + "/ships_mississippi_box463_h600.csv");
  ASSERT_EQ(expected.size(), 4488u);
  for (const std::string method : {"auto", "grid", "scan"})
    expect_rows("predictive_join(600, 'ships', 0, NULL, 600, '" + method + "')", expected);
}

/// predictive_avoid for every ship that would come within 200 m of another: each manoeuvre keeps the ship
/// clear of all others except those that are near at the start.
TEST_F(RealShips, KeepClearAfterAManoeuvre) {
  build("", "");
  db.exec(
      "CREATE TEMP TABLE meets AS SELECT a AS id FROM predictive_join(600, 'ships', 200) WHERE dt > 0 "
      "UNION SELECT b FROM predictive_join(600, 'ships', 200) WHERE dt > 0;"
      "CREATE TEMP TABLE near AS SELECT a, b FROM predictive_join(0, 'ships', 200);"
      "CREATE TEMP TABLE advice AS SELECT m.id, v.manoeuvre, v.clear, v.t, v.x, v.y, v.vx, v.vy "
      "FROM meets m, predictive_avoid(600, 'ships', m.id, 200) v WHERE v.clear");
  EXPECT_EQ(db.rows("SELECT count(*) FROM meets"), "183");
  EXPECT_EQ(db.rows("SELECT count(DISTINCT id) FROM advice"), "70");
  sqlite3_stmt* all = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(db.handle(), "SELECT rowid, id FROM advice", -1, &all, nullptr), SQLITE_OK);
  while (sqlite3_step(all) == SQLITE_ROW) {
    const std::string row = std::to_string(sqlite3_column_int64(all, 0)),
                      id = std::to_string(sqlite3_column_int64(all, 1));
    db.exec(
        "SAVEPOINT advised; UPDATE ships SET (t, x, y, vx, vy) = (SELECT t, x, y, vx, vy FROM advice WHERE "
        "rowid = " +
        row + ") WHERE id = " + id);
    EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(600, 'ships', 200) WHERE a = " + id +
                      " OR b = " + id + " EXCEPT SELECT a, b FROM near"),
              "")
        << "manoeuvre " << row;
    db.exec("ROLLBACK TO advised; RELEASE advised");
  }
  sqlite3_finalize(all);
}

}  // namespace
}  // namespace foresee::testing
