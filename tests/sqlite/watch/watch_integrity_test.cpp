// 'integrity-check' of a watch reads all keys of its pairs.
#include "sqlite/watch/older_watch.h"

namespace foresee {
namespace {

using testing::Database;
using testing::make_format_2;
using testing::TemporaryFile;

struct WatchKeys {
  const char* name;  ///< of the index or table, with % for the watch
  bool in_tables;
};

/// A watch with two pairs, and one without pairs, whose empty index or table replaces that of the first.
void exchange_keys(const TemporaryFile& file, const WatchKeys& keys) {
  const std::string name = std::string("'") + keys.name + "'";
  Database db(file.path());
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
      "CREATE VIRTUAL TABLE act USING predictive_watch(ships, horizon = 0);"
      "INSERT INTO ships VALUES (1, 0, 0, 0, 1, 0, 1), (2, 0, 9, 0, 0, 0, 1), (3, 0, 99, 0, 0, 0, 1);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);");
  if (!keys.in_tables) make_format_2(db, "act"), make_format_2(db, "alerts");
  db.exec(
      "INSERT INTO alerts(alerts) VALUES('integrity-check');"
      "PRAGMA writable_schema = ON;"
      "UPDATE sqlite_master SET rootpage = (SELECT rootpage FROM sqlite_master WHERE name LIKE replace(" +
      name + ", '%', 'act')) WHERE name LIKE replace(" + name + ", '%', 'alerts')");
}

class WatchIndex : public ::testing::TestWithParam<WatchKeys> {};

TEST_P(WatchIndex, ThatLacksRowsIsFound) {
  const TemporaryFile file;
  exchange_keys(file, GetParam());
  Database db(file.path());
  EXPECT_EQ(db.error_of("INSERT INTO alerts(alerts) VALUES('integrity-check')"),
            GetParam().in_tables ? "alerts: alerts_back and alerts_due do not hold the keys of alerts_pair"
                                 : "alerts: the indexes of alerts_pair do not hold its rows");
}

constexpr WatchKeys all_watch_keys[] = {{"sqlite_autoindex_%_pair_2", false},
                                        {"sqlite_autoindex_%_pair_3", false},
                                        {"%_back", true},
                                        {"%_due", true}};
INSTANTIATE_TEST_SUITE_P(OfPairs, WatchIndex, ::testing::ValuesIn(all_watch_keys));

TEST(WatchKeyTables, AKeyTooManyIsFoundAndARebuildRemovesIt) {
  for (const char* damage :
       {"INSERT INTO alerts_back VALUES (77, 1)", "INSERT INTO alerts_due VALUES (1, 5.0, 1, 77)",
        "UPDATE alerts_due SET due = due + 1", "UPDATE alerts_pair SET due = NULL"}) {
    SCOPED_TRACE(damage);
    Database db;
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx, r);"
        "INSERT INTO ships VALUES (1, 0, 0, 1, 1), (2, 0, 9, 0, 1), (3, 0, 99, 0, 1);"
        "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
        "INSERT INTO alerts(alerts) VALUES('integrity-check')");
    db.exec(damage);
    EXPECT_NE(db.error_of("INSERT INTO alerts(alerts) VALUES('integrity-check')"), "");
    db.exec(
        "INSERT INTO alerts(alerts) VALUES('rebuild'); INSERT INTO alerts(alerts) VALUES('integrity-check')");
    EXPECT_EQ(db.rows("SELECT * FROM predictive_changes('alerts', 1)"), "") << "the rows are the same";
  }
}

}  // namespace
}  // namespace foresee
