// Reads of a moving_objects table: look-ups, scans, writes during a scan, and the handle for functions.
#include <functional>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct TableScan : ::testing::Test {
  TableScan() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, +name TEXT);"
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 500)"
        "INSERT INTO ships SELECT i, i * 0.5, 1, 'ship ' || i FROM n");
  }

  std::string plan(const std::string& sql) {
    const std::string rows = db.rows("EXPLAIN QUERY PLAN " + sql);
    return rows.substr(rows.rfind('|') + 1);
  }

  Database db;
};

TEST_F(TableScan, VisitsEveryObjectOnce) {
  EXPECT_EQ(db.rows("SELECT count(*), count(DISTINCT id), min(id), max(id), sum(x) FROM ships"),
            "500|500|1|500|62625.0");
  EXPECT_EQ(plan("SELECT * FROM ships"), "SCAN ships VIRTUAL TABLE INDEX 0:");
}

/// A table that is bounded by another one is read after it: the bounds do not apply without the other.
TEST_F(TableScan, IsInnerWhereItsBoundsNeedAnotherTable) {
  const std::string sql =
      "SELECT count(*) FROM ships h JOIN ships v ON v.x BETWEEN h.x - 10 AND h.x + 10 AND v.vx BETWEEN h.vx "
      "- 1 AND "
      "h.vx + 1 WHERE h.name = 'ship 17'";
  EXPECT_EQ(plan(sql), "SCAN v VIRTUAL TABLE INDEX 0:");
  EXPECT_EQ(db.rows(sql), "37");
  EXPECT_EQ(
      plan("SELECT count(*) FROM ships v JOIN ships h ON v.name = h.name AND v.vx = h.vx WHERE h.id = 3"),
      "SCAN v VIRTUAL TABLE INDEX 0:");
  EXPECT_EQ(
      db.rows("SELECT count(*) FROM ships v WHERE v.x > 5 AND v.name IN ('ship 12', 'ship 9', 'ship 2')"),
      "1");
}

TEST_F(TableScan, AnEmptyTableHasNoRows) {
  db.exec("CREATE VIRTUAL TABLE none USING moving_objects(id, x)");
  EXPECT_EQ(db.rows("SELECT * FROM none"), "");
  EXPECT_EQ(db.rows("SELECT * FROM none WHERE id = 1"), "");
}

TEST_F(TableScan, FindsByIdAndRowid) {
  for (const char* id : {"id", "rowid", "_rowid_"}) {
    const std::string sql = std::string("SELECT id, x, name FROM ships WHERE ") + id + " = ";
    EXPECT_EQ(db.rows(sql + "77"), "77|38.5|ship 77");
    EXPECT_EQ(db.rows(sql + "'77'"), "77|38.5|ship 77");
    EXPECT_EQ(db.rows(sql + "77.0"), "77|38.5|ship 77");
    for (const char* none : {"501", "77.5", "NULL", "'abc'", "x'37'", "1e300", "-1e300"})
      EXPECT_EQ(db.rows(sql + none), "") << id << " = " << none;
    EXPECT_EQ(plan(sql + "77"), "SCAN ships VIRTUAL TABLE INDEX 1:");
  }
}

TEST_F(TableScan, FindsManyIds) {
  EXPECT_EQ(db.rows("SELECT id FROM ships WHERE id IN (3, 900, 1, 2, 3) ORDER BY id"), "1\n2\n3");
  EXPECT_EQ(db.rows("SELECT id FROM ships WHERE id = 7 AND id = 8"), "");
  EXPECT_EQ(db.rows("SELECT id FROM ships WHERE id > 498 ORDER BY id DESC"), "500\n499");
  EXPECT_EQ(db.rows("SELECT a.id, b.id FROM ships a JOIN ships b ON b.id = a.id + 1 WHERE a.id = 9"), "9|10");
}

TEST_F(TableScan, FiltersByOtherColumns) {
  EXPECT_EQ(db.rows("SELECT id FROM ships WHERE name = 'ship 12'"), "12");
  EXPECT_EQ(db.rows("SELECT id FROM ships WHERE x = '6'"), "12") << "x has a number's affinity";
}

TEST_F(TableScan, TheCommandColumnIsHidden) {
  EXPECT_EQ(db.rows("SELECT * FROM ships WHERE id = 1"), "1|0.5|1.0|ship 1");
  EXPECT_EQ(db.rows("SELECT ships FROM ships WHERE id = 1"), "NULL");
  EXPECT_EQ(db.rows("SELECT name, type, pk FROM pragma_table_info('ships')"),
            "id|INTEGER|1\nx|REAL|0\nvx|REAL|0\nname|TEXT|0");
}

TEST_F(TableScan, FunctionsGetTheTablesNumber) {
  EXPECT_EQ(db.rows("SELECT typeof(ships), ships > 0 FROM main.ships WHERE ships MATCH 'foresee-handle'"),
            "integer|1");
  EXPECT_EQ(db.rows("SELECT ships FROM ships WHERE ships MATCH 'storm'"),
            "error: ships MATCH: a table of moving objects has no text to search; query predictive_join or "
            "another of foresee's functions");
}

// --- writes during a scan ----------------------------------------------------------------------------------

/// Steps `select` (first column: an id), runs `write` with that id for each row, and returns the number of
/// rows.
struct TableScanWrites : TableScan {
  int loop(const std::string& select, const std::function<std::string(std::int64_t)>& write) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db.handle(), select.c_str(), -1, &statement, nullptr), SQLITE_OK);
    int rows = 0;
    int rc;
    while ((rc = sqlite3_step(statement)) == SQLITE_ROW && rows < 10000) {
      ++rows;
      EXPECT_EQ(sqlite3_column_double(statement, 1),
                0.5 * static_cast<double>(sqlite3_column_int64(statement, 0)));
      db.exec(write(sqlite3_column_int64(statement, 0)));
    }
    EXPECT_EQ(rc, SQLITE_DONE) << sqlite3_errmsg(db.handle());
    sqlite3_finalize(statement);
    return rows;
  }
};

TEST_F(TableScanWrites, ALoopMayUpdateTheTableThatItReads) {
  EXPECT_EQ(
      loop("SELECT id, x FROM ships",
           [](auto id) { return "UPDATE ships SET vx = 2, name = 'new' WHERE id = " + std::to_string(id); }),
      500);
  EXPECT_EQ(db.rows("SELECT count(*), sum(vx), min(name), sum(x) FROM ships"), "500|1000.0|new|62625.0");
}

TEST_F(TableScanWrites, InsideATransactionToo) {
  db.exec("BEGIN");
  EXPECT_EQ(loop("SELECT id, x FROM ships",
                 [](auto id) { return "UPDATE ships SET vx = 2 WHERE id = " + std::to_string(id); }),
            500);
  db.exec("COMMIT");
  EXPECT_EQ(db.rows("SELECT sum(vx) FROM ships"), "1000.0");
}

TEST_F(TableScanWrites, DeletedObjectsArePassedOver) {
  EXPECT_EQ(loop("SELECT id, x FROM ships",
                 [](auto id) {
                   return "DELETE FROM ships WHERE id IN (" + std::to_string(id) + ", 501 - " +
                          std::to_string(id) + ")";
                 }),
            250);
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
}

TEST_F(TableScanWrites, NewObjectsAreNotVisited) {
  EXPECT_EQ(
      loop("SELECT id, x FROM ships", [](auto) { return std::string("INSERT INTO ships(x) VALUES(1)"); }),
      500);
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "1000");
}

TEST_F(TableScanWrites, ObjectsThatChangeTheirIdAreNotVisitedTwice) {
  EXPECT_EQ(loop("SELECT id, x FROM ships",
                 [](auto id) { return "UPDATE ships SET id = id + 1000 WHERE id = " + std::to_string(id); }),
            500);
  EXPECT_EQ(db.rows("SELECT min(id), max(id), count(*) FROM ships"), "1001|1500|500");
}

TEST_F(TableScanWrites, AReconnectedTableKnowsTheScansOfItsPredecessor) {
  db.exec("CREATE TABLE notes(text)");
  EXPECT_EQ(loop("SELECT id, x FROM ships",
                 [](auto id) {
                   const std::string self = std::to_string(id);
                   return "ALTER TABLE notes ADD COLUMN c" + self + "; DELETE FROM ships WHERE id IN (" +
                          self + ", 501 - " + self + ")";
                 }),
            250);
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
}

TEST_F(TableScanWrites, RefusedWritesLeaveTheScanAlone) {
  EXPECT_EQ(loop("SELECT id, x FROM ships",
                 [&](auto) {
                   EXPECT_NE(db.error_of("INSERT INTO ships(id, x) VALUES(3, 3)"), "");
                   return std::string();
                 }),
            500);
}

/// A write reads the rest of an open scan, or of a walk in the order of ids, before it changes anything.
TEST_F(TableScanWrites, AWriteThatFailsToReadTheRestLeavesTheScanAlone) {
  const struct {
    const char *query, *shadow, *damage;
  } cases[] = {
      {"SELECT id FROM ships", "ships_node",
       "UPDATE ships_node SET data = x'00' WHERE nodeno = (SELECT max(nodeno) FROM whole)"},
      {"SELECT id FROM ships ORDER BY id", "ships_map", "UPDATE ships_map SET leaf = x'00' WHERE id = 256"}};
  for (const auto& [query, shadow, damage] : cases) {
    db.exec(std::string("CREATE TABLE whole AS SELECT * FROM ") + shadow + "; BEGIN");
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(db.handle(), query, -1, &statement, nullptr);
    EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
    db.exec(damage);
    EXPECT_EQ(db.code_of("INSERT INTO ships(x) VALUES(1)") & 0xff, SQLITE_CORRUPT) << query;
    db.exec(std::string("REPLACE INTO ") + shadow + " SELECT * FROM whole");
    int rows = 1, rc;
    while ((rc = sqlite3_step(statement)) == SQLITE_ROW) ++rows;
    EXPECT_EQ(rc, SQLITE_DONE) << query << ": " << sqlite3_errmsg(db.handle());
    EXPECT_EQ(rows, 500) << query;
    sqlite3_finalize(statement);
    db.exec("ROLLBACK; DROP TABLE whole");
  }
}

TEST_F(TableScanWrites, ARollbackDuringAScanEndsIt) {
  db.exec("BEGIN; UPDATE ships SET x = x + 1");
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(db.handle(), "SELECT id FROM ships", -1, &statement, nullptr);
  EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
  db.exec("ROLLBACK");
  EXPECT_EQ(sqlite3_step(statement) & 0xff, SQLITE_ABORT);
  sqlite3_finalize(statement);
  EXPECT_EQ(db.rows("SELECT sum(x) FROM ships"), "62625.0");
}

/// A statement that fails on another table, or a savepoint in which this table has not changed, ends no scan of it.
TEST_F(TableScanWrites, ARollbackThatChangesNothingHereLeavesTheScanAlone) {
  db.exec(
      "CREATE TABLE seen(id INTEGER PRIMARY KEY); INSERT INTO seen VALUES(1);"
      "CREATE VIRTUAL TABLE boats USING moving_objects(id, x)");
  for (const char* query : {"SELECT id, x FROM ships", "SELECT id FROM ships ORDER BY id"})
    for (const char* sql : {"INSERT INTO seen VALUES(7), (1)", "INSERT INTO boats VALUES(1, 1), (2, 'x')",
                            "SAVEPOINT s; ROLLBACK TO s; RELEASE s",
                            "SAVEPOINT s; INSERT INTO boats VALUES(1, 1); ROLLBACK TO s; RELEASE s"}) {
      db.exec("BEGIN; UPDATE ships SET x = x + 1 WHERE id = 3");
      sqlite3_stmt* statement = nullptr;
      sqlite3_prepare_v2(db.handle(), query, -1, &statement, nullptr);
      EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
      db.error_of(sql);
      int rows = 1;
      while (sqlite3_step(statement) == SQLITE_ROW) ++rows;
      EXPECT_EQ(sqlite3_finalize(statement), SQLITE_OK) << sql;
      EXPECT_EQ(rows, 500) << query << ": " << sql;
      db.exec("ROLLBACK");
    }
}

/// SQLite rolls a RENAME back without a callback, and the old name is the right one again.
TEST_F(TableScanWrites, ARolledBackRenameEndsTheScan) {
  for (const char* rollback : {"ROLLBACK TO s", "ROLLBACK"}) {
    db.exec("BEGIN; SAVEPOINT s");
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(db.handle(), "SELECT id, x FROM ships", -1, &statement, nullptr);
    EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
    db.exec("ALTER TABLE ships RENAME TO boats");
    db.exec(rollback);
    int rc;
    while ((rc = sqlite3_step(statement)) == SQLITE_ROW) {
    }
    EXPECT_EQ(rc & 0xff, SQLITE_ABORT) << rollback;
    sqlite3_finalize(statement);
    db.error_of("ROLLBACK");
    EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "500");
  }
}

TEST_F(TableScanWrites, StatementsThatReadAndWriteTheTable) {
  db.exec("UPDATE ships SET x = x + 1");
  EXPECT_EQ(db.rows("SELECT count(*), sum(x) FROM ships"), "500|63125.0");
  db.exec("DELETE FROM ships WHERE id IN (SELECT id FROM ships WHERE id % 2)");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "250");
  db.exec("UPDATE ships SET x = (SELECT max(s.x) FROM ships s) WHERE id < 10");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships WHERE x = 251"), "5");
  db.exec("DELETE FROM ships");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
}

}  // namespace
}  // namespace foresee::testing
