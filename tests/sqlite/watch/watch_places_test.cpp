// Schemas and files of watches: in attached files and under other names, read-only, vacuumed, copied, created
// and dropped by another connection.
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

/// A watched table in the schema, with two ships that meet at 50.
std::string ships_in(const std::string& schema) {
  return "CREATE VIRTUAL TABLE " + schema + ".ships USING moving_objects(id, t, x, vx, r);" + "INSERT INTO " +
         schema + ".ships VALUES (1, 0, 0, 1, 10), (2, 0, 120, -1, 10);" + "CREATE VIRTUAL TABLE " + schema +
         ".alerts USING predictive_watch(ships, horizon = 100);";
}

TEST(WatchPlaces, ASchemaHasItsOwn) {
  const TemporaryFile file;
  Database db(file.path());
  db.exec("ATTACH '" + file.path("other.db") + "' AS harbour;" + ships_in("harbour"));
  EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "1|2|50.0");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('alerts', 0)"), "+|50.0");
  db.exec(ships_in("main"));
  db.exec(
      "BEGIN; DELETE FROM main.ships WHERE id = 1; UPDATE harbour.ships SET x = 130 WHERE id = 2; COMMIT");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('alerts', 1, 'harbour')"), "~|55.0");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('alerts', 1, 'main')"), "-|NULL");
  EXPECT_EQ(db.rows("SELECT schema, name, pairs, fault FROM predictive_watches ORDER BY schema"),
            "harbour|alerts|1|NULL\nmain|alerts|0|NULL");
  db.exec("INSERT INTO harbour.alerts(alerts, now) VALUES('advance', 20)");
  EXPECT_EQ(db.rows("SELECT schema, now FROM predictive_watches ORDER BY schema"), "harbour|20.0\nmain|0.0");
  for (const char* harbour :
       {"predictive_watches('harbour')", "predictive_watches WHERE schema_name = 'Harbour'",
        "predictive_watches WHERE within_schema = 'harbour'", "predictive_watches(NULL, 'harbour')",
        "predictive_watches('harbour') WHERE within_schema = 'harbour'"})
    EXPECT_EQ(db.rows(std::string("SELECT schema, now FROM ") + harbour), "harbour|20.0") << harbour;
  EXPECT_EQ(
      db.rows("SELECT schema FROM predictive_watches WHERE within_schema IN ('main', 'harbour') ORDER BY 1"),
      "harbour\nmain");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_watches('main') WHERE within_schema = 'harbour'"), "0");
}

TEST(WatchPlaces, AFileIsDetachedAndAttachedUnderAnotherName) {
  const TemporaryFile file;
  Database db(file.path());
  db.exec("ATTACH '" + file.path("other.db") + "' AS harbour;" + ships_in("harbour"));
  db.exec("UPDATE harbour.ships SET x = 130 WHERE id = 2; DETACH harbour");
  db.exec("ATTACH '" + file.path("third.db") + "' AS harbour;" + ships_in("harbour"));
  db.exec("ATTACH '" + file.path("other.db") + "' AS port; UPDATE port.ships SET x = 140 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('alerts', 1, 'port')"), "~|55.0\n~|60.0");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('alerts', 0, 'harbour')"), "+|50.0");
  db.exec("DELETE FROM harbour.ships WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT schema, seq, fault FROM predictive_watches ORDER BY schema"),
            "harbour|2|NULL\nport|3|NULL");
}

TEST(WatchPlaces, TheTableIsOfTheSameSchema) {
  Database db;
  db.exec(ships_in("main"));
  const std::string error =
      db.error_of("CREATE VIRTUAL TABLE temp.w USING predictive_watch(ships, horizon = 1)");
  EXPECT_NE(error.find("no such table: 'ships' in schema 'temp'"), std::string::npos) << error;
}

TEST(WatchPlaces, AReadOnlyConnectionReadsAll) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(ships_in("main") + "UPDATE ships SET x = 130 WHERE id = 2");
  }
  for (const std::string& name : {file.path(), "file:" + file.path() + "?immutable=1"}) {
    Database db(name, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    expect_joined(db, "h = 100");
    EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('alerts', 1)"), "~|55.0");
    EXPECT_EQ(db.rows("SELECT name, pairs, fault FROM predictive_watches"), "alerts|1|NULL");
    EXPECT_EQ(db.code_of("INSERT INTO alerts(alerts, now) VALUES('advance', 7)") & 0xff, SQLITE_READONLY);
    EXPECT_EQ(db.code_of("DELETE FROM ships") & 0xff, SQLITE_READONLY);
  }
}

TEST(WatchPlaces, AReadOnlyConnectionGetsTheRowsOfTheJoinIfTheWatchIsNotUpToDate) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(ships_in("main") +
            "UPDATE alerts_pair SET t = 77; UPDATE ships_meta SET value = 1 WHERE key = 'stamp'");
  }
  {
    Database db(file.path(), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    EXPECT_EQ(db.rows("SELECT a, b, t FROM alerts"), "1|2|50.0");
    EXPECT_EQ(db.rows("SELECT fault LIKE 'not up to date%' FROM predictive_watches"), "1");
  }
  Database db(file.path());
  db.exec("UPDATE ships SET x = 120 WHERE id = 2");
  expect_joined(db, "h = 100");
  expect_up_to_date(db);
  EXPECT_EQ(db.rows("SELECT t FROM alerts_pair"), "50.0");
}

TEST(WatchPlaces, AVacuumedFileKeepsItsWatches) {
  const TemporaryFile file;
  Database db(file.path());
  db.exec(ships_in("main") + "UPDATE ships SET x = 130 WHERE id = 2; VACUUM");
  expect_up_to_date(db);
  db.exec("VACUUM INTO '" + file.path("copy.db") + "'; UPDATE ships SET x = 140 WHERE id = 2; VACUUM");
  EXPECT_EQ(db.rows("SELECT seq, op, t FROM predictive_changes('alerts', 1)"), "2|~|55.0\n3|~|60.0");
  Database copy(file.path("copy.db"));
  copy.exec("DELETE FROM ships WHERE id = 2");
  EXPECT_EQ(copy.rows("SELECT seq, op, t FROM predictive_changes('alerts', 1)"), "2|~|55.0\n3|-|NULL");
  expect_up_to_date(copy);
}

TEST(WatchPlaces, CreateRenameAndDropByAnotherConnectionAreSeen) {
  const TemporaryFile file;
  Database db(file.path()), other(file.path());
  db.exec(ships_in("main"));
  EXPECT_EQ(other.rows("SELECT count(*) FROM ships"), "2");
  db.exec("CREATE VIRTUAL TABLE near USING predictive_watch(ships, horizon = 60)");
  other.exec("UPDATE ships SET x = 118 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('near', 1)"), "~|49.0");
  db.exec("ALTER TABLE near RENAME TO close; ALTER TABLE ships RENAME TO boats");
  other.exec("UPDATE boats SET x = 116 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('close', 2)"), "~|48.0");
  db.exec("DROP TABLE close");
  other.exec("UPDATE boats SET x = 114 WHERE id = 2; UPDATE boats SET x = 112 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT name, tbl, seq, fault FROM predictive_watches"), "alerts|boats|5|NULL");
  other.exec("DROP TABLE alerts");
  db.exec("DELETE FROM boats; DROP TABLE boats");
}

TEST(WatchPlaces, RenamesAreRolledBack) {
  Database db;
  db.exec(ships_in("main"));
  db.exec(
      "BEGIN; UPDATE ships SET x = 130 WHERE id = 2; ALTER TABLE ships RENAME TO boats;"
      "ALTER TABLE alerts RENAME TO near; UPDATE boats SET x = 140 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT t FROM near"), "60.0");
  db.exec("ROLLBACK; UPDATE ships SET x = 150 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT seq, op, t FROM predictive_changes('alerts', 1)"), "2|~|65.0");
  EXPECT_EQ(db.rows("SELECT name, tbl, fault FROM predictive_watches"), "alerts|ships|NULL");
}

TEST(WatchPlaces, RenamesAndChangesMayShareATransaction) {
  Database db;
  db.exec(ships_in("main"));
  db.exec(
      "BEGIN; UPDATE ships SET x = 130 WHERE id = 2; ALTER TABLE ships RENAME TO boats;"
      "UPDATE boats SET x = 140 WHERE id = 2; ALTER TABLE alerts RENAME TO near; UPDATE boats SET r = 15; "
      "COMMIT");
  EXPECT_EQ(db.rows("SELECT op, t FROM predictive_changes('near', 1)"), "~|55.0");
  EXPECT_EQ(db.rows("SELECT name, tbl, fault FROM predictive_watches"), "near|boats|NULL");
  EXPECT_EQ(db.error_of("INSERT INTO near(near) VALUES('integrity-check')"), "");
}

TEST(WatchPlaces, AWatchIsCreatedAndDroppedAmongChanges) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx, r); BEGIN;"
      "INSERT INTO ships VALUES (1, 0, 0, 1, 10), (2, 0, 120, -1, 10);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
      "UPDATE ships SET x = 130 WHERE id = 2; COMMIT");
  expect_joined(db, "h = 100");
  expect_up_to_date(db);
  WatchReader reader;
  reader.read(db);
  reader.expect_rows(db);
  db.exec(
      "BEGIN; UPDATE ships SET x = 140 WHERE id = 2; DROP TABLE alerts; UPDATE ships SET x = 150; COMMIT");
  EXPECT_EQ(db.rows("SELECT x FROM ships"), "150.0\n150.0");
  EXPECT_EQ(db.rows("SELECT name FROM sqlite_master WHERE name LIKE 'alerts%'"), "");
  db.exec(
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
      "BEGIN; DROP TABLE alerts; CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 1);"
      "UPDATE ships SET x = 160; COMMIT");
  EXPECT_EQ(db.rows("SELECT horizon, seq, pairs, fault FROM predictive_watches"), "1.0|1|1|NULL");
}

TEST(WatchPlaces, APrefixedNameIsNoOtherTablesShadow) {
  Database db;
  db.exec(ships_in("main") +
          "CREATE TABLE alerts_notes(x); INSERT INTO alerts_notes VALUES (1); DROP TABLE alerts");
  EXPECT_EQ(db.rows("SELECT x FROM alerts_notes"), "1");
}

TEST(WatchPlaces, NamesMayHoldQuotesAndSpaces) {
  Database db;
  db.exec(R"(CREATE VIRTUAL TABLE "my ""ships" USING moving_objects(id, x, vx, r);)"
          R"(CREATE VIRTUAL TABLE "the 'alerts" USING predictive_watch("my ""ships", horizon = 100);)"
          R"(INSERT INTO "my ""ships" VALUES (1, 0, 1, 10), (2, 120, -1, 10);)"
          R"(INSERT INTO "the 'alerts"("the 'alerts", now) VALUES('advance', 3))");
  EXPECT_EQ(db.rows("SELECT op, a, b, t FROM predictive_changes('the ''alerts', 0)"), "+|1|2|50.0");
  db.exec(R"(ALTER TABLE "the 'alerts" RENAME TO "a.b"; DELETE FROM "my ""ships" WHERE id = 1)");
  EXPECT_EQ(db.rows("SELECT name, seq, fault FROM predictive_watches"), "a.b|2|NULL");
}

}  // namespace
}  // namespace foresee::testing
