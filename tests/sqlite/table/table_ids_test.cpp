// Ranges and order of ids in a moving_objects table: the rows of an ordinary table, without reading the others.
#include <limits>
#include <random>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct TableIds : ::testing::Test {
  TableIds() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, +name TEXT);"
        "CREATE TEMP TABLE model(id INTEGER PRIMARY KEY, x REAL, name TEXT)");
  }

  void insert(const std::string& ids) {
    db.exec("INSERT INTO ships SELECT id, id * 0.5, 1, 'ship ' || id FROM (" + ids + ")");
  }
  void insert_numbers(int first, int last) {
    insert("WITH RECURSIVE n(id) AS (SELECT " + std::to_string(first) +
           " UNION ALL SELECT id + 1 FROM n WHERE id < " + std::to_string(last) + ") SELECT id FROM n");
  }

  std::string plan(const std::string& sql) {
    const std::string rows = db.rows("EXPLAIN QUERY PLAN " + sql);
    return rows.substr(rows.rfind('|') + 1);
  }

  /// Copies all rows by a scan.
  void copy() { db.exec("DELETE FROM model; INSERT INTO model SELECT id, x, name FROM ships"); }
  /// Requires: copy() since the last change.
  void expect_as_the_copy(const std::string& condition) {
    for (const std::string order : {"id + 0", "id", "id DESC", "rowid, x DESC"}) {
      const auto rows_of = [&](const std::string& table) {
        return db.rows("SELECT id, x, name FROM " + table + " WHERE " + condition + " ORDER BY " + order);
      };
      EXPECT_EQ(rows_of("ships"), rows_of("model")) << condition << " by " << order;
    }
  }

  Database db;
};

TEST_F(TableIds, AreReadInOrder) {
  insert_numbers(1, 500);
  EXPECT_EQ(plan("SELECT id FROM ships ORDER BY id"), "SCAN ships VIRTUAL TABLE INDEX 19:");
  EXPECT_EQ(plan("SELECT rowid FROM ships ORDER BY id DESC"), "SCAN ships VIRTUAL TABLE INDEX 51:");
  EXPECT_EQ(plan("SELECT * FROM ships WHERE id > 7"), "SCAN ships VIRTUAL TABLE INDEX 7:");
  EXPECT_EQ(plan("SELECT id FROM ships WHERE rowid BETWEEN 3 AND 7 ORDER BY rowid"),
            "SCAN ships VIRTUAL TABLE INDEX 31:");
  EXPECT_EQ(db.rows("SELECT id FROM ships ORDER BY id LIMIT 3 OFFSET 200"), "201\n202\n203");
  EXPECT_EQ(db.rows("SELECT id, name FROM ships WHERE id < 9 ORDER BY id DESC LIMIT 2"),
            "8|ship 8\n7|ship 7");
  EXPECT_EQ(db.rows("SELECT max(id) FROM ships"), "500");
  EXPECT_EQ(db.rows("SELECT count(*), sum(x) FROM ships WHERE id BETWEEN 30 AND 32"), "3|46.5");
  EXPECT_EQ(
      db.rows("SELECT a.id, b.id FROM ships a JOIN ships b ON b.id BETWEEN a.id AND a.id + 1 WHERE a.id = 9"),
      "9|9\n9|10");
  db.exec("UPDATE ships SET vx = 5 WHERE id BETWEEN 11 AND 19; DELETE FROM ships WHERE id > 498");
  EXPECT_EQ(db.rows("SELECT count(*), sum(vx) FROM ships"), "498|534.0");
}

/// A look-up of each row in order costs more than a scan and a sort, unless few rows are wanted.
TEST_F(TableIds, AreSortedWhereManyRowsAreRead) {
  insert_numbers(1, 500);
  const std::string sorted = "USE TEMP B-TREE FOR ORDER BY", scanned = "SCAN ships VIRTUAL TABLE INDEX ";
  EXPECT_EQ(plan("SELECT x FROM ships ORDER BY id"), sorted);
  EXPECT_EQ(plan("SELECT id FROM ships WHERE x < 9 ORDER BY id"), sorted);
  EXPECT_EQ(plan("SELECT id FROM ships WHERE x < 9 ORDER BY id LIMIT 5"), sorted);
  EXPECT_EQ(plan("SELECT id FROM ships WHERE x + 1 < 9 ORDER BY id LIMIT 5"), sorted);
  EXPECT_EQ(plan("SELECT x FROM ships WHERE name > 'b' ORDER BY id DESC LIMIT 5"), sorted);
  EXPECT_EQ(db.rows("SELECT id FROM ships WHERE x < 9 ORDER BY id DESC LIMIT 2"), "17\n16");
  if (sqlite3_libversion_number() < 3038000) return;  // which does not tell of LIMIT
  EXPECT_EQ(plan("SELECT * FROM ships ORDER BY id LIMIT 5"), scanned + "19:");
  EXPECT_EQ(plan("SELECT * FROM ships WHERE id > ?1 ORDER BY id LIMIT ?2 OFFSET 3"), scanned + "23:");
}

TEST_F(TableIds, AnEmptyTableHasNone) {
  EXPECT_EQ(db.rows("SELECT * FROM ships ORDER BY id"), "");
  EXPECT_EQ(db.rows("SELECT * FROM ships WHERE id > 3"), "");
  EXPECT_EQ(db.rows("SELECT max(id), min(id) FROM ships"), "NULL|NULL");
}

TEST_F(TableIds, BoundsMayBeOfAnyType) {
  insert(
      "SELECT column1 AS id FROM (VALUES (-9223372036854775807 - 1), (-9223372036854775807), (-64), (-1), "
      "(0), (5), "
      "(9007199254740993), (9223372036854775806), (9223372036854775807))");
  const char* bounds[] = {"5",
                          "-1",
                          "4.5",
                          "5.5",
                          "-0.5",
                          "'5'",
                          "'4.5'",
                          "'abc'",
                          "x'35'",
                          "NULL",
                          "1e300",
                          "-1e300",
                          "9e999",
                          "-9e999",
                          "9.3e18",
                          "-9.3e18",
                          "''",
                          "true",
                          "9007199254740992.0",
                          "9223372036854775807",
                          "-9223372036854775808",
                          "9223372036854775807.0",
                          "-9223372036854775808.0"};
  copy();
  for (const std::string bound : bounds) {
    for (const std::string op : {"id > ", "id >= ", "id < ", "id <= "}) expect_as_the_copy(op + bound);
    expect_as_the_copy("id > -70 AND id < " + bound);
    expect_as_the_copy("id >= " + bound + " AND id > 0 AND id < 9007199254740994");
  }
  expect_as_the_copy("id > 5 AND id < 5");
}

/// Some ids are stored and others not: they come once, in order, with what the transaction has written.
TEST_F(TableIds, OfATransactionAreInOrderToo) {
  insert_numbers(1, 900);
  std::mt19937_64 random(3);
  for (int round = 0; round < 12; ++round) {
    db.exec("BEGIN");
    for (int change = 0; change < 40; ++change) {
      const std::string id = std::to_string(random() % 1500), other = std::to_string(random() % 1500);
      if (change % 4 == 0) db.exec("DELETE FROM ships WHERE id = " + id);
      if (change % 4 == 1) db.exec("UPDATE OR REPLACE ships SET id = " + other + ", x = 3 WHERE id = " + id);
      if (change % 4 == 2) db.exec("INSERT OR REPLACE INTO ships VALUES(" + id + ", 7, 7, 'new')");
      if (change % 4 == 3) db.exec("UPDATE ships SET x = x + 1 WHERE id = " + id);
      if (change % 10 != 9) continue;
      const std::string first = std::to_string(random() % 1500), last = std::to_string(random() % 1500);
      copy();
      expect_as_the_copy("id >= " + first);
      expect_as_the_copy("id < " + last);
      expect_as_the_copy("id BETWEEN " + first + " AND " + last);
    }
    if (round % 5 == 4) db.exec("INSERT INTO ships(ships) VALUES('rebuild')");
    db.exec(round % 3 == 2 ? "ROLLBACK" : "COMMIT");
    copy();
    expect_as_the_copy("id > 0");
  }
  db.exec("BEGIN; DELETE FROM ships");
  insert_numbers(40, 60);
  copy();
  expect_as_the_copy("id > 50");
  db.exec("COMMIT");
}

/// Steps `select` (first column: an id), and runs `write` with that id after each row. Returns the ids.
struct TableIdWrites : TableIds {
  TableIdWrites() { insert_numbers(1, 300); }

  template <class Write>
  std::string loop(const std::string& select, Write write) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db.handle(), select.c_str(), -1, &statement, nullptr), SQLITE_OK);
    std::string ids;
    int rc = SQLITE_DONE;
    for (int rows = 0; rows < 1000 && (rc = sqlite3_step(statement)) == SQLITE_ROW; ++rows) {
      const std::string id = std::to_string(sqlite3_column_int64(statement, 0));
      ids += (ids.empty() ? "" : " ") + id;
      db.exec(write(id));
    }
    EXPECT_EQ(rc, SQLITE_DONE) << sqlite3_errmsg(db.handle());
    sqlite3_finalize(statement);
    return ids;
  }
};

TEST_F(TableIdWrites, ALoopMayWriteTheTableThatItReadsInOrder) {
  EXPECT_EQ(loop("SELECT id FROM ships WHERE id > 290 ORDER BY id",
                 [](const std::string& id) {
                   return "DELETE FROM ships WHERE id IN (" + id + ", " + id + " + 1)";
                 }),
            "291 293 295 297 299");
  EXPECT_EQ(loop("SELECT id FROM ships WHERE id < 6 ORDER BY id DESC",
                 [](const std::string& id) {
                   return "UPDATE ships SET id = id - 100 WHERE id = " + id +
                          "; INSERT INTO ships(id, x) VALUES(-" + id + ", 1)";
                 }),
            "5 4 3 2 1");
  EXPECT_EQ(db.rows("SELECT count(*), min(id), max(id) FROM ships"), "295|-99|290");
}

TEST_F(TableIdWrites, NewObjectsAreNotVisitedInOrder) {
  EXPECT_EQ(loop("SELECT id FROM ships WHERE id >= 299 ORDER BY id",
                 [](const std::string&) { return std::string("INSERT INTO ships(x) VALUES(1)"); }),
            "299 300");
}

TEST_F(TableIdWrites, ARollbackEndsAWalkInOrder) {
  db.exec("BEGIN; UPDATE ships SET x = 0; INSERT INTO ships(id, x) VALUES(400, 1)");
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(db.handle(), "SELECT id FROM ships ORDER BY id DESC", -1, &statement, nullptr);
  EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
  EXPECT_EQ(sqlite3_column_int64(statement, 0), 400);
  db.exec("ROLLBACK");
  EXPECT_EQ(sqlite3_step(statement) & 0xff, SQLITE_ABORT);
  sqlite3_finalize(statement);
  EXPECT_EQ(db.rows("SELECT max(id) FROM ships"), "300");
}

/// Only the rows that are needed are read: damage elsewhere does not matter.
TEST_F(TableIdWrites, AFewAreReadWithoutTheRest) {
  insert_numbers(1000, 9000);
  const std::string some = "SELECT id, x FROM ships WHERE id BETWEEN 100 AND 102",
                    first = some + " ORDER BY id LIMIT 2";
  EXPECT_EQ(db.rows(some), "100|50.0\n101|50.5\n102|51.0");
  db.exec("UPDATE ships_map SET leaf = x'00' WHERE id > 128");
  EXPECT_EQ(db.rows(first), "100|50.0\n101|50.5");
  EXPECT_EQ(db.code_of("SELECT sum(x) FROM ships WHERE id BETWEEN 60 AND 300") & 0xff, SQLITE_CORRUPT);
  EXPECT_EQ(db.code_of("SELECT id FROM ships ORDER BY id") & 0xff, SQLITE_CORRUPT) << "during a walk";
  EXPECT_EQ(db.code_of("SELECT id FROM ships ORDER BY id DESC LIMIT 1") & 0xff, SQLITE_CORRUPT);
}

TEST_F(TableIdWrites, AnIdInTwoRowsIsDamage) {
  db.exec("UPDATE ships_map SET id = id + 1 WHERE id = 128");
  EXPECT_EQ(db.code_of("SELECT id FROM ships ORDER BY id") & 0xff, SQLITE_CORRUPT);
  db.exec("DELETE FROM ships_map WHERE id = 129; INSERT INTO ships_map VALUES(65, 1)");
  EXPECT_EQ(db.code_of("SELECT id FROM ships ORDER BY id") & 0xff, SQLITE_CORRUPT);
  EXPECT_EQ(db.code_of("SELECT id FROM ships ORDER BY id DESC") & 0xff, SQLITE_CORRUPT);
}

}  // namespace
}  // namespace foresee::testing
