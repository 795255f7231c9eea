// Damaged values in a watch's _meta: each value with another type, out of range, or missing. A watch never
// uses a default in its place: reads, changes and commands give an error that names the value.
// predictive_watches reports it as the fault, the watched table stays writable, and DROP TABLE works.
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

struct MetaKey {
  const char* key;
  std::vector<const char*> wrong;  ///< in addition to a text and a blob
  bool is_text = false;
  bool may_be_missing = false;  ///< then its default does no harm
};

const std::vector<MetaKey>& meta_keys() {
  static const std::vector<MetaKey> all = {
      {"format", {"0", "-1", "2.0", "NULL"}},
      {"tbl", {"7", "''", "NULL"}, true},
      {"other", {"7", "''", "1.5"}, true},
      {"horizon", {"-1", "9e999", "NULL", "1e6"}},
      {"within", {"-1", "9e999", "NULL"}},
      {"within_z", {"-1", "9e999"}},
      {"clock", {"0", "'Newest'", "''", "NULL"}, true},
      {"tolerance", {"-1", "9e999", "NULL"}},
      {"keep", {"0", "-1", "1.5", "9e18", "NULL"}},
      {"ahead", {"-1", "9e999"}},
      {"now", {"9e999", "-9e999", "NULL", "-1e9", "1e9"}},
      {"asked", {"9e999", "-9e999"}, false, true},
      {"anew", {"2", "-1", "0.5"}, false, true},
      {"known_to", {"9e999", "-9e999", "NULL", "0", "1e9"}},
      {"step", {"-1"}, false, true},
      {"further", {"-1", "0", "NULL"}},
      {"waited", {"-1", "0.5"}, false, true},
      {"dropped", {"-1", "0.5"}, false, true},
      {"seq", {"-1", "0.5", "NULL"}},
      {"early_reports", {"-1", "0.5", "NULL"}},
      {"stamp", {"0.5"}, false, true},
      {"other_stamp", {"0.5"}, false, true},
  };
  return all;
}

constexpr const char* statements[] = {"SELECT * FROM alerts",
                                      "SELECT a FROM alerts WHERE b = 2",
                                      "SELECT * FROM predictive_changes('alerts', 0)",
                                      "SELECT * FROM predictive_changes('alerts', 1)",
                                      "INSERT INTO alerts(alerts, now) VALUES('advance', 200)",
                                      "INSERT INTO alerts(alerts) VALUES('rebuild')",
                                      "INSERT INTO alerts(alerts) VALUES('integrity-check')"};

constexpr const char* life =
    "PRAGMA synchronous = OFF;"
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx, r);"
    "INSERT INTO ships VALUES (1, 0, 0, 1, 10), (2, 0, 120, -1, 10), (3, 0, 900, 1, 1);"
    "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, ahead = 1000);"
    "UPDATE ships SET t = 101, x = 101 WHERE id = 1; UPDATE ships SET t = 102, x = 120 WHERE id = 2;";

class WatchMeta : public ::testing::TestWithParam<MetaKey> {
 protected:
  void expect_error(Database& db, const std::string& fault) {
    for (const char* sql : statements) {
      const std::string error = db.error_of(sql);
      EXPECT_TRUE(error.ends_with(fault)) << sql << ": " << error;
    }
    EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), fault);
    EXPECT_EQ(db.error_of("UPDATE ships SET x = x + 1 WHERE id = 3"), "") << fault;
    EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), fault);
  }

  /// `shown`: the value as the message shows it.
  void damage(const std::string& sql, const std::string& shown) {
    const TemporaryFile file;
    Database db(file.path());
    db.exec(life);
    db.exec(sql);
    const std::string fault = std::string("alerts: alerts_meta is damaged: ") + GetParam().key + " is " +
                              shown + "; DROP TABLE alerts and CREATE it again";
    expect_error(db, fault);
    Database fresh(file.path());
    fresh.exec("PRAGMA synchronous = OFF");
    expect_error(fresh, fault);
    EXPECT_EQ(fresh.error_of("DROP TABLE alerts"), "");
    fresh.exec("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
    expect_joined(fresh, "h = 100");
    expect_up_to_date(fresh);
  }

  std::string set(const std::string& value) {
    return "INSERT OR REPLACE INTO alerts_meta VALUES ('" + std::string(GetParam().key) + "', " + value + ")";
  }
};

TEST_P(WatchMeta, OfAnotherTypeIsAnErrorThatNamesIt) {
  if (!GetParam().is_text) damage(set("'abc'"), "'abc'");
  if (!GetParam().is_text) damage(set("'1'"), "'1'");
  damage(set("x'616263'"), "a blob");
}

TEST_P(WatchMeta, BeyondItsRangeIsAnError) {
  for (const char* value : GetParam().wrong) {
    Database db;
    db.exec(life);
    db.exec(set(value));
    const std::string fault = db.rows("SELECT fault FROM predictive_watches");
    EXPECT_TRUE(fault.starts_with("alerts: alerts_meta is damaged: ")) << value << fault;
    expect_error(db, fault);
  }
}

/// In no case does the watch give a wrong row.
TEST_P(WatchMeta, ThatIsMissingIsAnErrorOrDoesNoHarm) {
  const std::string sql = std::string("DELETE FROM alerts_meta WHERE key = '") + GetParam().key + "'";
  if (!GetParam().may_be_missing) return damage(sql, "missing");
  Database db;
  db.exec(life);
  db.exec(sql);
  for (const char* change :
       {"", "UPDATE ships SET x = x + 1 WHERE id = 2", "INSERT INTO ships VALUES (4, 103, 60, 0, 1)"}) {
    db.exec(change);
    expect_joined(db, "h = 100", change);
  }
  expect_up_to_date(db);
}

INSTANTIATE_TEST_SUITE_P(Keys, WatchMeta, ::testing::ValuesIn(meta_keys()),
                         [](const auto& info) { return std::string(info.param.key); });

/// The keys of the watched table that a watch depends on.
TEST(WatchMetas, ATableThatDoesNotListItOrHasNoStampIsAFault) {
  for (const auto& [sql, fault] :
       {std::pair{"DELETE FROM ships_meta WHERE key LIKE 'watch:%'",
                  "alerts: ships_meta does not list it, so commits pass it over; DROP TABLE alerts and "
                  "CREATE it again"},
        std::pair{"UPDATE ships_meta SET value = 'abc' WHERE key = 'stamp'", "ships: the stamp is missing"},
        std::pair{"DELETE FROM ships_meta WHERE key = 'stamp'", "ships: the stamp is missing"}}) {
    const TemporaryFile file;
    Database(file.path()).exec(std::string(life) + sql);
    Database db(file.path());
    EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), fault);
    if (std::string(sql).find("stamp") == std::string::npos) {
      db.exec("UPDATE ships SET x = x + 1 WHERE id = 2");
      expect_joined(db, "h = 100");  // by the join
      EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), fault);
      db.exec("DROP TABLE alerts; CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
      expect_up_to_date(db);
    } else {
      EXPECT_EQ(db.error_of("SELECT * FROM alerts"), fault);
    }
  }
}

TEST(WatchMetas, ChangesAndPairsOfOtherTypesAreErrorsAsWell) {
  for (const auto& [sql, table] :
       {std::pair{"UPDATE alerts_log SET t = 'soon' WHERE op <> '-'", "log"},
        std::pair{"UPDATE alerts_log SET t = NULL WHERE op <> '-'", "log"},
        std::pair{"UPDATE alerts_log SET now = x'00'", "log"},
        std::pair{"UPDATE alerts_log SET now = NULL", "log"},
        std::pair{"UPDATE alerts_log SET a = 'one'", "log"},
        std::pair{"UPDATE alerts_log SET b = NULL", "log"},
        std::pair{"UPDATE alerts_log SET op = '++'", "log"}, std::pair{"UPDATE alerts_log SET op = 7", "log"},
        std::pair{"UPDATE alerts_pair SET state = 7", "pair"},
        std::pair{"UPDATE alerts_pair SET state = -1", "pair"}}) {
    Database db;
    db.exec(life);
    db.exec("UPDATE ships SET x = 500 WHERE id = 3");
    db.exec(sql);
    const bool of_log = std::string(table) == "log";
    EXPECT_EQ(db.error_of(of_log ? "SELECT * FROM predictive_changes('alerts', 1)" : "SELECT * FROM alerts"),
              std::string(of_log ? "predictive_changes: " : "") + "alerts: alerts_" + table +
                  " is damaged: DROP TABLE alerts and CREATE it again")
        << sql;
  }
}

TEST(WatchMetas, AClockThatIsMissingWhereNoPairEverWasIsNotReadAsZero) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx, r);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 10)");
  expect_up_to_date(db);
  db.exec("BEGIN; INSERT INTO ships VALUES (1, 100, 0, 1, 1), (2, 100, -80, 0, 1)");
  expect_joined(db, "h = 10");
  EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), "NULL");
  db.exec("COMMIT");
  expect_up_to_date(db);
  db.exec("DELETE FROM alerts_meta WHERE key = 'now'");
  expect_joined(db, "h = 10");
  EXPECT_TRUE(db.rows("SELECT fault FROM predictive_watches").starts_with("not up to date"));
  db.exec("UPDATE ships SET x = x + 1 WHERE id = 1");
  expect_joined(db, "h = 10");
  expect_up_to_date(db);
}

TEST(WatchMetas, AClockAtTheEndsOfTheNumbersIsInItsRange) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, r); INSERT INTO ships VALUES (1, 0, 5), (2, 3, "
      "5);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 10, clock = manual)");
  for (const char* now :
       {"1e300", "-1e300", "1.7976931348623157e308", "-1.7976931348623157e308", "0", "5e-324", "1e15"}) {
    db.exec(std::string("INSERT INTO alerts(alerts, now) VALUES('advance', ") + now + ")");
    EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), "NULL") << now;
    db.exec("UPDATE ships SET x = x + 1 WHERE id = 1; UPDATE ships SET x = x - 1 WHERE id = 1");
    EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), "NULL") << now;
  }
}

}  // namespace
}  // namespace foresee::testing
