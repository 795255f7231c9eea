// Random lives of watches: after every commit the rows are those of predictive_join, bit for bit in all nine
// columns, and folding the changes gives the rows.
#include <map>
#include <random>
#include <sstream>

#include "sqlite/database.h"

namespace foresee::sqlite {
namespace {

using testing::Database;
using testing::TemporaryFile;

struct Life {
  const char* name;
  const char* columns;  ///< of a table, behind the id
  const char* values;   ///< of an object: N is a whole number of the scene, V a speed, S a size, T the moment
  const char* options;
  const char* join;  ///< the same question, behind now
  bool with_other = false;
  double tolerance = 0;
};

constexpr Life lives[] = {
    {"Discs", "t, x, y, vx, vy, r, +name", "T, N, N, V, V, S, 'n'", "horizon = 10, within = 2",
     "h = 10 AND within = 2"},
    {"InContact", "t, x, y, vx, vy, r", "T, N, N, V, V, S", "horizon = 0, within = 5",
     "h = 0 AND within = 5"},
    {"Tolerance", "t, x, y, vx, vy, r", "T, N, N, V, V, S", "horizon = 20, tolerance = 2.5", "h = 20", false,
     2.5},
    {"Manual", "t, x, y, vx, vy, r", "T, N, N, V, V, S", "horizon = 12, clock = manual", "h = 12"},
    {"TwoTables", "t, x, y, vx, vy, r", "T, N, N, V, V, S", "horizon = 12, other = ferries",
     "h = 12 AND other = 'ferries'", true},
    {"WithItself", "t, x, y, vx, vy, r", "T, N, N, V, V, S", "horizon = 12, other = ships",
     "h = 12 AND other = 'ships'"},
    {"Ahead", "t, x, y, vx, vy, r", "T, N, N, V, V, S", "horizon = 15, ahead = 3", "h = 15"},
    {"AcceleratedBoxes", "t, x, y, z, vx, vy, vz, ax, ay, az, hx, hy, hz, until",
     "T, N, N, N, V, V, V, V * 0.25, V * 0.25, 0, S, S, S, T + 20", "horizon = 6, within = 1",
     "h = 6 AND within = 1"},
    {"WithoutT", "x, y, hx, hy", "N, N, S, S", "horizon = 6, within = 1", "h = 6 AND within = 1"},
    {"Cylinders", "t, x, y, z, vx, vy, vz, r, hz", "T, N, N, N, V, V, V, S, S",
     "horizon = 9, within = 1, within_z = 2", "h = 9 AND within = 1 AND within_z = 2"},
    {"Outlines", "t, x, y, vx, vy, shape, heading",
     "T, N, N, V, V, 'POLYGON((-2 -9, 2 -9, 2 6, 0 9, -2 6, -2 -9))', 45 * V", "horizon = 9", "h = 9"},
};

class WatchLife : public ::testing::TestWithParam<Life> {
 protected:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  /// A row of values, drawn.
  std::string values() {
    std::string text;
    for (const char* c = GetParam().values; *c; ++c) {
      const bool is_letter =
          (c[1] == ',' || c[1] == ' ' || c[1] == 0) && (c == GetParam().values || c[-1] == ' ');
      if (is_letter && *c == 'N')
        text += std::to_string(below(81) - 40);
      else if (is_letter && *c == 'V')
        text += "(" + std::to_string(below(9) - 4) + ")";
      else if (is_letter && *c == 'S')
        text += std::to_string(below(3));
      else if (is_letter && *c == 'T')
        text += std::to_string(moment_ - (below(4) == 0 ? 3 : 0) + (below(9) == 0 ? 4 : 0));
      else
        text += *c;
    }
    return text;
  }

  std::string change() {
    const std::string table = GetParam().with_other && below(2) ? "ferries" : "ships";
    const std::string id = std::to_string(below(50));
    switch (below(6)) {
      case 0:
        return "DELETE FROM " + table + " WHERE id = " + id;
      case 1:
        return "UPDATE OR REPLACE " + table + " SET id = " + std::to_string(below(50)) + " WHERE id = " + id;
      case 2:
        return "UPDATE " + table + " SET y = y + 1 WHERE id = " + id;
      default:
        return "INSERT OR REPLACE INTO " + table + " VALUES (" + id + ", " + values() + ")";
    }
  }

  std::string changes(int most) {
    std::string sql;
    for (int i = 1 + below(most); i > 0; --i) sql += change() + ";";
    return sql;
  }

  std::string one_commit() {
    moment_ += below(20) == 0 ? 40 : below(3);
    const std::string advance =
        "INSERT INTO alerts(alerts, now) VALUES('advance', " + std::to_string(moment_ + 1) + ");";
    switch (below(10)) {
      case 0:
        return advance;
      case 1:
        return "INSERT INTO ships(ships) VALUES('rebuild')";
      case 2:
        return "BEGIN;" + changes(9) + "SAVEPOINT s;" + changes(9) + advance + "ROLLBACK TO s;" + changes(3) +
               "COMMIT";
      case 3:
        return "BEGIN;" + changes(9) + "ROLLBACK";
      case 4:
        return "BEGIN;" + changes(70) + "SAVEPOINT s;" + changes(3) + "RELEASE s; COMMIT";
      case 5:
        return "BEGIN; SAVEPOINT s;" + changes(9) + advance + "RELEASE s; COMMIT";
      default:
        return change();
    }
  }

  static std::string rows(Database& db, const std::string& from) {
    return db.rows("SELECT a, b, t, t_end, dt, dt_end, t_cpa, dt_cpa, d_cpa FROM " + from + " ORDER BY a, b");
  }
  void expect_joined(Database& db, const std::string& after) {
    const std::string now = db.rows("SELECT now FROM predictive_watches");
    ASSERT_EQ(rows(db, "alerts"),
              rows(db, "predictive_join WHERE tbl = 'ships' AND now = " + now + " AND " + GetParam().join))
        << after;
  }
  void expect_folded(Database& db, const std::string& after) {
    if (position_ == "0") folded_.clear();  // the whole watch comes
    std::istringstream told(
        db.rows("SELECT op, a, b, ifnull(t, 0) FROM predictive_changes('alerts', " + position_ + ")"));
    for (std::string line; std::getline(told, line);) {
      const std::string pair = line.substr(2, line.rfind('|') - 2);
      ASSERT_EQ(folded_.contains(pair), line[0] != '+') << line << after;
      if (line[0] == '-')
        folded_.erase(pair);
      else
        folded_[pair] = std::stod(line.substr(line.rfind('|') + 1));
    }
    position_ = db.rows("SELECT seq FROM predictive_watches");
    const double now = std::stod(db.rows("SELECT now FROM predictive_watches"));
    std::istringstream kept(db.rows("SELECT a, b, t FROM alerts"));
    std::size_t pairs = 0;
    for (std::string line; std::getline(kept, line); ++pairs) {
      const std::string pair = line.substr(0, line.rfind('|'));
      ASSERT_TRUE(folded_.contains(pair)) << pair << after;
      ASSERT_NEAR(std::max(folded_[pair], now), std::stod(line.substr(line.rfind('|') + 1)),
                  GetParam().tolerance)
          << after;
    }
    ASSERT_EQ(pairs, folded_.size()) << after;
  }

  std::mt19937 random_{7};
  int moment_ = 0;
  std::map<std::string, double> folded_;
  std::string position_ = "0";
};

TEST_P(WatchLife, EqualsTheJoinAndTheFoldedChanges) {
  const TemporaryFile file;
  auto db = std::make_unique<Database>(file.path());
  const std::string columns = std::string("(id, ") + GetParam().columns + ")";
  db->exec("PRAGMA synchronous = OFF; CREATE VIRTUAL TABLE ships USING moving_objects" + columns);
  if (GetParam().with_other) db->exec("CREATE VIRTUAL TABLE ferries USING moving_objects" + columns);
  db->exec(std::string("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, ") + GetParam().options +
           ")");
  for (int commit = 0; commit < 150 && !HasFatalFailure(); ++commit) {
    const std::string sql = one_commit();
    const std::string after = " after commit " + std::to_string(commit) + ": " + sql;
    if (below(12) == 0) {  // by another connection
      Database other(file.path());
      other.exec(sql);
    } else {
      db->exec(sql);
    }
    if (below(15) == 0) db = std::make_unique<Database>(file.path());
    expect_joined(*db, after);
    if (!HasFatalFailure()) expect_folded(*db, after);
    ASSERT_EQ(db->rows("SELECT fault FROM predictive_watches"), "NULL") << after;
    if (commit % 40 == 0) db->exec("INSERT INTO alerts(alerts) VALUES('integrity-check')");
  }
  db->exec("BEGIN;" + changes(9));
  expect_joined(*db, " in a transaction");
  db->exec("ROLLBACK");
}

INSTANTIATE_TEST_SUITE_P(Scenes, WatchLife, ::testing::ValuesIn(lives),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace foresee::sqlite
