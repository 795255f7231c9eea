// Watches in SQL: rows, changes, clock, transactions, names, errors.
#include "sqlite/database.h"

namespace foresee {
namespace {

using testing::Database;
using testing::TemporaryFile;

constexpr const char* joined = "SELECT * FROM predictive_join(100, 'ships') WHERE now = ";

/// Two ships in contact from 50 to 70, and one far away.
struct Watch : ::testing::Test {
  Watch() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
        "INSERT INTO ships VALUES (1, 0, 0, 0, 1, 0, 10), (2, 0, 120, 0, -1, 0, 10), (3, 0, 0, 9000, 0, 0, "
        "10);"
        "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);");
  }

  std::string changes(int since) {
    return db.rows("SELECT seq, op, a, b, t, now FROM predictive_changes('alerts', " + std::to_string(since) +
                   ")");
  }
  std::string alerts(const std::string& columns = "a, b, t") {
    return db.rows("SELECT " + columns + " FROM alerts ORDER BY a, b");
  }

  Database db;
};

TEST_F(Watch, ItsRowsAreThoseOfTheJoin) {
  EXPECT_EQ(alerts(), "1|2|50.0");
  EXPECT_EQ(alerts("*"), db.rows(std::string(joined) + "0"));
  EXPECT_EQ(db.rows("SELECT now FROM alerts"), "0.0");
}

TEST_F(Watch, ItsFirstReadersGetTheWholeWatch) {
  EXPECT_EQ(changes(0), "1|+|1|2|50.0|0.0");
  EXPECT_EQ(changes(1), "");
}

TEST_F(Watch, ACommitLogsTheDifference) {
  db.exec("UPDATE ships SET y = 0, x = 40 WHERE id = 3");
  EXPECT_EQ(changes(1), "2|+|1|3|20.0|0.0\n3|+|2|3|60.0|0.0");
  db.exec("UPDATE ships SET x = 41 WHERE id = 3");
  EXPECT_EQ(changes(3), "4|~|1|3|21.0|0.0\n5|~|2|3|59.0|0.0");
  db.exec("DELETE FROM ships WHERE id = 1");
  EXPECT_EQ(changes(5), "6|-|1|2|NULL|0.0\n7|-|1|3|NULL|0.0");
}

TEST_F(Watch, TheClockBringsAndTakesPairs) {
  db.exec("UPDATE ships SET x = 1000, y = 0, vx = -3 WHERE id = 3");
  EXPECT_EQ(changes(1), "");
  db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', 200.0)");
  EXPECT_EQ(changes(1), "2|-|1|2|NULL|200.0\n3|+|1|3|245.0|200.0");
  db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', 246.0)");
  EXPECT_EQ(alerts(), "1|3|246.0");
  EXPECT_EQ(changes(3), "");
  db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', 900.0)");
  EXPECT_EQ(changes(3), "4|-|1|3|NULL|900.0");
}

TEST_F(Watch, AnAdvanceMayGoBackAsFarAsTheNewestReport) {
  db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', 1e9)");
  EXPECT_EQ(alerts(), "");
  db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', 20)");
  EXPECT_EQ(alerts("*"), db.rows(std::string(joined) + "20"));
  db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', -20)");
  EXPECT_EQ(db.rows("SELECT now FROM predictive_watches"), "0.0");
}

TEST_F(Watch, AReportMovesTheClock) {
  db.exec("UPDATE ships SET t = 60 WHERE id = 3");
  EXPECT_EQ(db.rows("SELECT now, seq, pairs FROM predictive_watches"), "60.0|1|1");
  EXPECT_EQ(alerts(), "1|2|60.0");
}

TEST_F(Watch, AnOpenTransactionIsSeenInTheRowsAndNotLogged) {
  db.exec("BEGIN; UPDATE ships SET y = 0, x = 40 WHERE id = 3");
  EXPECT_EQ(alerts(), "1|2|50.0\n1|3|20.0\n2|3|60.0");
  EXPECT_EQ(changes(1), "");
  db.exec("ROLLBACK");
  EXPECT_EQ(alerts(), "1|2|50.0");
  EXPECT_EQ(changes(1), "");
  EXPECT_EQ(db.rows("SELECT seq FROM predictive_watches"), "1");
}

TEST_F(Watch, SavepointsRollBackChangesAndAdvances) {
  db.exec(
      "BEGIN; SAVEPOINT s; DELETE FROM ships WHERE id = 1;"
      "INSERT INTO alerts(alerts, now) VALUES('advance', 500.0)");
  EXPECT_EQ(alerts(), "");
  db.exec("ROLLBACK TO s");
  EXPECT_EQ(alerts(), "1|2|50.0");
  db.exec("COMMIT");
  EXPECT_EQ(changes(1), "");
  EXPECT_EQ(db.rows("SELECT now, fault FROM predictive_watches"), "0.0|NULL");
}

TEST_F(Watch, ARowDeletedAndRestoredInOneTransactionIsNoChange) {
  db.exec("BEGIN; DELETE FROM ships WHERE id = 1; INSERT INTO ships VALUES (1, 0, 0, 0, 1, 0, 10); COMMIT");
  EXPECT_EQ(changes(1), "");
}

TEST_F(Watch, AnIdMayChangeAndReplaceAnother) {
  db.exec("UPDATE OR REPLACE ships SET id = 3 WHERE id = 1");
  EXPECT_EQ(changes(1), "2|-|1|2|NULL|0.0\n3|+|2|3|50.0|0.0");
}

TEST_F(Watch, ItsOwnWritesAreNoRowsOfTheUser) {
  db.exec("INSERT INTO ships VALUES (77, 0, 40, 0, 0, 0, 10)");
  EXPECT_EQ(db.rows("SELECT last_insert_rowid()"), "77");
  for (const char* command : {"alerts(alerts, now) VALUES('advance', 1)", "alerts(alerts) VALUES('rebuild')",
                              "ships(ships) VALUES('optimize')"}) {
    db.exec(std::string("INSERT INTO ") + command);
    EXPECT_EQ(db.rows("SELECT last_insert_rowid()"), "77") << command;
  }
}

TEST_F(Watch, ItsPairsAndChangesAreOrdinaryRows) {
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts_pair WHERE state = 1"), "1|2|50.0");
  db.exec("DELETE FROM ships WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT seq, op, a, b, t, now FROM alerts_log"), "2|-|1|2|NULL|0.0");
}

TEST_F(Watch, ConstraintsOnIdsAreUsed) {
  db.exec("UPDATE ships SET y = 0, x = 40 WHERE id = 3");
  EXPECT_EQ(db.rows("SELECT a, b FROM alerts WHERE a = 2"), "2|3");
  EXPECT_EQ(db.rows("SELECT a, b FROM alerts WHERE b = 3 ORDER BY a"), "1|3\n2|3");
  EXPECT_EQ(db.rows("SELECT a, b FROM alerts WHERE a = 2 OR b = 2 ORDER BY a"), "1|2\n2|3");
  EXPECT_EQ(db.rows("SELECT a, b FROM alerts WHERE a = 1.5"), "");
  EXPECT_EQ(db.rows("SELECT a, b FROM alerts WHERE a IN (1, 2, 9) AND b IN (3, 4) ORDER BY a"), "1|3\n2|3");
  EXPECT_EQ(db.rows("SELECT a, b FROM alerts WHERE a IN (1, 2) AND b = 2"), "1|2");
  EXPECT_EQ(db.rows("SELECT a, b FROM alerts WHERE a = 1 AND b IN (2, 7)"), "1|2");
}

TEST_F(Watch, TheNumberOfStoredChangesIsLimited) {
  db.exec(
      "DROP TABLE alerts; CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, keep = 2);"
      "DELETE FROM ships WHERE id = 1; INSERT INTO ships VALUES (1, 0, 0, 0, 1, 0, 10);"
      "DELETE FROM ships WHERE id = 1");
  EXPECT_EQ(changes(2), "3|+|1|2|50.0|0.0\n4|-|1|2|NULL|0.0");
  EXPECT_EQ(
      changes(1),
      "error: predictive_changes: alerts: changes up to 2 are no longer kept; read the whole watch with "
      "since = 0");
  EXPECT_EQ(changes(9),
            "error: predictive_changes: since = 9 is beyond the last change of alerts, 4: was the file "
            "restored? Read again with since = 0");
}

TEST_F(Watch, TablesAndWatchesMayBeRenamed) {
  db.exec(
      "ALTER TABLE ships RENAME TO boats; ALTER TABLE alerts RENAME TO near; DELETE FROM boats WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT op, a, b FROM predictive_changes('near', 1)"), "-|1|2");
  EXPECT_EQ(db.rows("SELECT name, tbl, fault FROM predictive_watches"), "near|boats|NULL");
  db.exec("CREATE VIRTUAL TABLE alerts USING predictive_watch(boats, horizon = 5)");
  EXPECT_EQ(db.rows("SELECT name, fault FROM predictive_watches ORDER BY name"), "alerts|NULL\nnear|NULL");
}

TEST_F(Watch, TwoWatchesOfATableAreTwoLevels) {
  db.exec("CREATE VIRTUAL TABLE act USING predictive_watch(ships, horizon = 10)");
  db.exec(
      "INSERT INTO alerts(alerts, now) VALUES('advance', 45.0); INSERT INTO act(act, now) VALUES('advance', "
      "45.0)");
  EXPECT_EQ(db.rows("SELECT op, a, b, t FROM predictive_changes('act', 0)"), "+|1|2|50.0");
  db.exec("DROP TABLE alerts; DELETE FROM ships WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT count(*) FROM act"), "0");
}

TEST_F(Watch, AMissingWatchDoesNotPreventWrites) {
  db.exec("DROP TABLE alerts_pair; DELETE FROM ships WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "2");
  EXPECT_EQ(db.rows("SELECT name, fault IS NOT NULL FROM predictive_watches"), "alerts|1");
  EXPECT_EQ(db.rows("SELECT * FROM alerts").substr(0, 6), "error:");
  db.exec("DROP TABLE alerts");
  EXPECT_EQ(db.rows("SELECT name FROM sqlite_master WHERE name LIKE 'alerts%'"), "");
}

TEST_F(Watch, AWatchedTableCannotBeDropped) {
  EXPECT_EQ(db.error_of("DROP TABLE ships"), "database table is locked");  // SQLite's own message
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "3");
  db.exec("DROP TABLE alerts; DROP TABLE ships");
}

TEST_F(Watch, CreateAndDropOfAWatchAreRolledBack) {
  db.exec("BEGIN; CREATE VIRTUAL TABLE act USING predictive_watch(ships, horizon = 10); ROLLBACK");
  db.exec("BEGIN; DROP TABLE alerts; UPDATE ships SET x = 1 WHERE id = 1; ROLLBACK");
  db.exec("DELETE FROM ships WHERE id = 1");
  EXPECT_EQ(changes(1), "2|-|1|2|NULL|0.0");
  EXPECT_EQ(db.rows("SELECT name, fault FROM predictive_watches"), "alerts|NULL");
}

TEST_F(Watch, ReportsFarAheadDoNotMoveTheClock) {
  db.exec(
      "DROP TABLE alerts;"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, ahead = 60);"
      "UPDATE ships SET t = 1.7e12 WHERE id = 3; UPDATE ships SET t = 30 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT now, early FROM predictive_watches"), "30.0|1");
}

TEST_F(Watch, TheFirstReportsMayBeFarAheadOfOneAnother) {
  db.exec(
      "DROP TABLE alerts; DELETE FROM ships;"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, ahead = 60);"
      "BEGIN; INSERT INTO ships VALUES (1, 1.7e12, 0, 0, 0, 0, 1), (2, 10, 0, 0, 0, 0, 1), (3, 50, 1, 0, 0, "
      "0, 1),"
      "  (4, -5000, 0, 0, 0, 0, 1); COMMIT");
  EXPECT_EQ(db.rows("SELECT now, early FROM predictive_watches"), "50.0|1");
  db.exec("CREATE VIRTUAL TABLE act USING predictive_watch(ships, horizon = 100, ahead = 60)");
  EXPECT_EQ(db.rows("SELECT now, early FROM predictive_watches"), "50.0|1\n50.0|1");
}

TEST(WatchFile, SurvivesClosingAndASecondWriter) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx);"
        "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, within = 1);"
        "INSERT INTO ships VALUES (1, 0, 0, 1), (2, 0, 51, 0)");
  }
  Database db(file.path());
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "1|2|50.0");
  Database other(file.path());
  other.exec("DELETE FROM ships WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT seq, op, a, b FROM predictive_changes('alerts', 1)"), "2|-|1|2");
  EXPECT_EQ(db.rows("SELECT count(*) FROM alerts"), "0");
}

TEST(WatchFile, ABusyCommitMayBeRepeatedAfterMoreChanges) {
  const TemporaryFile file;
  Database db(file.path()), reader(file.path());
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, within = 1);"
      "INSERT INTO ships VALUES (1, 0, 0, 1), (2, 0, 51, 0)");
  reader.exec("BEGIN");
  EXPECT_EQ(reader.rows("SELECT count(*) FROM ships"), "2");
  db.exec("BEGIN; UPDATE ships SET x = 61 WHERE id = 2");
  EXPECT_EQ(db.code_of("COMMIT"), SQLITE_BUSY);
  db.exec("INSERT INTO ships VALUES (3, 0, 71, 0)");
  reader.exec("COMMIT");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts ORDER BY b"), "1|2|60.0\n1|3|70.0");
  db.exec("COMMIT");
  EXPECT_EQ(db.rows("SELECT op, a, b, t FROM predictive_changes('alerts', 1)"), "~|1|2|60.0\n+|1|3|70.0");
  EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), "NULL");
}

TEST(WatchFile, TwoTablesOfOneWatchAreUpdatedTogether) {
  const TemporaryFile file;
  Database db(file.path());
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx);"
      "CREATE VIRTUAL TABLE buoys USING moving_objects(id, x);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, other = buoys, horizon = 100, within = 1);"
      "BEGIN; INSERT INTO ships VALUES (1, 0, 0, 1); INSERT INTO buoys VALUES (1, 51); COMMIT");
  EXPECT_EQ(db.rows("SELECT op, a, b, t FROM predictive_changes('alerts', 0)"), "+|1|1|50.0");
  Database fresh(file.path());
  fresh.exec("UPDATE buoys SET x = 41 WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT op, a, b, t FROM predictive_changes('alerts', 1)"), "~|1|1|40.0");
  EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), "NULL");
}

/// A look-up for each of many ships would read the state of the watch as often.
TEST_F(Watch, IsReadOnceWhereItIsJoinedWithItsShips) {
  db.exec(
      "INSERT INTO ships(id, t, x, y) WITH RECURSIVE n(i) AS (SELECT 1000 UNION ALL SELECT i + 1 FROM n "
      "WHERE i "
      "< 4000) "
      "SELECT i, 0, 1e6 + 50 * i, 0 FROM n");
  const std::string plan = db.rows(
      "EXPLAIN QUERY PLAN SELECT x.id, y.id, w.t FROM alerts w JOIN ships x ON x.id = w.a JOIN ships y ON "
      "y.id = "
      "w.b ORDER BY w.t LIMIT 20");
  EXPECT_LT(plan.find("SCAN w"), plan.find(" x VIRTUAL")) << plan;
  EXPECT_NE(db.rows("EXPLAIN QUERY PLAN SELECT * FROM alerts WHERE a = 2 OR b = 2").find("MULTI-INDEX OR"),
            std::string::npos);
}

}  // namespace
}  // namespace foresee
