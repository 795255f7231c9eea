// Watches read within a transaction: for each update method of a watch, the rows are those of the join.
#include <random>

#include "sqlite/database.h"

namespace foresee {
namespace {

using testing::Database;

std::string all_columns(Database& db, const std::string& from) {
  return db.rows("SELECT a, b, t, t_end, dt, dt_end, t_cpa, dt_cpa, d_cpa FROM " + from + " ORDER BY a, b");
}

/// 400 objects: few changes are probes, 40 are joined with all objects, from 130 on all pairs are recomputed.
class WatchVariants : public ::testing::TestWithParam<const char*> {
 protected:
  WatchVariants() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
        "CREATE VIRTUAL TABLE ferries USING moving_objects(id, t, x, y, vx, vy, r)");
    for (const char* table : {"ships", "ferries"})
      for (int id = 1; id <= 400; ++id) put(table, id);
    db.exec(std::string("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 8") +
            GetParam() + ")");
  }

  void put(const std::string& table, int id) {
    const auto draw = [&](int n) {
      return std::to_string(static_cast<int>(random_() % unsigned(2 * n + 1)) - n);
    };
    db.exec("INSERT OR REPLACE INTO " + table + " VALUES (" + std::to_string(id) + ", " +
            std::to_string(time_) + ", " + draw(150) + ", " + draw(150) + ", " + draw(4) + ", " + draw(4) +
            ", 1)");
  }
  void change(int count) {
    for (int i = 0; i < count; ++i)
      put(i % 3 == 2 ? "ferries" : "ships", 1 + static_cast<int>(random_() % 400));
  }

  std::string join() {
    std::string options = GetParam();
    const std::string now = db.rows("SELECT now FROM predictive_watches");
    std::string where = "predictive_join WHERE h = 8 AND tbl = 'ships' AND now = " + now;
    if (options.find("ferries") != std::string::npos) where += " AND other = 'ferries'";
    if (options.find("ships") != std::string::npos) where += " AND other = 'ships'";
    return where;
  }
  void expect_joined() {
    ASSERT_EQ(all_columns(db, "alerts"), all_columns(db, join()));
    ASSERT_EQ(all_columns(db, "alerts WHERE a = 7"), all_columns(db, join() + " AND a = 7"));
    ASSERT_EQ(all_columns(db, "alerts WHERE b = 390"), all_columns(db, join() + " AND b = 390"));
    ASSERT_EQ(db.rows("SELECT a, b, t FROM alerts ORDER BY a, b"),
              db.rows("SELECT a, b, t FROM " + join() + " ORDER BY a, b"));
  }

  Database db;
  std::mt19937 random_{3};
  int time_ = 0;
};

TEST_P(WatchVariants, AnyNumberOfChangesGivesTheRowsOfTheJoin) {
  for (const int count : {1, 60, 5, 300, 20, 90, 2, 600, 30}) {
    ++time_;
    db.exec("BEGIN");
    change(count);
    expect_joined();
    db.exec("SAVEPOINT s");
    change(10);
    db.exec("DELETE FROM ships WHERE id = 7; UPDATE ships SET id = 1007 WHERE id = 8");
    expect_joined();
    db.exec("ROLLBACK TO s");
    expect_joined();
    db.exec("COMMIT");
    expect_joined();
    db.exec("INSERT INTO alerts(alerts) VALUES('integrity-check')");
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, WatchVariants, ::testing::Values("", ", other = ferries", ", other = ships"),
                         [](const auto& info) {
                           return std::string(info.index == 0   ? "One"
                                              : info.index == 1 ? "Two"
                                                                : "WithItself");
                         });

TEST(WatchTransaction, ReadsTheRowsOfAPendingAdvance) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 10);"
      "INSERT INTO ships VALUES (1, 0, 0, 0, 0, 0, 1), (2, 0, 22, 0, -1, 0, 1);"
      "BEGIN; INSERT INTO alerts(alerts, now) VALUES('advance', 15)");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "1|2|20.0");
  db.exec("ROLLBACK");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "");
}

/// More changes than ObjectChanges logs, after a pause of the feed: the pairs are joined again, and the clock follows.
TEST(WatchTransaction, OfVeryManyObjectsJoinsThemAgain) {
  Database db;
  const auto report = [&](const std::string& t) {
    db.exec("UPDATE ships SET t = " + t + ", vx = -vx; UPDATE ships SET vx = 0 WHERE id % 1000 = 0");
  };
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx, r);"
      "INSERT INTO ships WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM n WHERE id < 262200)"
      "  SELECT id, 0, id * 100, iif(id % 1000 < 2, 9 - id % 2 * 18, 0), 1 FROM n;"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 20, ahead = 60)");
  const auto expect_joined = [&](const std::string& now) {
    ASSERT_EQ(db.rows("SELECT now, early, fault FROM predictive_watches"), now);
    const std::string joined = all_columns(
        db, "predictive_join WHERE h = 20 AND tbl = 'ships' AND now = " + now.substr(0, now.find('|')));
    ASSERT_EQ(all_columns(db, "alerts"), joined);
    db.exec("INSERT INTO alerts(alerts) VALUES('integrity-check')");
  };
  expect_joined("0.0|0|NULL");
  EXPECT_EQ(db.rows("SELECT count(*) FROM alerts"), "262");
  db.exec("BEGIN; SAVEPOINT s");
  report("500");
  db.exec("ROLLBACK TO s");
  db.exec("COMMIT");
  expect_joined("0.0|0|NULL");
  report("500");
  expect_joined("500.0|0|NULL");
}

}  // namespace
}  // namespace foresee
