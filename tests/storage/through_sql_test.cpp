// Store behind a real virtual table: what SQLite's callbacks do to it.
#include <filesystem>

#include "sqlite/foresee.h"
#include "storage/database.h"

namespace foresee {
namespace {

class ThroughSql : public ::testing::Test {
 protected:
  ThroughSql() {
    sqlite3_foresee_init(db, nullptr, nullptr);
    db.run("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, +name)");
    db.run("INSERT INTO ships VALUES(1, 10, 20, 'one'), (2, 30, 40, 'two')");
  }
  /// The error message of a statement, or "".
  std::string error_of(const std::string& sql) {
    char* message = nullptr;
    sqlite3_exec(db, sql.c_str(), nullptr, nullptr, &message);
    std::string text = message ? message : "";
    sqlite3_free(message);
    return text;
  }
  std::string ids() { return text("SELECT group_concat(id, ' ') FROM (SELECT id FROM ships ORDER BY id)"); }
  std::string text(const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db, sql.c_str(), -1, &statement, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
    std::string text = sqlite3_step(statement) == SQLITE_ROW && sqlite3_column_text(statement, 0)
                           ? reinterpret_cast<const char*>(sqlite3_column_text(statement, 0))
                           : "";
    sqlite3_finalize(statement);
    return text;
  }
  void expect_sound() { EXPECT_EQ(error_of("INSERT INTO ships(ships) VALUES('integrity-check')"), ""); }

  Database db;
};

const char* const many =
    "WITH RECURSIVE n(i) AS (SELECT 1000 UNION ALL SELECT i + 1 FROM n LIMIT 20000) "
    "INSERT INTO ships SELECT i, i, i, 'many' FROM n";

TEST_F(ThroughSql, AStatementThatFailsAfterSomeRowsUndoesItsOwnRowsOnly) {
  db.run("BEGIN; INSERT INTO ships VALUES(3, 0, 0, 'three')");
  EXPECT_NE(error_of("INSERT INTO ships SELECT column1, column2, 0, 'x' FROM "
                     "(VALUES(4, 0), (5, 0), (6, 1e999), (7, 0))"),
            "");
  EXPECT_EQ(ids(), "1 2 3");
  EXPECT_NE(error_of("UPDATE ships SET x = CASE id WHEN 3 THEN 1e999 ELSE -1 END"), "");
  EXPECT_EQ(text("SELECT group_concat(x, ' ') FROM ships"), "10.0 30.0 0.0");
  db.run("COMMIT");
  EXPECT_EQ(ids(), "1 2 3");
  expect_sound();
}

TEST_F(ThroughSql, OrIgnoreAndOrFailKeepTheRowsBefore) {
  db.run("BEGIN");
  db.run("INSERT OR IGNORE INTO ships SELECT column1, 0, 0, 'x' FROM (VALUES(2), (3), (1), (4))");
  EXPECT_EQ(ids(), "1 2 3 4");
  EXPECT_NE(error_of("INSERT OR FAIL INTO ships SELECT column1, 0, 0, 'x' FROM (VALUES(5), (1), (6))"), "");
  EXPECT_EQ(ids(), "1 2 3 4 5");
  db.run("COMMIT");
  expect_sound();
}

TEST_F(ThroughSql, AnAlterElsewhereKeepsUnwrittenChanges) {
  db.run("CREATE TABLE other(a)");
  db.run("BEGIN; INSERT INTO ships VALUES(3, 0, 0, 'three')");
  db.run("ALTER TABLE other ADD COLUMN b");
  db.run("INSERT INTO ships VALUES(4, 0, 0, 'four')");
  EXPECT_EQ(ids(), "1 2 3 4");
  db.run("ALTER TABLE other RENAME TO another; DELETE FROM ships WHERE id = 3; COMMIT");
  EXPECT_EQ(ids(), "1 2 4");
  expect_sound();
  db.run(
      "BEGIN; DELETE FROM ships WHERE id = 1; CREATE TABLE third(c); DELETE FROM ships WHERE id = 2; "
      "ROLLBACK");
  EXPECT_EQ(ids(), "1 2 4");
  expect_sound();
}

TEST_F(ThroughSql, RenamesInsideTransactionsCommitAndRollBack) {
  db.run("BEGIN; INSERT INTO ships VALUES(3, 0, 0, 'three'); ALTER TABLE ships RENAME TO boats");
  db.run("INSERT INTO boats VALUES(4, 0, 0, 'four')");
  EXPECT_EQ(text("SELECT count(*) FROM boats"), "4");
  db.run("ROLLBACK");
  EXPECT_EQ(ids(), "1 2");
  db.run("SAVEPOINT s; ALTER TABLE ships RENAME TO boats; DELETE FROM boats WHERE id = 1; ROLLBACK TO s");
  EXPECT_EQ(ids(), "1 2");
  db.run("INSERT INTO ships VALUES(5, 0, 0, 'five'); ALTER TABLE ships RENAME TO boats");
  db.run("UPDATE boats SET x = 7 WHERE id = 5; ALTER TABLE boats RENAME TO ships; RELEASE s");
  EXPECT_EQ(ids(), "1 2 5");
  expect_sound();
}

TEST_F(ThroughSql, ACommitThatCannotWriteRollsEverythingBack) {
  for (const char* action : {"ABORT", "ROLLBACK", "FAIL"})
    for (const char* suffix : {"node", "map"}) {
      db.run(std::string("CREATE TRIGGER forbid BEFORE INSERT ON ships_") + suffix + " BEGIN SELECT raise(" +
             action + ", 'forbidden'); END");
      db.run("BEGIN; INSERT INTO ships VALUES(3, 0, 0, 'three')");
      EXPECT_NE(error_of("COMMIT"), "") << action << " " << suffix;
      EXPECT_TRUE(sqlite3_get_autocommit(db));
      db.run("DROP TRIGGER forbid");
      EXPECT_EQ(ids(), "1 2");
      expect_sound();
    }
}

TEST_F(ThroughSql, ASavepointWritesNothing) {
  for (const char* suffix : {"node", "map"}) {
    db.run(std::string("CREATE TRIGGER forbid BEFORE INSERT ON ships_") + suffix +
           " BEGIN SELECT raise(ABORT, 'forbidden'); END");
    db.run("BEGIN; INSERT INTO ships VALUES(3, 0, 0, 'three'); SAVEPOINT s; DELETE FROM ships WHERE id = 1");
    EXPECT_EQ(ids(), "2 3");
    db.run("SAVEPOINT t; UPDATE ships SET x = 9; RELEASE t; ROLLBACK TO s");
    EXPECT_EQ(ids(), "1 2 3");
    db.run("ROLLBACK; DROP TRIGGER forbid");
    EXPECT_EQ(ids(), "1 2");
    expect_sound();
  }
}

TEST_F(ThroughSql, AFullDatabaseLosesNothingThatWasCommitted) {
  const std::int64_t pages = db.number("PRAGMA page_count");
  for (int room = 0; room < 20; room += 3)
    for (const char* around : {"", "BEGIN; "}) {
      db.run("PRAGMA max_page_count = " + std::to_string(pages + room));
      std::string error = error_of(around + std::string(many));
      if (error.empty()) error = error_of("COMMIT");
      EXPECT_EQ(error, "database or disk is full");
      if (!sqlite3_get_autocommit(db)) db.run("ROLLBACK");
      EXPECT_EQ(ids(), "1 2");
      db.run("PRAGMA max_page_count = 100000");
      expect_sound();
    }
}

TEST_F(ThroughSql, AnInterruptAtAnyStepLeavesTheTableWhole) {
  struct Countdown {
    int left;
    static int tick(void* self) { return --static_cast<Countdown*>(self)->left < 0; }
  };
  const std::string statement = "BEGIN; DELETE FROM ships WHERE id = 1; " + std::string(many) + "; COMMIT";
  int interrupted = 0;
  for (int steps = 1; steps < 4'000'000; steps *= 3) {
    Countdown countdown{steps};
    sqlite3_progress_handler(db, 10, Countdown::tick, &countdown);
    const std::string error = error_of(statement);
    sqlite3_progress_handler(db, 0, nullptr, nullptr);
    if (!sqlite3_get_autocommit(db)) db.run("ROLLBACK");
    expect_sound();
    if (error.empty()) break;
    ++interrupted;
    EXPECT_EQ(ids(), "1 2") << error;
  }
  EXPECT_GT(interrupted, 3);
  EXPECT_EQ(text("SELECT count(*) FROM ships"), "20001");
}

TEST_F(ThroughSql, DropAndCreateInOneTransactionStartAfresh) {
  db.run("BEGIN; INSERT INTO ships VALUES(3, 0, 0, 'three'); DROP TABLE ships");
  db.run(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, +name); INSERT INTO ships VALUES(9, 0, 0, "
      "'nine')");
  EXPECT_EQ(ids(), "9");
  db.run("ROLLBACK");
  EXPECT_EQ(ids(), "1 2");
  db.run("BEGIN; DROP TABLE ships; CREATE VIRTUAL TABLE ships USING moving_objects(id, x, +name)");
  db.run("INSERT INTO ships VALUES(9, 0, 'nine'); COMMIT");
  EXPECT_EQ(ids(), "9");
  expect_sound();
}

TEST_F(ThroughSql, CreateIsAtomicWhereAShadowTableExists) {
  for (const char* around : {"", "BEGIN; "}) {
    db.run("CREATE TABLE IF NOT EXISTS boats_meta(mine)");
    EXPECT_NE(error_of(around + std::string("CREATE VIRTUAL TABLE boats USING moving_objects(id, x)"))
                  .find("boats_meta"),
              std::string::npos);
    EXPECT_EQ(text("SELECT group_concat(name) FROM sqlite_schema WHERE name LIKE 'boats%'"), "boats_meta");
    if (!sqlite3_get_autocommit(db)) db.run("COMMIT");
  }
}

TEST_F(ThroughSql, ATriggerOnAShadowTableThatReadsTheTableDoesNoHarm) {
  db.run("CREATE TABLE seen(n)");
  const std::string trigger =
      "CREATE TRIGGER look AFTER INSERT ON ships_map BEGIN INSERT INTO seen SELECT count(*) FROM ships; END";
  db.run(trigger);
  error_of("INSERT INTO ships VALUES(3, 0, 0, 'three')");  // an error or not: SQLite decides
  db.run("DROP TRIGGER look");
  expect_sound();
}

TEST_F(ThroughSql, AttachedDatabasesDetach) {
  db.run("ATTACH ':memory:' AS aux; CREATE VIRTUAL TABLE aux.boats USING moving_objects(id, x)");
  db.run("INSERT INTO boats VALUES(1, 2); SELECT * FROM boats; DELETE FROM boats");
  db.run("DETACH aux");
}

TEST_F(ThroughSql, AReaderInWalModeKeepsItsSnapshotWhileAnotherWrites) {
  const auto file = std::filesystem::path(FORESEE_BINARY_DIR) / "through_sql.db";
  const auto remove = [&] {
    for (const char* end : {"", "-wal", "-shm"}) std::filesystem::remove(file.string() + end);
  };
  remove();
  {
    Database writer(file.string()), reader(file.string());
    for (Database* each : {&writer, &reader}) sqlite3_foresee_init(*each, nullptr, nullptr);
    writer.run("PRAGMA journal_mode = wal; CREATE VIRTUAL TABLE ships USING moving_objects(id, x)");
    writer.run("INSERT INTO ships VALUES(1, 1)");
    reader.run("BEGIN; SELECT * FROM ships");
    writer.run("BEGIN; INSERT INTO ships VALUES(2, 2); UPDATE ships SET x = 5 WHERE id = 1; COMMIT");
    const auto sum = [](Database& db) {
      sqlite3_stmt* statement = nullptr;
      sqlite3_prepare_v2(db, "SELECT sum(x) FROM ships", -1, &statement, nullptr);
      sqlite3_step(statement);
      const double result = sqlite3_column_double(statement, 0);
      sqlite3_finalize(statement);
      return result;
    };
    EXPECT_EQ(sum(reader), 1);
    reader.run("COMMIT");
    EXPECT_EQ(sum(reader), 7);
    EXPECT_EQ(sum(writer), 7);
  }
  remove();
}

}  // namespace
}  // namespace foresee
