// Transactions and savepoints: rollback at any point, two connections.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* create_named = "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, +name TEXT)";
constexpr const char* fill_named =
    "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 300)"
    "INSERT INTO ships SELECT i, i, 0, 'ship ' || i FROM n";

struct TableTransactions : ::testing::Test {
  TableTransactions() {
    db.exec(create_named);
    db.exec(fill_named);
  }

  std::string sums() { return db.rows("SELECT count(*), sum(x), count(name) FROM ships"); }
  void expect_untouched() {
    EXPECT_EQ(sums(), "300|45150.0|300");
    db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  }

  Database db;
};

TEST_F(TableTransactions, CommitKeeps) {
  db.exec("BEGIN; UPDATE ships SET x = x + 1; DELETE FROM ships WHERE id > 100; COMMIT");
  EXPECT_EQ(sums(), "100|5150.0|100");
}

TEST_F(TableTransactions, RollbackRestoresEverything) {
  db.exec("BEGIN; UPDATE ships SET x = x + 1, name = NULL; DELETE FROM ships WHERE id > 100");
  db.exec("INSERT INTO ships(x) VALUES(7)");
  EXPECT_EQ(sums(), "101|5157.0|0");
  db.exec("ROLLBACK");
  expect_untouched();
}

TEST_F(TableTransactions, SavepointsNest) {
  db.exec("BEGIN; UPDATE ships SET x = 0 WHERE id = 1; SAVEPOINT a; UPDATE ships SET x = 0 WHERE id = 2;");
  db.exec("SAVEPOINT b; DELETE FROM ships");
  EXPECT_EQ(sums(), "0|NULL|0");
  db.exec("ROLLBACK TO b");
  EXPECT_EQ(sums(), "300|45147.0|300");
  db.exec("UPDATE ships SET x = 0 WHERE id = 3; RELEASE b");
  EXPECT_EQ(sums(), "300|45144.0|300");
  db.exec("ROLLBACK TO a");
  EXPECT_EQ(sums(), "300|45149.0|300");
  db.exec("ROLLBACK TO a; RELEASE a; COMMIT");
  EXPECT_EQ(sums(), "300|45149.0|300");
}

TEST_F(TableTransactions, ASavepointOpenBeforeTheFirstWrite) {
  db.exec("SAVEPOINT outer_one; SAVEPOINT inner_one; DELETE FROM ships WHERE id < 100");
  db.exec("ROLLBACK TO inner_one");
  expect_untouched();
  db.exec("DELETE FROM ships WHERE id < 50; ROLLBACK TO outer_one");
  expect_untouched();
  db.exec("RELEASE outer_one");
  expect_untouched();
}

TEST_F(TableTransactions, ReleaseOfTheOutermostSavepointCommits) {
  db.exec("SAVEPOINT only; UPDATE ships SET x = 1; RELEASE only");
  EXPECT_NE(sqlite3_get_autocommit(db.handle()), 0);
  EXPECT_EQ(sums(), "300|300.0|300");
}

TEST_F(TableTransactions, AFailedStatementLeavesTheTransactionAlone) {
  db.exec("BEGIN; DELETE FROM ships WHERE id = 300");
  EXPECT_NE(db.error_of("UPDATE ships SET x = CASE WHEN id = 200 THEN 'abc' ELSE 0 END"), "");
  EXPECT_EQ(sums(), "299|44850.0|299");
  EXPECT_NE(
      db.error_of("INSERT INTO ships(id, x) SELECT 1000 - id, x FROM ships WHERE id IN (1, 2) UNION ALL "
                  "SELECT 5, 5"),
      "");
  EXPECT_EQ(sums(), "299|44850.0|299");
  db.exec("COMMIT");
  EXPECT_EQ(sums(), "299|44850.0|299");
}

TEST_F(TableTransactions, ReadsBetweenWritesSeeThem) {
  db.exec("BEGIN");
  for (int i = 1; i <= 50; ++i) {
    db.exec("UPDATE ships SET x = -1 WHERE id = " + std::to_string(i));
    EXPECT_EQ(db.rows("SELECT count(*) FROM ships WHERE x = -1"), std::to_string(i));
  }
  db.exec("ROLLBACK");
  expect_untouched();
}

TEST_F(TableTransactions, CreateIsRolledBack) {
  db.exec(
      "BEGIN; CREATE VIRTUAL TABLE boats USING moving_objects(id, x); INSERT INTO boats VALUES(1, 1); "
      "ROLLBACK");
  EXPECT_EQ(db.error_of("SELECT * FROM boats"), "no such table: boats");
  EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'boats%'"), "0");
  db.exec("CREATE VIRTUAL TABLE boats USING moving_objects(id, x, +n); INSERT INTO boats VALUES(1, 1, 2)");
  EXPECT_EQ(db.rows("SELECT * FROM boats"), "1|1.0|2");
}

TEST_F(TableTransactions, CreateAndFillInOneTransaction) {
  db.exec("BEGIN; CREATE VIRTUAL TABLE boats USING moving_objects(id, x); INSERT INTO boats VALUES(1, 1);");
  db.exec("SAVEPOINT a; INSERT INTO boats VALUES(2, 2); ROLLBACK TO a; COMMIT");
  EXPECT_EQ(db.rows("SELECT * FROM boats"), "1|1.0");
}

TEST_F(TableTransactions, DropIsRolledBack) {
  db.exec("BEGIN; UPDATE ships SET x = 0; DROP TABLE ships; ROLLBACK");
  expect_untouched();
  db.exec("BEGIN; SAVEPOINT a; DROP TABLE ships; ROLLBACK TO a; COMMIT");
  expect_untouched();
}

TEST_F(TableTransactions, DropAndCreateAgainInOneTransaction) {
  db.exec("BEGIN; DROP TABLE ships; CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y);");
  db.exec("INSERT INTO ships VALUES(1, 2, 3); COMMIT");
  EXPECT_EQ(db.rows("SELECT * FROM ships"), "1|2.0|3.0");
}

TEST_F(TableTransactions, RenameInsideATransaction) {
  db.exec("BEGIN; UPDATE ships SET x = 0 WHERE id = 1; ALTER TABLE ships RENAME TO fleet");
  db.exec("UPDATE fleet SET x = 0 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT count(*), sum(x) FROM fleet"), "300|45147.0");
  db.exec("ROLLBACK");
  expect_untouched();
  db.exec("BEGIN; UPDATE ships SET x = 0 WHERE id = 1; ALTER TABLE ships RENAME TO fleet");
  db.exec("UPDATE fleet SET x = 0 WHERE id = 2; COMMIT");
  EXPECT_EQ(db.rows("SELECT count(*), sum(x) FROM fleet"), "300|45147.0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'ships%'"), "0");
  db.exec("INSERT INTO fleet(fleet) VALUES('integrity-check')");
}

// --- two connections ---------------------------------------------------------------------------------------

TEST(TableConnections, AWalReaderSeesCommitsAtItsNextStatement) {
  TemporaryFile file;
  Database writer(file.path());
  writer.exec(std::string("PRAGMA journal_mode = WAL; ") + create_named + ";" + fill_named);
  Database reader(file.path());
  const std::string sum = "SELECT sum(x) FROM ships";
  EXPECT_EQ(reader.rows(sum), "45150.0");
  writer.exec("BEGIN; UPDATE ships SET x = 1");
  EXPECT_EQ(reader.rows(sum), "45150.0");
  writer.exec("COMMIT");
  EXPECT_EQ(reader.rows(sum), "300.0");
  reader.exec("BEGIN");
  EXPECT_EQ(reader.rows(sum), "300.0");
  writer.exec("UPDATE ships SET x = 2; INSERT INTO ships(x) VALUES(5)");
  EXPECT_EQ(reader.rows(sum), "300.0") << "a read transaction sees one state";
  reader.exec("COMMIT");
  EXPECT_EQ(reader.rows(sum), "605.0");
  reader.exec("DELETE FROM ships WHERE id > 1");
  EXPECT_EQ(writer.rows(sum), "2.0");
  EXPECT_EQ(writer.rows("INSERT INTO ships(x) VALUES(9.5) RETURNING x"), "9.5");
  EXPECT_EQ(reader.rows("SELECT id, x FROM ships ORDER BY id"), "1|2.0\n2|9.5");
}

TEST(TableConnections, ARollbackJournalWorksAsWell) {
  TemporaryFile file;
  Database a(file.path());
  a.exec(std::string(create_named) + ";" + fill_named);
  Database b(file.path());
  b.exec("UPDATE ships SET x = 1");
  EXPECT_EQ(a.rows("SELECT sum(x) FROM ships"), "300.0");
  a.exec("BEGIN IMMEDIATE; DELETE FROM ships WHERE id = 1");
  EXPECT_EQ(b.code_of("DELETE FROM ships") & 0xff, SQLITE_BUSY);
  a.exec("COMMIT");
  b.exec("DELETE FROM ships WHERE id = 2");
  EXPECT_EQ(a.rows("SELECT count(*) FROM ships"), "298");
}

TEST(TableConnections, AnotherConnectionDropsOrRenames) {
  TemporaryFile file;
  Database a(file.path());
  a.exec(std::string(create_named) + ";" + fill_named);
  Database b(file.path());
  EXPECT_EQ(b.rows("SELECT count(*) FROM ships"), "300");
  a.exec("ALTER TABLE ships RENAME TO fleet");
  EXPECT_EQ(b.rows("SELECT count(*) FROM fleet"), "300");
  EXPECT_EQ(b.error_of("SELECT * FROM ships"), "no such table: ships");
  a.exec("DROP TABLE fleet; CREATE VIRTUAL TABLE fleet USING moving_objects(id, x, y)");
  EXPECT_EQ(b.rows("SELECT * FROM fleet"), "");
  b.exec("INSERT INTO fleet VALUES(1, 2, 3)");
  EXPECT_EQ(a.rows("SELECT * FROM fleet"), "1|2.0|3.0");
}

TEST(TableConnections, ReopeningTheFileChangesNothing) {
  TemporaryFile file;
  {
    Database db(file.path());
    db.exec(std::string(create_named) + ";" + fill_named);
    db.exec("UPDATE ships SET vx = -0.0 WHERE id = 5");
  }
  Database db(file.path());
  EXPECT_EQ(db.rows("SELECT count(*), sum(x), count(name) FROM ships"), "300|45150.0|300");
  EXPECT_EQ(db.rows("SELECT * FROM ships WHERE id = 5"), "5|5.0|-0.0|ship 5");
  EXPECT_EQ(db.rows("INSERT INTO ships(x) VALUES(1.5) RETURNING x"), "1.5");
  EXPECT_EQ(db.rows("SELECT max(id) FROM ships"), "301");
}

}  // namespace
}  // namespace foresee::testing
