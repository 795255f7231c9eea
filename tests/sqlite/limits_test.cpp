// Limits of a connection for hostile SQL: everything works within the limits that SQLite's page on security
// recommends. Smaller limits give a clear error that changes nothing.
#include "database.h"

namespace foresee::testing {
namespace {

constexpr const char* table =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name, +flag)";
constexpr const char* fill =
    "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 200)"
    "INSERT INTO ships SELECT i, 0, i, i % 7, 1, 0, 0.5, 'a' || i, 'de' FROM n";

TEST(Limits, EverythingWorksWithinThoseThatSQLiteRecommendsForHostileSql) {
  Database db;
  constexpr std::pair<int, int> advised[] = {
      {SQLITE_LIMIT_LENGTH, 1'000'000},
      {SQLITE_LIMIT_SQL_LENGTH, 100'000},
      {SQLITE_LIMIT_COLUMN, 100},
      {SQLITE_LIMIT_EXPR_DEPTH, 10},
      {SQLITE_LIMIT_COMPOUND_SELECT, 3},
      {SQLITE_LIMIT_VDBE_OP, 25'000},
      {SQLITE_LIMIT_FUNCTION_ARG, 8},
      {SQLITE_LIMIT_ATTACHED, 0},
      {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 50},
      {SQLITE_LIMIT_VARIABLE_NUMBER, 10},
      {SQLITE_LIMIT_TRIGGER_DEPTH, 10},
  };
  for (const auto& [limit, value] : advised) sqlite3_limit(db.handle(), limit, value);
  db.exec(table);
  db.exec(fill);
  db.exec(
      "UPDATE ships SET x = x + 1, name = 'b' || id WHERE id > 100; UPDATE ships SET id = 1000 WHERE id = "
      "200");
  db.exec("DELETE FROM ships WHERE id < 11");
  db.exec("INSERT INTO ships(ships) VALUES('rebuild'); INSERT INTO ships(ships) VALUES('optimize')");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  EXPECT_EQ(db.rows("SELECT name, flag FROM ships WHERE id IN (11, 1000)"), "a11|de\nb200|de");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(1, 'ships', 0, NULL, 0, 'grid')"),
            db.rows("SELECT count(*) FROM predictive_join(1, 'ships', 0, NULL, 0, 'scan')"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window(1, 'ships', 0, 1000, 0, 1000)"), "190");
  EXPECT_EQ(db.rows("SELECT id FROM predictive_nearest(0, 'ships', 1, 11, 4)"), "11");
}

TEST(Limits, AuxiliaryColumnsThatTakeMoreVariablesThanAllowedAreAClearError) {
  Database db;
  db.exec(table);
  db.exec(fill);
  sqlite3_limit(db.handle(), SQLITE_LIMIT_VARIABLE_NUMBER, 2);
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, x, y) VALUES(1000, 0, 0, 0)"),
            "ships: its auxiliary columns need 3 SQL variables, but this connection allows 2; raise "
            "SQLITE_LIMIT_VARIABLE_NUMBER, or declare fewer columns");
  EXPECT_NE(db.error_of("UPDATE ships SET name = 'x' WHERE id = 1").find("need 5 SQL variables"),
            std::string::npos);
  db.exec("UPDATE ships SET x = 1000 WHERE id = 1");  // which leaves them alone
  EXPECT_EQ(db.rows("SELECT count(*), max(x) FROM ships"), "200|1000.0");
}

TEST(Limits, AnythingSmallerIsAnErrorAndChangesNothing) {
  Database db;
  db.exec(table);
  db.exec(fill);
  const std::string before = db.rows("SELECT * FROM ships");
  for (const auto& [limit, value] :
       {std::pair{SQLITE_LIMIT_LENGTH, 1000}, std::pair{SQLITE_LIMIT_SQL_LENGTH, 80},
        std::pair{SQLITE_LIMIT_VARIABLE_NUMBER, 1}, std::pair{SQLITE_LIMIT_VDBE_OP, 5}}) {
    TemporaryFile file;
    Database other(file.path());
    other.exec(table);
    other.exec(fill);
    Database small(file.path());
    const int usual = sqlite3_limit(small.handle(), limit, value);
    EXPECT_NE(small.error_of("INSERT INTO ships VALUES(500, 0, 0, 0, 0, 0, 0, 'n', 'f')"), "") << limit;
    sqlite3_limit(small.handle(), limit, usual);
    EXPECT_EQ(small.rows("SELECT * FROM ships"), before) << limit;
    small.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  }
}

}  // namespace
}  // namespace foresee::testing
