// Rollback of CREATE, RENAME and DROP within savepoints: the earlier state comes back, as with any table,
// whatever changes were pending in memory.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct SchemaSavepoints : ::testing::Test {
  SchemaSavepoints() {
    db.exec("CREATE VIRTUAL TABLE q USING moving_objects(id, x); INSERT INTO q VALUES(1, 1)");
  }
  ~SchemaSavepoints() override {
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("COMMIT");
    Database other(file.path());
    EXPECT_EQ(other.error_of("INSERT INTO q(q) VALUES('integrity-check')"), "");
    EXPECT_EQ(other.rows("SELECT * FROM q ORDER BY id"), db.rows("SELECT * FROM q ORDER BY id"));
  }
  std::string contents() { return db.rows("SELECT * FROM q ORDER BY id"); }

  TemporaryFile file;
  Database db{file.path()};
};

TEST_F(SchemaSavepoints, ATableCreatedAgainUnderTheSameNameLeavesNothing) {
  for (const char* first : {"DROP TABLE q", "ALTER TABLE q RENAME TO old"}) {
    db.exec("BEGIN; SAVEPOINT p");
    db.exec(first);
    db.exec(
        "CREATE VIRTUAL TABLE q USING moving_objects(id, x, y); INSERT INTO q VALUES(7, 7, 7); ROLLBACK TO "
        "p");
    EXPECT_EQ(contents(), "1|1.0");
    db.exec("INSERT INTO q VALUES(9, 9); COMMIT");
    EXPECT_EQ(contents(), "1|1.0\n9|9.0");
    db.exec("DELETE FROM q WHERE id = 9");
  }
}

TEST_F(SchemaSavepoints, ATableWhoseCreationWasRolledBackDoesNotStopTheCommit) {
  db.exec(
      "BEGIN; SAVEPOINT p; CREATE VIRTUAL TABLE k USING moving_objects(id, x); INSERT INTO k VALUES(1, 1);"
      "ROLLBACK TO p; INSERT INTO q VALUES(2, 2); COMMIT");
  EXPECT_EQ(contents(), "1|1.0\n2|2.0");
  for (const char* columns : {"id, x", "id, x, y"})
    db.exec(
        "BEGIN; SAVEPOINT p; CREATE VIRTUAL TABLE k USING moving_objects(id, x); INSERT INTO k VALUES(1, 1);"
        "ROLLBACK TO p; CREATE VIRTUAL TABLE k USING moving_objects(" +
        std::string(columns) + "); INSERT INTO k(id, x" + (columns[5] ? ", y" : "") + ") VALUES(4, 5" +
        (columns[5] ? ", 6" : "") + "); COMMIT; INSERT INTO k(k) VALUES('integrity-check'); DROP TABLE k");
}

TEST_F(SchemaSavepoints, ARenameIsRolledBack) {
  db.exec(
      "BEGIN; INSERT INTO q VALUES(2, 2); SAVEPOINT p; INSERT INTO q VALUES(3, 3); ALTER TABLE q RENAME TO "
      "z");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window(1, 'z')"), "3");
  db.exec("ROLLBACK TO p");
  EXPECT_EQ(contents(), "1|1.0\n2|2.0");
  db.exec("INSERT INTO q VALUES(4, 4); COMMIT");
  EXPECT_EQ(contents(), "1|1.0\n2|2.0\n4|4.0");
}

TEST_F(SchemaSavepoints, ARenameIsRolledBackUnderAnOpenCursor) {
  for (const char* read : {"SELECT id FROM q", "SELECT id FROM predictive_window(10, 'q')"}) {
    sqlite3_stmt* reading = nullptr;
    sqlite3_prepare_v2(db.handle(), read, -1, &reading, nullptr);
    db.exec("BEGIN");
    EXPECT_EQ(sqlite3_step(reading), SQLITE_ROW);
    db.error_of("ALTER TABLE q RENAME TO z");
    sqlite3_finalize(reading);
    db.exec("ROLLBACK");
    EXPECT_EQ(contents(), "1|1.0");
    db.exec("UPDATE q SET x = 1");
  }
}

TEST_F(SchemaSavepoints, DroppingDoesNotLosePendingChangesOfBeforeASavepoint) {
  db.exec("BEGIN; INSERT INTO q VALUES(2, 2); SAVEPOINT s");
  EXPECT_EQ(db.code_of("DROP TABLE q") & 0xff, SQLITE_LOCKED);
  EXPECT_EQ(contents(), "1|1.0\n2|2.0");
  db.exec("ROLLBACK TO s; COMMIT");
  EXPECT_EQ(contents(), "1|1.0\n2|2.0");
  db.exec("BEGIN; SAVEPOINT s; DROP TABLE q; ROLLBACK TO s; COMMIT");  // without pending changes
  EXPECT_EQ(contents(), "1|1.0\n2|2.0");
  // Without a savepoint only the start of the transaction can be restored.
  db.exec("BEGIN; INSERT INTO q VALUES(3, 3); DROP TABLE q; ROLLBACK");
  EXPECT_EQ(contents(), "1|1.0\n2|2.0");
}

}  // namespace
}  // namespace foresee::testing
