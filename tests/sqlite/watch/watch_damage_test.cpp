// Shadow tables of a watch that plain SQL has dropped or changed: the watched table stays writable. A
// read of the watch gives an error or the rows of the join, predictive_watches names the fault, and DROP
// TABLE works.
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

struct WatchDamage {
  const char* name;
  const char* sql;
};

constexpr WatchDamage watch_damages[] = {
    {"NoPairs", "DROP TABLE alerts_pair"},
    {"NoKeysByB", "DROP TABLE alerts_back"},
    {"NoKeysByDue", "DROP TABLE alerts_due"},
    {"KeysOfOtherColumns", "DROP TABLE alerts_due; CREATE TABLE alerts_due(x)"},
    {"KeysOfText", "UPDATE alerts_back SET b = 'x'; UPDATE alerts_due SET due = 'soon'"},
    {"KeysWithoutPairs", "DELETE FROM alerts_pair"},
    {"PairsWithoutKeys", "DELETE FROM alerts_back; DELETE FROM alerts_due"},
    {"NoLog", "DROP TABLE alerts_log"},
    {"NoMeta", "DROP TABLE alerts_meta"},
    {"NoTablesAtAll", "DROP TABLE alerts_pair; DROP TABLE alerts_log; DROP TABLE alerts_meta"},
    {"OtherColumns", "DROP TABLE alerts_pair; CREATE TABLE alerts_pair(x)"},
    {"EmptyMeta", "DELETE FROM alerts_meta"},
    {"NoHorizon", "DELETE FROM alerts_meta WHERE key = 'horizon'"},
    {"HorizonOfText", "UPDATE alerts_meta SET value = 'far' WHERE key = 'horizon'"},
    {"InfiniteHorizon", "UPDATE alerts_meta SET value = 9e999 WHERE key = 'horizon'"},
    {"NegativeWithin", "UPDATE alerts_meta SET value = -1 WHERE key = 'within'"},
    {"NegativePosition", "UPDATE alerts_meta SET value = -7 WHERE key = 'seq'"},
    {"NothingKept", "UPDATE alerts_meta SET value = 0 WHERE key = 'keep'"},
    {"InfiniteClock", "UPDATE alerts_meta SET value = 9e999 WHERE key = 'now'"},
    {"InfinitelyFarAsked", "UPDATE alerts_meta SET value = -9e999 WHERE key = 'asked'"},
    {"NewerFormat", "UPDATE alerts_meta SET value = 4 WHERE key = 'format'"},
    {"NoFormat", "DELETE FROM alerts_meta WHERE key = 'format'"},
    {"NoSuchTable", "UPDATE alerts_meta SET value = 'boats' WHERE key = 'tbl'"},
    {"NoSuchOther", "UPDATE alerts_meta SET value = 'boats' WHERE key = 'other'"},
    {"WatchesItself", "UPDATE alerts_meta SET value = 'alerts' WHERE key = 'tbl'"},
    {"WatchesAViewOfItself",
     "CREATE VIEW v AS SELECT count(*) AS v FROM alerts; UPDATE alerts_meta SET value = 'v' WHERE key = "
     "'tbl'"},
    {"WatchesAnOrdinaryTable", "UPDATE alerts_meta SET value = 'list' WHERE key = 'tbl'"},
    {"TimesOfText", "UPDATE alerts_pair SET t = 'soon'"},
    {"NoTimes", "UPDATE alerts_pair SET t = NULL"},
    {"BlobsForDue", "UPDATE alerts_pair SET due = x'00'"},
    {"NoState", "UPDATE alerts_pair SET state = NULL"},
    {"IdsOfText", "UPDATE alerts_pair SET a = 'one'"},
    {"NobodysPairs", "INSERT INTO alerts_pair VALUES (77, 78, 5.0, 9.0, 1, NULL)"},
    {"OpsOfNothing", "UPDATE alerts_log SET op = ''"},
};

class DamagedWatch : public ::testing::TestWithParam<WatchDamage> {
 protected:
  /// Checks on a connection that has used the watch, and on a new one.
  void look_at(Database& db) {
    EXPECT_EQ(db.error_of("UPDATE ships SET x = x + 1 WHERE id = 2"), "");
    EXPECT_EQ(db.error_of("DELETE FROM ships WHERE id = 3; INSERT INTO ships VALUES (3, 2, 0, 1, 1)"), "");
    EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "3");
    EXPECT_NE(db.rows("SELECT a FROM predictive_join(100, 'ships')").substr(0, 5), "error");
    db.rows("SELECT * FROM predictive_changes('alerts', 0)");
    const std::string rows = db.rows("SELECT a, b, t FROM alerts ORDER BY a, b");
    const std::string watches = db.rows("SELECT name, fault IS NOT NULL FROM predictive_watches");
    if (rows.starts_with("error")) {
      EXPECT_EQ(watches, "alerts|1") << rows;
    } else if (watches == "alerts|0" && std::string(GetParam().sql).find("horizon") == std::string::npos) {
      EXPECT_EQ(
          db.code_of("INSERT INTO alerts(alerts) VALUES('integrity-check')") == SQLITE_OK,
          rows == db.rows("SELECT a, b, t FROM predictive_join WHERE h = 100 AND tbl = 'ships' AND now = "
                          "(SELECT now FROM predictive_watches) ORDER BY a, b"))
          << rows;
    }
  }
};

TEST_P(DamagedWatch, IsNoReasonToRefuseAWriteAndCanBeDropped) {
  const TemporaryFile file;
  Database db(file.path());
  db.exec(
      "CREATE TABLE list(id, x); CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx, r);"
      "INSERT INTO ships VALUES (1, 0, 0, 1, 10), (2, 0, 120, -1, 10), (3, 0, 900, 1, 1);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100); UPDATE ships SET t = 1 "
      "WHERE id = 1");
  db.exec(GetParam().sql);
  look_at(db);
  {
    Database fresh(file.path());
    look_at(fresh);
    EXPECT_EQ(fresh.error_of("DROP TABLE alerts"), "");
    EXPECT_EQ(fresh.rows("SELECT name FROM sqlite_master WHERE name LIKE 'alerts%'"), "");
  }
  db.exec("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
  expect_joined(db, "h = 100");
  expect_up_to_date(db);
  db.exec("UPDATE ships SET x = x - 1 WHERE id = 2");
  expect_joined(db, "h = 100");
  db.exec("DROP TABLE alerts; DROP TABLE ships");
}

INSTANTIATE_TEST_SUITE_P(Damages, DamagedWatch, ::testing::ValuesIn(watch_damages),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(DamagedWatches, ARebuildRepairsRowsAndLogsTheDifference) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, r);"
      "INSERT INTO ships VALUES (1, 0, 1, 10), (2, 120, -1, 10), (3, 110, 0, 1);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
      "DELETE FROM alerts_pair WHERE b = 3; UPDATE alerts_pair SET t = 7.0");
  EXPECT_EQ(db.code_of("INSERT INTO alerts(alerts) VALUES('integrity-check')"), SQLITE_CORRUPT_VTAB);
  db.exec("INSERT INTO alerts(alerts) VALUES('rebuild')");
  expect_joined(db, "h = 100");
  expect_up_to_date(db);
  EXPECT_EQ(db.rows("SELECT op, a, b, schema FROM predictive_changes('alerts', 1)"),
            "~|1|2|main\n+|1|3|main\n+|2|3|main");
}

TEST(DamagedWatches, UnknownFormatsAreReportedAndOlderOnesRead) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, r);"
      "INSERT INTO ships VALUES (1, 0, 1, 10), (2, 120, -1, 10), (3, 110, 0, 1);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
      "UPDATE alerts_meta SET value = 4 WHERE key = 'format'");
  EXPECT_EQ(
      db.rows("SELECT a FROM alerts"),
      "error: alerts: stored in format 4; this version of foresee reads formats up to 3: open it with the "
      "version that wrote it");
  // The format of 0.2.0.
  db.exec(
      "UPDATE alerts_meta SET value = 1 WHERE key = 'format';"
      "UPDATE alerts_meta SET key = 'early', value = 7 WHERE key = 'early_reports'");
  expect_joined(db, "h = 100");
  EXPECT_EQ(db.rows("SELECT early FROM predictive_watches"), "7");
  for (const char* x : {"130", "140"}) {
    db.exec("UPDATE ships SET x = " + std::string(x) + " WHERE id = 2");
    expect_joined(db, "h = 100");
    EXPECT_EQ(db.rows("SELECT early FROM predictive_watches"), "7");
    EXPECT_EQ(db.rows("SELECT key, value FROM alerts_meta WHERE key LIKE 'early%' OR key = 'format'"),
              "early|NULL\nearly_reports|7\nformat|3");
  }
}

// A commit that fails to write a page of the log has written pairs already.
TEST(DamagedWatches, AFullLogIsReportedToEveryReader) {
  const TemporaryFile file;
  Database db(file.path());
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, r);"
      "INSERT INTO ships VALUES (1, 0, 1, 10), (2, 120, -1, 10), (3, 900, 0, 1), (4, 901, 0, 1);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
      "CREATE TRIGGER full BEFORE INSERT ON alerts_log WHEN new.seq > (SELECT value + 1 FROM alerts_meta "
      "WHERE key = 'seq') BEGIN SELECT abs(-9223372036854775807 - 1); END");
  db.exec("DELETE FROM ships WHERE id = 4");  // one change, which the log accepts
  expect_up_to_date(db);
  db.exec("UPDATE ships SET x = 60 WHERE id = 3");  // two, and the second is refused
  db.exec("DROP TRIGGER full");
  const std::string fault =
      "alerts: a commit could not write all of its changes (integer overflow): DROP TABLE alerts and CREATE "
      "it again";
  const auto expect_fault = [&](Database& reader) {
    EXPECT_EQ(reader.rows("SELECT fault FROM predictive_watches"), fault);
    for (const std::string sql : {"SELECT * FROM alerts", "SELECT * FROM predictive_changes('alerts', 1)",
                                  "INSERT INTO alerts(alerts) VALUES('rebuild')"})
      EXPECT_TRUE(reader.error_of(sql).ends_with(fault)) << sql << reader.error_of(sql);
  };
  expect_fault(db);
  EXPECT_EQ(db.error_of("UPDATE ships SET x = 70 WHERE id = 3"), "");
  Database fresh(file.path());
  expect_fault(fresh);
  fresh.exec("DROP TABLE alerts; CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
  expect_joined(fresh, "h = 100");
  expect_up_to_date(fresh);
}

}  // namespace
}  // namespace foresee::testing
