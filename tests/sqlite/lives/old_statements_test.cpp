// Statements that stay prepared, as Python's driver keeps them by default: each holds the virtual tables that
// it was compiled for, also those that SQLite has replaced since. Changes that a transaction left in a
// replaced table must not reach its successor.
#include "sqlite/lives/old_statements.h"

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* discs = "CREATE VIRTUAL TABLE s USING moving_objects(id, x);";
constexpr const char* watch = "CREATE VIRTUAL TABLE w USING predictive_watch(s, horizon = 5);";
constexpr const char* all_pairs = "SELECT a, b FROM w ORDER BY a, b";

struct OldStatements : ::testing::Test {
  /// Another connection sees the committed rows, and its integrity checks pass.
  void expect_sound(const std::string& rows, const std::string& pairs) {
    Database other(file.path());
    EXPECT_EQ(other.rows("SELECT id FROM s ORDER BY id"), rows);
    EXPECT_EQ(other.error_of("INSERT INTO s(s) VALUES('integrity-check')"), "");
    if (!pairs.empty()) {
      EXPECT_EQ(other.rows(all_pairs), pairs);
      EXPECT_EQ(other.rows("SELECT fault FROM predictive_watches"), "NULL");
    }
  }
  void make_and_change_schema() {
    driver.exec(std::string(discs) + "INSERT INTO s VALUES(1, 1); INSERT INTO s VALUES(2, 1);" + watch);
    Database(file.path()).exec("CREATE TABLE q(x)");
  }

  TemporaryFile file;
  KeepingDriver driver{file.path()};
};

TEST_F(OldStatements, ATableWhoseCreationWasRolledBackDoesNotEmptyTheNextOne) {
  driver.exec(std::string("BEGIN;") + discs + "INSERT INTO s VALUES(1, 1)");
  EXPECT_NE(driver.error_of("INSERT INTO s VALUES(2, NULL)"), "");
  driver.exec(std::string("ROLLBACK; BEGIN;") + discs +
              "INSERT INTO s VALUES(1, 1); INSERT INTO s VALUES(2, 1);" + watch + "COMMIT");
  EXPECT_EQ(driver.rows("SELECT id FROM s ORDER BY id"), "1\n2");
  expect_sound("1\n2", "1|2");
}

TEST_F(OldStatements, ATableThatAnotherConnectionCreatedAgainIsWatchedByItsOwnColumns) {
  driver.exec(
      "CREATE VIRTUAL TABLE s USING moving_objects(id, x, y); INSERT INTO s VALUES(1, 0, 0);"
      "INSERT INTO s VALUES(2, 0, 9)");
  Database(file.path())
      .exec(
          "DROP TABLE s; CREATE VIRTUAL TABLE s USING moving_objects(id, x, vx); INSERT INTO s VALUES(1, 0, "
          "0);"
          "CREATE VIRTUAL TABLE w USING predictive_watch(s, horizon = 5)");
  EXPECT_EQ(driver.error_of("INSERT INTO s VALUES(3, 4, -1)"), "");
  EXPECT_EQ(driver.error_of("INSERT INTO s VALUES(4, 9, 0)"), "");
  expect_sound("1\n3\n4", "1|3");
}

TEST_F(OldStatements, ADropThatIsRolledBackLeavesTheWatchWhole) {
  make_and_change_schema();
  driver.exec(
      "BEGIN; INSERT INTO s VALUES(3, 1); DROP TABLE w; DROP TABLE s; ROLLBACK;"
      "INSERT INTO s VALUES(4, 1)");
  expect_sound("1\n2\n4", "1|2\n1|4\n2|4");
}

TEST_F(OldStatements, ARenameThatIsRolledBackIsForgotten) {
  make_and_change_schema();
  driver.exec("BEGIN; ALTER TABLE s RENAME TO s2; ROLLBACK");
  EXPECT_EQ(driver.rows(all_pairs), "1|2");
  driver.exec("INSERT INTO s VALUES(4, 1)");
  EXPECT_EQ(driver.rows(all_pairs), "1|2\n1|4\n2|4");
  expect_sound("1\n2\n4", "1|2\n1|4\n2|4");
}

TEST_F(OldStatements, ADropThatIsRolledBackAfterVacuumLeavesTheCountRight) {
  driver.exec(std::string(discs) +
              "INSERT INTO s VALUES(1, 1); INSERT INTO s VALUES(2, 1); VACUUM;"
              "BEGIN; INSERT INTO s VALUES(3, 1); DROP TABLE s; ROLLBACK");
  driver.exec(watch);
  expect_sound("1\n2", "1|2");
}

/// SQL's rollback_at(x, limit): x, and from `limit` on it rolls the transaction back.
void rollback_at(sqlite3_context* context, int, sqlite3_value** arguments) {
  if (sqlite3_value_int(arguments[0]) == sqlite3_value_int(arguments[1]))
    sqlite3_exec(sqlite3_context_db_handle(context), "ROLLBACK", nullptr, nullptr, nullptr);
  sqlite3_result_value(context, arguments[0]);
}

TEST_F(OldStatements, ARollbackInsideAnInsertEndsItAndLosesNothingLater) {
  driver.exec(std::string(discs) + "INSERT INTO s VALUES(1, 1)");
  sqlite3_create_function(driver.handle(), "rollback_at", 2, SQLITE_UTF8, nullptr, rollback_at, nullptr,
                          nullptr);
  driver.exec("BEGIN");
  EXPECT_NE(
      driver.error_of("INSERT INTO s SELECT rollback_at(column1, 11), 1 FROM (VALUES (10), (11), (12))"), "");
  EXPECT_EQ(sqlite3_get_autocommit(driver.handle()), 1);
  Database(file.path()).exec("INSERT INTO s VALUES(30, 3)");
  driver.exec("INSERT INTO s VALUES(20, 1)");
  EXPECT_EQ(driver.rows("SELECT id FROM s ORDER BY id"), "1\n20\n30");
  expect_sound("1\n20\n30", "");
}

// SQLite reloads all schemas if a statement reads one that another connection has changed, and frees the
// table that a CREATE in another schema is making.
TEST_F(OldStatements, ATemporaryWatchIsCreatedWhileAnotherConnectionChangesTheFile) {
  driver.exec("CREATE VIRTUAL TABLE temp.s USING moving_objects(id, x)");
  for (int i = 0; i < 30; ++i) {
    Database(file.path()).exec("CREATE TABLE q" + std::to_string(i) + "(x, y, z)");
    driver.exec("CREATE VIRTUAL TABLE temp.w USING predictive_watch(s, horizon = 4)");
    driver.exec("INSERT OR REPLACE INTO temp.s VALUES(1, 2); INSERT OR REPLACE INTO temp.s VALUES(2, 2)");
    EXPECT_EQ(driver.rows("SELECT a, b FROM temp.w"), "1|2");
    driver.exec("DROP TABLE temp.w; DELETE FROM temp.s");
  }
}

// The same holds for a CREATE that is refused: it reads no other schema, not even for its message.
TEST_F(OldStatements, ARefusedTemporaryWatchReadsNoOtherSchema) {
  driver.exec(discs);
  driver.exec("CREATE VIRTUAL TABLE temp.own USING moving_objects(id, x)");
  std::string read;  // the schemas whose tables a statement of foresee lists
  sqlite3_set_authorizer(
      driver.handle(),
      [](void* list, int action, const char* table, const char* column, const char* schema, const char*) {
        if (action == SQLITE_READ && std::string(table).starts_with("sqlite_") &&
            std::string(column) == "sql")
          *static_cast<std::string*>(list) += std::string(schema) + " ";
        return SQLITE_OK;
      },
      &read);
  for (int i = 0; i < 30; ++i) {
    Database(file.path()).exec("CREATE TABLE q" + std::to_string(i) + "(x, y, z)");
    EXPECT_EQ(
        driver.error_of("CREATE VIRTUAL TABLE temp.w USING predictive_watch(s, horizon = 4)"),
        "w: no such table: 's' in schema 'temp'; a watch is in the schema of its table: write CREATE VIRTUAL "
        "TABLE main.w");
    EXPECT_NE(
        driver.error_of("CREATE VIRTUAL TABLE temp.w USING predictive_watch(own, horizon = 4, other = q0)"),
        "");
    EXPECT_EQ(read.find("main"), std::string::npos) << read;
    read.clear();
  }
  sqlite3_set_authorizer(driver.handle(), nullptr, nullptr);
}

}  // namespace
}  // namespace foresee::testing
