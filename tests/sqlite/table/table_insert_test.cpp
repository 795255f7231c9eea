// INSERT into moving_objects: ids, conflict clauses, RETURNING.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct TableInsert : ::testing::Test {
  TableInsert() {
    db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name TEXT)");
  }

  Database db;
};

TEST_F(TableInsert, RowsComeBackAsTheyWere) {
  db.exec(
      "INSERT INTO ships VALUES(7, 0.1, 1.5, -0.0, 1e-310, -3, 4, 'Argo'), (-2, 0, 1e300, 2, 3, 4, 5, NULL)");
  EXPECT_EQ(db.rows("SELECT * FROM ships ORDER BY id"),
            "-2|0.0|1e+300|2.0|3.0|4.0|5.0|NULL\n7|0.1|1.5|-0.0|1e-310|-3.0|4.0|Argo");
}

TEST_F(TableInsert, IdsAreAssignedFromTheLargestOn) {
  db.exec("INSERT INTO ships(t, x, y) VALUES(0, 1, 1)");
  db.exec("INSERT INTO ships(id, t, x, y) VALUES(40, 0, 2, 2), (NULL, 0, 3, 3), ('', 0, 4, 4)");
  EXPECT_EQ(db.rows("SELECT id, x FROM ships ORDER BY id"), "1|1.0\n40|2.0\n41|3.0\n42|4.0");
  EXPECT_EQ(sqlite3_last_insert_rowid(db.handle()), 42);
}

TEST_F(TableInsert, RowidIsAnotherNameOfTheId) {
  db.exec("INSERT INTO ships(rowid, t, x, y) VALUES(9, 0, 1, 1)");
  EXPECT_EQ(db.rows("SELECT id, rowid, _rowid_, oid FROM ships"), "9|9|9|9");
}

TEST_F(TableInsert, IdsMayComeAsTextOrWholeReals) {
  db.exec(
      "INSERT INTO ships(id, t, x, y) VALUES('12', 0, 1, 1), (13.0, 0, 1, 1), (' 14 ', 0, 1, 1), ('15.0', 0, "
      "1, 1)");
  EXPECT_EQ(db.rows("SELECT id FROM ships ORDER BY id"), "12\n13\n14\n15");
}

TEST_F(TableInsert, OtherIdsAreRefused) {
  const std::string rule = ": not an integer; write an INTEGER, or NULL to have one assigned";
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, x, y) VALUES('abc', 0, 1, 1)"), "ships.id is 'abc'" + rule);
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, x, y) VALUES(1.5, 0, 1, 1)"), "ships.id is 1.5" + rule);
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, x, y) VALUES(1e30, 0, 1, 1)"), "ships.id is 1e+30" + rule);
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, x, y) VALUES(x'00', 0, 1, 1)"),
            "ships.id is a blob of 1 bytes" + rule);
  EXPECT_EQ(db.code_of("INSERT INTO ships(id, t, x, y) VALUES('abc', 0, 1, 1)"), SQLITE_MISMATCH);
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
}

TEST_F(TableInsert, TheWholeRangeOfIdsWorks) {
  db.exec("INSERT INTO ships(id, t, x, y) VALUES(-9223372036854775808, 0, 1, 1), (0, 0, 1, 1)");
  db.exec("INSERT INTO ships(id, t, x, y) VALUES(9223372036854775807, 0, 2, 2)");
  EXPECT_EQ(db.rows("SELECT id FROM ships ORDER BY id"), "-9223372036854775808\n0\n9223372036854775807");
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 9223372036854775807"), "2.0");
}

TEST_F(TableInsert, AfterTheLargestIdAFreeOneIsFound) {
  db.exec("INSERT INTO ships(id, t, x, y) VALUES(9223372036854775807, 0, 2, 2)");
  db.exec("INSERT INTO ships(t, x, y) VALUES(0, 3, 3)");
  EXPECT_EQ(db.rows("SELECT count(*), count(DISTINCT id), min(id) > 0 FROM ships"), "2|2|1");
}

TEST_F(TableInsert, ReturningEchoesTheRow) {
  EXPECT_EQ(
      db.rows("INSERT INTO ships(id, t, x, y, name) VALUES(3, 0, 1, 2.5, 'Argo') RETURNING id, y, name"),
      "3|2.5|Argo");
}

// The statements that SQLite refuses on every virtual table, as in docs/reference/moving_objects.md.
TEST_F(TableInsert, SQLiteRefusesReturningOfOthersAndUpserts) {
  db.exec("INSERT INTO ships(id, t, x, y) VALUES(3, 0, 1, 2.5)");
  EXPECT_EQ(db.error_of("UPDATE ships SET x = 2 RETURNING x"),
            "UPDATE RETURNING is not available on virtual tables");
  EXPECT_EQ(db.error_of("DELETE FROM ships RETURNING x"),
            "DELETE RETURNING is not available on virtual tables");
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, t, x, y) VALUES(3, 0, 1, 2) ON CONFLICT DO NOTHING"),
            "UPSERT not implemented for virtual table \"ships\"");
  EXPECT_EQ(db.rows("SELECT id, x FROM ships"), "3|1.0");
}

TEST_F(TableInsert, FromASelectOfTheSameTable) {
  db.exec("INSERT INTO ships(id, t, x, y, name) VALUES(1, 0, 1, 2, 'a'), (2, 0, 3, 4, 'b')");
  db.exec("INSERT INTO ships(t, x, y, name) SELECT t, x + 10, y, name || '2' FROM ships");
  EXPECT_EQ(db.rows("SELECT id, x, name FROM ships ORDER BY id"), "1|1.0|a\n2|3.0|b\n3|11.0|a2\n4|13.0|b2");
}

TEST_F(TableInsert, AuxiliaryColumnsHoldAnyType) {
  db.exec("CREATE VIRTUAL TABLE things USING moving_objects(id, x, +a, +b INTEGER, +c TEXT)");
  db.exec("INSERT INTO things VALUES(1, 0, x'00ff', 'text', 5), (2, 0, 1.5, NULL, ''), (3, 0, -1, 7, x'')");
  EXPECT_EQ(db.rows("SELECT a, b, c, typeof(c) FROM things ORDER BY id"),
            "x'00ff'|text|5|integer\n1.5|NULL||text\n-1|7|x''|blob");
}

// --- conflict clauses --------------------------------------------------------------------------------------

struct TableConflict : TableInsert {
  TableConflict() { db.exec("INSERT INTO ships(id, t, x, y, name) VALUES(1, 0, 1, 1, 'first')"); }

  std::string contents() { return db.rows("SELECT id, x, name FROM ships ORDER BY id"); }
  /// Two good rows around one whose id is taken.
  std::string insert(const std::string& clause) {
    return db.error_of(
        "INSERT " + clause +
        " INTO ships(id, t, x, y, name) VALUES(2, 0, 2, 2, 'b'), (1, 0, 9, 9, 'new'), (3, 0, 3, 3, 'c')");
  }
  const std::string message = "UNIQUE constraint failed: ships.id";
};

TEST_F(TableConflict, AbortRollsTheStatementBack) {
  db.exec("BEGIN; INSERT INTO ships(id, t, x, y) VALUES(10, 0, 1, 1)");
  EXPECT_EQ(insert(""), message);
  EXPECT_EQ(insert("OR ABORT"), message);
  db.exec("COMMIT");
  EXPECT_EQ(contents(), "1|1.0|first\n10|1.0|NULL");
}

TEST_F(TableConflict, FailKeepsTheRowsBefore) {
  EXPECT_EQ(insert("OR FAIL"), message);
  EXPECT_EQ(contents(), "1|1.0|first\n2|2.0|b");
}

TEST_F(TableConflict, IgnorePassesOverTheRow) {
  EXPECT_EQ(insert("OR IGNORE"), "");
  EXPECT_EQ(contents(), "1|1.0|first\n2|2.0|b\n3|3.0|c");
}

TEST_F(TableConflict, ReplaceTakesTheNewRowWhole) {
  db.exec("UPDATE ships SET vx = 5 WHERE id = 1");
  EXPECT_EQ(insert("OR REPLACE"), "");
  EXPECT_EQ(contents(), "1|9.0|new\n2|2.0|b\n3|3.0|c");
  db.exec("REPLACE INTO ships(id, t, x, y) VALUES(1, 0, 8, 8)");
  EXPECT_EQ(db.rows("SELECT x, vx, name FROM ships WHERE id = 1"), "8.0|0.0|NULL");
}

TEST_F(TableConflict, RollbackRollsTheTransactionBack) {
  db.exec("BEGIN; INSERT INTO ships(id, t, x, y) VALUES(10, 0, 1, 1)");
  EXPECT_EQ(insert("OR ROLLBACK"), message);
  EXPECT_NE(sqlite3_get_autocommit(db.handle()), 0);
  EXPECT_EQ(contents(), "1|1.0|first");
}

TEST_F(TableConflict, AWrongValueIsNeverReplaceable) {
  EXPECT_EQ(db.code_of("INSERT OR REPLACE INTO ships(id, t, x, y, r) VALUES(1, 0, 9, 9, -1)") & 0xff,
            SQLITE_CONSTRAINT);
  EXPECT_EQ(contents(), "1|1.0|first");
}

TEST_F(TableConflict, IgnorePassesOverAWrongValue) {
  db.exec("INSERT OR IGNORE INTO ships(id, t, x, y, r) VALUES(5, 0, 9, 9, -1), (6, 0, 9, 9, 1)");
  EXPECT_EQ(contents(), "1|1.0|first\n6|9.0|NULL");
}

TEST_F(TableConflict, AConflictNamesTheCode) {
  EXPECT_EQ(db.code_of("INSERT INTO ships(id, t, x, y) VALUES(1, 0, 1, 1)") & 0xff, SQLITE_CONSTRAINT);
}

TEST_F(TableConflict, UpdateOfAnIdFollowsTheClause) {
  db.exec("INSERT INTO ships(id, t, x, y, name) VALUES(2, 0, 2, 2, 'b')");
  EXPECT_EQ(db.error_of("UPDATE ships SET id = 1 WHERE id = 2"), message);
  db.exec("UPDATE OR IGNORE ships SET id = 1 WHERE id = 2");
  EXPECT_EQ(contents(), "1|1.0|first\n2|2.0|b");
  db.exec("UPDATE OR REPLACE ships SET id = 1 WHERE id = 2");
  EXPECT_EQ(contents(), "1|2.0|b");
}

}  // namespace
}  // namespace foresee::testing
