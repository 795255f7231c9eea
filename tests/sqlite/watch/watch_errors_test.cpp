// Errors of watches for meaningless statements and declarations: each message names the watch's own arguments
// and says what to write.
#include "sqlite/database.h"

namespace foresee {
namespace {

struct WatchErrors : ::testing::Test {
  WatchErrors() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
        "INSERT INTO ships VALUES (1, 0, 0, 0, 1, 0, 10), (2, 0, 120, 0, -1, 0, 10);"
        "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
  }

  testing::Database db;
};

TEST_F(WatchErrors, MeaninglessStatementsGiveErrorsThatSayWhatToWrite) {
  const auto starts = [&](const std::string& sql, const std::string& text) {
    EXPECT_EQ(db.error_of(sql).substr(0, text.size()), text) << sql;
  };
  starts("INSERT INTO alerts(a, b) VALUES (1, 2)", "alerts is kept by foresee: change ships instead");
  starts("DELETE FROM alerts", "alerts is kept by foresee: change ships instead");
  starts("UPDATE alerts SET t = 3", "alerts is kept by foresee: change ships instead");
  starts("UPDATE alerts SET alerts = 'rebuild'",
         "alerts.alerts takes commands by INSERT only; write INSERT INTO");
  for (const char* clock : {"UPDATE alerts SET now = 9", "INSERT INTO alerts(now) VALUES(9)"})
    starts(clock,
           "alerts: the clock moves by a command; write INSERT INTO alerts(alerts, now) VALUES('advance', 9");
  starts("INSERT INTO alerts(alerts) VALUES('advance')", "alerts: 'advance' needs a time");
  starts("INSERT INTO alerts(alerts, now) VALUES('advance', '2026-11-30')",
         "alerts: 'advance' needs a time, as in INSERT INTO alerts(alerts, now) VALUES('advance', "
         "unixepoch('2026-11-30'))");
  starts("INSERT INTO alerts(alerts, now) VALUES('advance', '2026-11-30 ''x')",
         "alerts: 'advance' needs a time, as in INSERT INTO alerts(alerts, now) VALUES('advance', 1260.0)");
  starts("INSERT INTO alerts(alerts) VALUES('retreat')", "alerts: no command 'retreat'; known: 'advance'");
  const std::string create = "CREATE VIRTUAL TABLE w USING predictive_watch";
  starts(create, "w: no table is named");
  starts(create + "(ships)", "w: horizon is missing: write predictive_watch(ships, horizon = 600)");
  starts(create + "(boats, horizon = 5)",
         "w: no such table: 'boats' in schema 'main' (moving_objects tables here:");
  starts(create + "(ships, horizon = -1)", "w: \"horizon = -1\": horizon must be a finite number >= 0");
  starts(create + "(ships, horizon = 1, horizon = 2)", "w: \"horizon = 2\": horizon is given twice");
  starts(create + "(ships, horizon = 1, colour = 2)", "w: \"colour = 2\": no such option; known: horizon");
  starts(create + "(ships, horizon = 1, within_z = 2)", "w: ");
  db.exec("CREATE TABLE list(x)");
  starts(create + "(boats, horizon = 5)",
         "w: no such table: 'boats' in schema 'main' (moving_objects tables here: 'ships')");
  starts("CREATE VIRTUAL TABLE temp.w USING predictive_watch(ships, horizon = 5)",
         "w: no such table: 'ships' in schema 'temp'; a watch is in the schema of its table: write CREATE "
         "VIRTUAL "
         "TABLE main.w");
  starts(create + "(ships, horizon = 5, other = alerts)",
         "w: 'alerts' is a watch; name the table whose objects move (moving_objects tables here: 'ships')");
  starts(create + "(list, horizon = 5)",
         "w: 'list' is not a moving_objects table; name the table whose objects move");
  starts("SELECT * FROM predictive_join(5, 'alerts')",
         "predictive_join: 'alerts' is not a moving_objects table but a watch: its pairs are SELECT * FROM "
         "alerts");
  starts("SELECT * FROM predictive_changes(5)",
         "predictive_changes: watch must be the name of a watch in quotes, not 5");
  starts("SELECT * FROM predictive_changes('boats')",
         "predictive_changes: no such watch: 'boats' (watches here: 'alerts')");
  const std::string named = "; write a name of SELECT name FROM predictive_watches (watches here: 'alerts'";
  starts("SELECT * FROM predictive_changes('ships', 0)",
         "predictive_changes: 'ships' is not a watch but a table of moving objects" + named + ")");
  starts("SELECT * FROM predictive_changes('list', 0, 'main')",
         "predictive_changes: 'list' in schema 'main' is not a watch" + named + " with schema = 'main')");
  db.exec(
      "ATTACH ':memory:' AS north; CREATE VIRTUAL TABLE north.boats USING moving_objects(id, x);"
      "CREATE VIRTUAL TABLE north.storms USING predictive_watch(boats, horizon = 5)");
  starts(
      "SELECT * FROM predictive_changes('gone')",
      "predictive_changes: no such watch: 'gone' (watches here: 'alerts', 'storms' with schema = 'north')");
  db.exec("DETACH north");
  // A table of temp does not hide the watch.
  db.exec("CREATE TEMP TABLE alerts(x)");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_changes('alerts')"), "1|2");
  db.exec("DROP TABLE temp.alerts");
  const std::string known = "; known: horizon, within, within_z, other, clock, tolerance, keep, ahead";
  starts(create + "(ships, 300)", "w: \"300\": an option needs a name; write horizon = 300" + known);
  starts(create + "(ships, -3)",
         "w: \"-3\": an option needs a name; write name = value, as in horizon = 600" + known);
  starts(create + "(ships, horizon > 300)",
         "w: \"horizon > 300\": an option needs a name; write name = value");
  starts(create + "(ships, horizon 300)",
         "w: \"horizon 300\": an option is written name = value; write horizon = 300");
  starts(create + "(ships, horizon)",
         "w: \"horizon\": an option is written name = value; write horizon = 600");
  starts(create + "(ships, buoys)",
         "w: \"buoys\": only the first argument is a table; a second one is written other = buoys");
  for (const char* first : {"300", "main.ships", "+ships", "horizon = 5", "ships REAL"})
    starts(create + "(" + first + ", horizon = 5)",
           std::string("w: \"") + first +
               "\": the first argument is the name of the table to watch; write predictive_watch(ships, "
               "horizon = 600)");
}

}  // namespace
}  // namespace foresee
