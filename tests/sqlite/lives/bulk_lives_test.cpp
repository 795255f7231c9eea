// Random statements of one and of many rows in random transactions, beside an ordinary table. After each statement both
// have the same rows: by id, by a scan, in a window.
#include "sanitized.h"
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr int ids = 4000;

class BulkLives : public ::testing::Test {
 protected:
  BulkLives() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy);"
        "CREATE TABLE plain(id INTEGER PRIMARY KEY, x REAL, y REAL, vx REAL, vy REAL)");
    sqlite3_prepare_v2(db.handle(), "SELECT x FROM ships WHERE id = ?", -1, &by_id, nullptr);
  }
  ~BulkLives() override { sqlite3_finalize(by_id); }

  void exec_both(const std::string& before, const std::string& after) {
    for (const char* table : {"ships", "plain"}) db.exec(before + table + after);
  }
  std::string some_id() { return std::to_string(random.below(ids)); }
  /// One id, all from a random one on, some of them, every n-th, or those of a place.
  std::string condition() {
    const std::string first = some_id();
    switch (random.below(5)) {
      case 0:
        return " WHERE id = " + first;
      case 1:
        return " WHERE id >= " + first;
      case 2:
        return " WHERE id BETWEEN " + first + " AND " + first + " + 200";
      case 3:
        return " WHERE x < " + std::to_string(random.below(1000));
      default:
        return " WHERE id % " + std::to_string(1 + random.below(7)) + " = 0";
    }
  }
  /// Rows that are new, or conflict with others.
  std::string rows(std::size_t count) {
    return " SELECT (value * 7919 + " + some_id() + ") % " + std::to_string(ids) +
           ", value * 31 % 997, value * 17 % 991, value % 5 - 2, value % 3 - 1 FROM (WITH RECURSIVE "
           "numbers(value) AS (SELECT 1 UNION ALL SELECT value + 1 FROM numbers WHERE value < " +
           std::to_string(count) + ") SELECT value FROM numbers)";
  }
  void change() {
    switch (random.below(8)) {
      case 0:
        return exec_both("INSERT OR REPLACE INTO ", rows(1 + random.below(1500)));
      case 1:
        return exec_both("INSERT OR IGNORE INTO ", rows(1 + random.below(1500)));
      case 2:
      case 3:
        return exec_both("DELETE FROM ", condition());
      case 4:  // and some of them again
        exec_both("DELETE FROM ", condition());
        return exec_both("INSERT OR IGNORE INTO ", rows(500));
      case 5:
        return exec_both("UPDATE ", " SET x = x + 1, vy = -vy" + condition());
      case 6:
        if (random.below(10) == 0) exec_both("DELETE FROM ", "");
        return;
      default:
        return transact();
    }
  }
  void transact() {
    if (sqlite3_get_autocommit(db.handle()) != 0) {
      savepoints = 0;
      return db.exec("BEGIN");
    }
    switch (random.below(6)) {
      case 0:
        return db.exec("COMMIT");
      case 1:
        return db.exec("ROLLBACK");
      case 2:
      case 3:
        if (savepoints == 0) return;
        --savepoints;
        return db.exec(random.below(3) == 0 ? "RELEASE s" : "ROLLBACK TO s; RELEASE s");
      default:
        ++savepoints;
        return db.exec("SAVEPOINT s");
    }
  }
  std::string of(const std::string& sql, const char* table) {
    return db.rows(std::string(sql).replace(sql.find('$'), 1, table));
  }
  void expect_equal() {
    constexpr const char* sums = "SELECT count(*), total(id), total(x), total(y * id), total(vy) FROM $";
    switch (random.below(4)) {
      case 0:  // reads what is pending, and leaves it so
        for (int i = 0; i < 20; ++i) {
          const auto id = static_cast<sqlite3_int64>(random.below(ids));
          sqlite3_bind_int64(by_id, 1, id);
          ASSERT_EQ(db.rows_of(by_id), of("SELECT x FROM $ WHERE id = " + std::to_string(id), "plain")) << id;
          sqlite3_reset(by_id);
        }
        return;
      case 1:
        ASSERT_EQ(of(sums, "ships"), of(sums, "plain"));
        return;
      case 2:
        ASSERT_EQ(
            db.rows("SELECT id FROM predictive_window WHERE h = 0 AND tbl = 'ships' AND x0 = 100 AND x1 "
                    "= 400 AND y0 = 0 AND y1 = 300 ORDER BY id"),
            db.rows("SELECT id FROM plain WHERE x BETWEEN 100 AND 400 AND y BETWEEN 0 AND 300 "
                    "ORDER BY id"));
        return;
      default:
        ASSERT_EQ(of("SELECT max(id) FROM $", "ships"), of("SELECT max(id) FROM $", "plain"));
    }
  }

  TemporaryFile file;
  Database db{file.path()};
  sqlite3_stmt* by_id = nullptr;
  Random random{20261129};
  int savepoints = 0;
};

TEST_F(BulkLives, HoldTheRowsOfAnOrdinaryTable) {
  constexpr int steps = sanitized ? 300 : 2500;
  for (int step = 0; step < steps; ++step) {
    change();
    ASSERT_NO_FATAL_FAILURE(expect_equal()) << step;
    if (step % 100 == 0 && sqlite3_get_autocommit(db.handle()) != 0) {
      ASSERT_EQ(db.error_of("INSERT INTO ships(ships) VALUES('integrity-check')"), "") << step;
    }
  }
}

}  // namespace
}  // namespace foresee::testing
