// Rollback of CREATE, RENAME and DROP within savepoints: the earlier state comes back, as with any table, whatever
// changes were pending in memory. So it does if the rollback is interrupted, or if a write has failed half-way.
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

/// Interrupts the statement after so many steps of SQLite, and returns its message.
std::string error_after(Database& db, int steps, const char* sql) {
  const auto stop = [](void*) { return 1; };
  sqlite3_progress_handler(db.handle(), steps, stop, nullptr);
  const std::string message = db.error_of(sql);
  sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
  return message;
}

// An ordinary table lives the same life: SQLite may have rolled it back, interrupted or not.
TEST_F(SchemaSavepoints, AnInterruptedRollbackIsFollowed) {
  db.exec(
      "CREATE TABLE plain(id INTEGER PRIMARY KEY, x REAL); INSERT INTO plain VALUES(1, 1);"
      "CREATE VIRTUAL TABLE other USING moving_objects(id, x); INSERT INTO other VALUES(1, 1)");
  const std::string plain = "SELECT * FROM plain ORDER BY id", other = "SELECT * FROM other ORDER BY id";
  const auto write = [this](const std::string& values) {
    for (const char* table : {"q", "plain", "other"})
      db.exec("INSERT OR REPLACE INTO " + std::string(table) + " VALUES" + values);
  };
  int interrupted = 0;
  for (const std::string begin : {"SAVEPOINT a", "BEGIN; SAVEPOINT a", "BEGIN; SAVEPOINT a; SAVEPOINT b"})
    for (int steps = 1; steps < 40; ++steps) {
      db.exec(begin);
      write("(1, " + std::to_string(steps) + "), (" + std::to_string(steps) + ", 0.5)");
      interrupted += !error_after(db, steps, "ROLLBACK TO a").empty();
      if (steps % 3 == 0) {
        EXPECT_EQ(contents(), db.rows(plain)) << begin << ", " << steps;
      }
      write("(50, " + std::to_string(steps) + ")");
      EXPECT_EQ(contents(), db.rows(plain)) << begin << ", " << steps;
      db.exec("RELEASE a");
      if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("COMMIT");
      EXPECT_EQ(contents(), db.rows(plain)) << begin << ", " << steps;
      EXPECT_EQ(db.rows(other), db.rows(plain)) << begin << ", " << steps;
    }
  EXPECT_GT(interrupted, 0);
  EXPECT_EQ(db.error_of("INSERT INTO other(other) VALUES('integrity-check')"), "");
}

TEST_F(SchemaSavepoints, ARollbackRepairsATableThatAWriteTore) {
  db.exec(
      "CREATE VIRTUAL TABLE p USING moving_objects(id, x, y, plan);"
      "INSERT INTO p(id, plan) VALUES(1, 'LINESTRING M(0 0 0, 5 5 5)');"
      "CREATE TRIGGER no BEFORE DELETE ON p_leg BEGIN SELECT RAISE(ABORT, 'no'); END");
  const std::string update = "UPDATE p SET plan = 'LINESTRING M(1 1 0, 5 5 5)' WHERE id = 1";
  for (const std::string begin : {"SAVEPOINT a", "BEGIN; SAVEPOINT a", "BEGIN; SAVEPOINT a; SAVEPOINT b"}) {
    db.exec(begin);
    EXPECT_EQ(db.error_of(update), "no");
    db.exec("UPDATE q SET x = 7 WHERE id = 1; ROLLBACK TO a");
    EXPECT_EQ(contents(), "1|1.0");
    EXPECT_EQ(db.rows("SELECT id, x, y FROM p"), "1|0.0|0.0");
    db.exec("RELEASE a");
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("COMMIT");
  }
  db.exec("DROP TRIGGER no");
  db.exec(update);
  EXPECT_EQ(db.rows("SELECT id, x, y FROM p"), "1|1.0|1.0");
  EXPECT_EQ(db.error_of("INSERT INTO p(p) VALUES('integrity-check')"), "");
}

}  // namespace
}  // namespace foresee::testing
