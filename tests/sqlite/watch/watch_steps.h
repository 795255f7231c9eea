// The steps of a watch's life, for tests in which a step fails: CREATE, changes, clock, commands, names,
// DROP.
//
//   for (const WatchStep& step : watch_steps) {
//     Database db;
//     db.exec(objects_to_watch(60) + step.before);
//     …the statements fail, or do their work…
//     EXPECT_TRUE(all_of_watch(db) == before || …);
//   }
#pragma once

#include "sqlite/database.h"

namespace foresee::testing {

struct WatchStep {
  const char* name;
  std::string before;  ///< SQL that prepares the step, in addition to the objects
  std::string sql;
};

inline std::string objects_to_watch(int count) {
  return "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
         "CREATE VIRTUAL TABLE buoys USING moving_objects(id, x, y);"
         "INSERT INTO buoys VALUES (1, 20, 20), (2, 70, 60), (3, 15, 80);"
         "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " +
         std::to_string(count) +
         ") INSERT INTO ships SELECT i, i % 5, i * 37 % 100, i * 53 % 90, i % 7 - 3, i % 5 - 2, 0.5 FROM n;";
}

inline const std::string create_alerts =
    "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 10, within = 6, keep = 20);";
inline const std::string create_passing =
    "CREATE VIRTUAL TABLE passing USING predictive_watch(ships, other = buoys, horizon = 5, tolerance = 1);";
inline const std::string advance_alerts = "INSERT INTO alerts(alerts, now) VALUES('advance', 12);";

inline const WatchStep watch_steps[] = {
    {"Create", "", create_alerts},
    {"CreateASecondOne", create_alerts, create_passing},
    {"Change", create_alerts + create_passing,
     "BEGIN; UPDATE ships SET t = 9, x = x + 5 WHERE id % 9 = 1; DELETE FROM ships WHERE id = 7;"
     "UPDATE ships SET id = 700 WHERE id = 8; INSERT INTO ships VALUES(7, 9, 1, 2, 0, 0, 1); COMMIT"},
    {"ChangeBothTables", create_alerts + create_passing,
     "BEGIN; UPDATE buoys SET x = x + 1; UPDATE ships SET y = 20, t = 7 WHERE id = 3; COMMIT"},
    {"Savepoints", create_alerts,
     "BEGIN; SAVEPOINT s; DELETE FROM ships WHERE id < 9; ROLLBACK TO s; DELETE FROM ships WHERE id = 20; "
     "RELEASE s;"
     "COMMIT"},
    {"Advance", create_alerts, advance_alerts},
    {"AdvanceFar", create_alerts, "INSERT INTO alerts(alerts, now) VALUES('advance', 1e6)"},
    {"AdvanceBack", create_alerts + advance_alerts, "INSERT INTO alerts(alerts, now) VALUES('advance', 5)"},
    {"Rebuild", create_alerts, "INSERT INTO alerts(alerts) VALUES('rebuild')"},
    {"Check", create_alerts, "INSERT INTO alerts(alerts) VALUES('integrity-check')"},
    {"Read", create_alerts + advance_alerts,
     "SELECT * FROM alerts; SELECT a, t FROM alerts WHERE b = 7; SELECT * FROM predictive_changes('alerts', "
     "0);"
     "SELECT * FROM predictive_changes('alerts', (SELECT max(seq) - 1 FROM alerts_log)); SELECT * FROM "
     "predictive_watches"},
    {"ReadInATransaction", create_alerts,
     "BEGIN; UPDATE ships SET x = x + 5 WHERE id % 9 = 1; SELECT * FROM alerts; SELECT a FROM alerts WHERE b "
     "= 7; COMMIT"},
    {"RenameTheTable", create_alerts, "ALTER TABLE ships RENAME TO boats"},
    {"RenameTheWatch", create_alerts, "ALTER TABLE alerts RENAME TO near"},
    {"Merge", create_alerts,
     "INSERT INTO ships(ships) VALUES('optimize'); INSERT INTO ships(ships) VALUES('rebuild')"},
    {"Drop", create_alerts + create_passing, "DROP TABLE alerts"},
};

/// All contents of tables and watches under any name, except the random numbers.
inline std::string all_of_watch(Database& db) {
  std::string all;
  for (const std::string table : {"ships", "boats", "buoys"})
    all += db.rows("SELECT * FROM " + table + " ORDER BY id") + "\n";
  for (const std::string watch : {"alerts", "near", "passing"}) {
    all += db.rows("SELECT * FROM " + watch + " ORDER BY a, b") + "\n";
    all += db.rows("SELECT * FROM " + watch + "_pair ORDER BY a, b") + "\n";
    all += db.rows("SELECT * FROM " + watch + "_back ORDER BY b, a") + "\n";
    all += db.rows("SELECT * FROM " + watch + "_due ORDER BY state, due, a, b") + "\n";
    all += db.rows("SELECT * FROM " + watch + "_log") + "\n";
    all +=
        db.rows("SELECT * FROM " + watch + "_meta WHERE key NOT LIKE '%stamp' AND key <> 'created'") + "\n";
  }
  return all + db.rows("SELECT name FROM sqlite_master ORDER BY name") +
         db.rows("SELECT name, tbl, now, seq, fault FROM predictive_watches ORDER BY name");
}

/// The integrity check of every watch finds that its rows are those of the join.
inline void expect_watches_are_sound(Database& db) {
  for (const std::string watch : {"alerts", "near", "passing"}) {
    const std::string error =
        db.error_of("INSERT INTO " + watch + "(" + watch + ") VALUES('integrity-check')");
    EXPECT_TRUE(error.empty() || error == "no such table: " + watch) << error;
  }
}

}  // namespace foresee::testing
