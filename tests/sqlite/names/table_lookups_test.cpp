// Name resolution after schema changes: a query finds under a known name the table that a first query would
// find.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct TableLookups : ::testing::Test {
  /// Creates a table with one object, whose id identifies the table.
  void make(const std::string& table, int id) {
    db.exec("CREATE VIRTUAL TABLE " + table + " USING moving_objects(id, x); INSERT INTO " + table +
            " VALUES(" + std::to_string(id) + ", 0)");
  }
  std::string found(const std::string& name = "ships") {
    return db.rows("SELECT id FROM predictive_window(1, '" + name + "')");
  }
  std::string missing(const std::string& name = "ships") {
    return "error: predictive_window: no such table: '" + name + "'";
  }

  TemporaryFile file;
  Database db{file.path()};
};

TEST_F(TableLookups, ATableCreatedAgain) {
  make("ships", 1);
  EXPECT_EQ(found(), "1");
  db.exec("DROP TABLE ships");
  EXPECT_TRUE(found().starts_with(missing())) << found();
  make("ships", 2);
  EXPECT_EQ(found(), "2");
  db.exec("DROP TABLE ships; CREATE TABLE ships(id, x)");
  EXPECT_TRUE(found().starts_with("error: predictive_window: 'ships' is not a moving_objects table"));
}

TEST_F(TableLookups, ARenamedTable) {
  make("ships", 1);
  EXPECT_EQ(found(), "1");
  db.exec("ALTER TABLE ships RENAME TO fleet");
  EXPECT_EQ(found("fleet"), "1");
  EXPECT_TRUE(found().starts_with(missing())) << found();
  make("ships", 2);
  EXPECT_EQ(found() + found("fleet"), "21");
  db.exec("BEGIN; ALTER TABLE ships RENAME TO third");
  EXPECT_EQ(found("third"), "2");
  db.exec("ROLLBACK");
  EXPECT_EQ(found(), "2");
}

TEST_F(TableLookups, ATemporaryTableComesFirst) {
  make("main.ships", 1);
  EXPECT_EQ(found(), "1");
  make("temp.ships", 2);
  EXPECT_EQ(found(), "2");
  db.exec("DROP TABLE temp.ships");
  EXPECT_EQ(found(), "1");
  db.exec("SAVEPOINT p");
  make("temp.ships", 3);
  EXPECT_EQ(found(), "3");
  db.exec("ROLLBACK TO p");
  EXPECT_EQ(found(), "1");
}

TEST_F(TableLookups, ATableOfMainComesBeforeAnAttachedOne) {
  db.exec("ATTACH ':memory:' AS other");
  make("other.ships", 1);
  EXPECT_EQ(found(), "1");
  make("main.ships", 2);
  EXPECT_EQ(found(), "2");
  db.exec("DROP TABLE main.ships");
  EXPECT_EQ(found(), "1");
}

TEST_F(TableLookups, AnotherFileUnderTheSameName) {
  const auto in_other = [&] {
    return db.rows("SELECT id FROM predictive_window(1, 'ships') WHERE schema = 'other'");
  };
  for (int id : {1, 2}) {
    db.exec("ATTACH '" + file.path(std::to_string(id)) + "' AS other");
    make("other.ships", id);
    EXPECT_EQ(in_other(), std::to_string(id));
    db.exec("DETACH other");
    EXPECT_TRUE(in_other().starts_with("error: predictive_window: no such table: 'ships' in schema 'other'"))
        << in_other();
  }
  db.exec("ATTACH '" + file.path("1") + "' AS other");
  EXPECT_EQ(in_other(), "1");
}

TEST_F(TableLookups, AnotherConnectionCreatesTheTableAgain) {
  make("ships", 1);
  EXPECT_EQ(found(), "1");
  Database other(file.path());
  other.exec(
      "DROP TABLE ships; CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y);"
      "INSERT INTO ships VALUES(2, 0, 0)");
  EXPECT_EQ(found(), "2");
}

TEST_F(TableLookups, ManyTablesInTurn) {
  const auto table = [](int id) { return std::string("t").append(std::to_string(id)); };
  for (int id = 1; id <= 20; ++id) make(table(id), id);
  for (int turn = 0; turn < 2; ++turn)
    for (int id = 1; id <= 20; ++id) EXPECT_EQ(found(table(id)), std::to_string(id));
}

TEST_F(TableLookups, VacuumAndDetachAreNotBlocked) {
  db.exec("ATTACH ':memory:' AS other");
  make("ships", 1);
  make("other.boats", 2);
  EXPECT_EQ(found() + found("boats"), "12");
  EXPECT_EQ(db.error_of("VACUUM"), "");
  EXPECT_EQ(db.error_of("DETACH other"), "");
  EXPECT_EQ(found(), "1");
}

// Statements keep a table in memory, with its scenes and nodes.
TEST_F(TableLookups, ADetachedTableIsReleased) {
  const auto statements_on = [&](const std::string& table) {
    int count = 0;
    for (sqlite3_stmt* s = nullptr; (s = sqlite3_next_stmt(db.handle(), s)) != nullptr;)
      count += std::string(sqlite3_sql(s)).find(table) != std::string::npos;
    return count;
  };
  db.exec("ATTACH ':memory:' AS other");
  make("other.boats", 2);
  for (int turn = 0; turn < 3; ++turn)
    EXPECT_EQ(db.rows("SELECT id FROM predictive_window(1, 'boats') WHERE schema = 'other'"), "2");
  EXPECT_EQ(db.rows("SELECT a FROM predictive_join(1, 'boats') WHERE schema = 'other'"), "");
  EXPECT_GT(statements_on("boats"), 0);
  db.exec("DETACH other; SELECT 1");  // SQLite disconnects a detached table when it compiles next
  EXPECT_EQ(statements_on("boats"), 0);
}

TEST_F(TableLookups, AnAuthorizerThatHidesTheSchemaHidesNoTable) {
  make("ships", 1);
  EXPECT_EQ(found(), "1");
  sqlite3_set_authorizer(
      db.handle(),
      [](void*, int action, const char* table, const char*, const char*, const char*) {
        return action == SQLITE_READ && std::string(table).starts_with("sqlite_") ? SQLITE_DENY : SQLITE_OK;
      },
      nullptr);
  for (int turn = 0; turn < 3; ++turn) EXPECT_EQ(found(), "1");
}

// As with `.load foresee` in both a start-up file and a script: the first functions remain registered, and
// find their tables.
TEST_F(TableLookups, LoadedASecondTime) {
  make("ships", 1);
  EXPECT_EQ(found(), "1");
  ASSERT_EQ(sqlite3_foresee_init(db.handle(), nullptr, nullptr), SQLITE_OK);
  db.exec("ATTACH ':memory:' AS other");
  make("other.ships", 2);
  make("boats", 3);
  EXPECT_EQ(found("ships"), "1");
  EXPECT_EQ(found("boats"), "3");
}

}  // namespace
}  // namespace foresee::testing
