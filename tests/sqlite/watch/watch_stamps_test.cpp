// Stamps of watched tables: after every COMMIT a watch is up to date, and a reader that misses changes gets
// an error.
#include "sqlite/database.h"

namespace foresee {
namespace {

using testing::Database;

struct WatchStamps : ::testing::Test {
  WatchStamps() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, r);"
        "INSERT INTO ships VALUES (1, 0, 1, 10), (2, 120, -1, 10);"
        "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
        "CREATE VIRTUAL TABLE near USING predictive_watch(ships, horizon = 100, within = 5)");
  }
  std::string faults() {
    return db.rows("SELECT name, fault FROM predictive_watches WHERE fault IS NOT NULL");
  }

  Database db;
};

TEST_F(WatchStamps, TwoWatchesAreUpdatedWhereASavepointIsOpenAtCommit) {
  db.exec(
      "BEGIN; UPDATE ships SET x = 2 WHERE id = 1; SAVEPOINT inner; UPDATE ships SET x = 3 WHERE id = 1; "
      "COMMIT");
  EXPECT_EQ(faults(), "");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "1|2|48.5");
  db.exec(
      "BEGIN; UPDATE ships SET x = 4 WHERE id = 1; SAVEPOINT inner; UPDATE ships SET x = 5 WHERE id = 1;"
      "INSERT INTO alerts(alerts, now) VALUES('advance', 1.0); COMMIT");
  EXPECT_EQ(faults(), "");
  db.exec(
      "BEGIN; SAVEPOINT inner; UPDATE ships SET x = 6 WHERE id = 1; ROLLBACK TO inner;"
      "UPDATE ships SET x = 7 WHERE id = 1; COMMIT");
  EXPECT_EQ(faults(), "");
  EXPECT_EQ(db.rows("SELECT * FROM alerts"),
            db.rows("SELECT * FROM predictive_join(100, 'ships') WHERE now = 1"));
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 1"), "7.0");
}

TEST_F(WatchStamps, ARenamedWatchIsUpToDate) {
  db.exec("ALTER TABLE alerts RENAME TO warnings");
  EXPECT_EQ(faults(), "");
  db.exec("UPDATE ships SET x = 2 WHERE id = 1");
  EXPECT_EQ(faults(), "");
  EXPECT_EQ(db.rows("SELECT op, a, b, t FROM predictive_changes('warnings', 1)"), "~|1|2|49.0");
}

TEST_F(WatchStamps, ChangesOfAnOpenTransactionAreNoFault) {
  db.exec("BEGIN; UPDATE ships SET x = 2 WHERE id = 1");
  EXPECT_EQ(faults(), "");
  db.exec("SAVEPOINT s; INSERT INTO ships(ships) VALUES('rebuild')");
  EXPECT_EQ(faults(), "");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "1|2|49.0");
  db.exec("ROLLBACK TO s");
  EXPECT_EQ(faults(), "");
  db.exec("COMMIT");
  EXPECT_EQ(faults(), "");
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "1|2|49.0");
}

TEST_F(WatchStamps, AReaderWhoseChangesAreTrimmedGetsAnError) {
  db.exec(
      "CREATE VIRTUAL TABLE brief USING predictive_watch(ships, horizon = 100, keep = 1500);"
      "WITH n(i) AS (SELECT 3 UNION ALL SELECT i + 1 FROM n WHERE i < 1500) "
      "INSERT INTO ships SELECT i, 1000 * i, 0, 1 FROM n;"
      "WITH n(i) AS (SELECT 3 UNION ALL SELECT i + 1 FROM n WHERE i < 1500) "
      "INSERT INTO ships SELECT 10000 + i, 1000 * i + 1, 0, 1 FROM n");
  sqlite3_stmt* reader = nullptr;
  ASSERT_EQ(
      sqlite3_prepare_v2(db.handle(), "SELECT seq FROM predictive_changes('brief', 1)", -1, &reader, nullptr),
      SQLITE_OK);
  ASSERT_EQ(sqlite3_step(reader), SQLITE_ROW);
  db.exec("UPDATE ships SET x = x + 2 WHERE id > 10000; UPDATE ships SET x = x - 2 WHERE id > 10000");
  int rc = SQLITE_ROW;
  while (rc == SQLITE_ROW) rc = sqlite3_step(reader);
  EXPECT_EQ(rc, SQLITE_ERROR);
  EXPECT_NE(std::string(sqlite3_errmsg(db.handle()))
                .find("are no longer kept; read the whole watch with since = 0"),
            std::string::npos);
  sqlite3_finalize(reader);
}

TEST(WatchCreated, DiffersForAWatchThatIsCreatedAgain) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
  const std::string created = db.rows("SELECT created FROM predictive_watches");
  EXPECT_NE(created, "NULL");
  db.exec(
      "ALTER TABLE alerts RENAME TO near; ALTER TABLE near RENAME TO alerts; INSERT INTO alerts(alerts) "
      "VALUES "
      "('rebuild')");
  EXPECT_EQ(db.rows("SELECT created FROM predictive_watches"), created);
  db.exec("DROP TABLE alerts; CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
  EXPECT_NE(db.rows("SELECT created FROM predictive_watches"), created);
  db.exec("DELETE FROM alerts_meta WHERE key = 'created'");  // as version 0.2.0 writes it
  EXPECT_EQ(db.rows("SELECT created, fault FROM predictive_watches"), "NULL|NULL");
}

}  // namespace
}  // namespace foresee
