// 'integrity-check' of a watch reads each index of its pairs.
#include "sqlite/database.h"

namespace foresee {
namespace {

using testing::Database;
using testing::TemporaryFile;

/// A watch with two pairs, and one without pairs, whose empty index replaces an index of the first.
void exchange_index(const TemporaryFile& file, int number) {
  const std::string index = "'sqlite_autoindex_%_pair_" + std::to_string(number) + "'";
  Database db(file.path());
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
      "CREATE VIRTUAL TABLE act USING predictive_watch(ships, horizon = 0);"
      "INSERT INTO ships VALUES (1, 0, 0, 0, 1, 0, 1), (2, 0, 9, 0, 0, 0, 1), (3, 0, 99, 0, 0, 0, 1);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100);"
      "INSERT INTO alerts(alerts) VALUES('integrity-check');"
      "PRAGMA writable_schema = ON;"
      "UPDATE sqlite_master SET rootpage = (SELECT rootpage FROM sqlite_master WHERE name LIKE replace(" +
      index + ", '%', 'act')) WHERE name LIKE replace(" + index + ", '%', 'alerts')");
}

class WatchIndex : public ::testing::TestWithParam<int> {};

TEST_P(WatchIndex, ThatLacksRowsIsFound) {
  const TemporaryFile file;
  exchange_index(file, GetParam());
  Database db(file.path());
  EXPECT_EQ(db.error_of("INSERT INTO alerts(alerts) VALUES('integrity-check')"),
            "alerts: the indexes of alerts_pair do not hold its rows");
}

INSTANTIATE_TEST_SUITE_P(OfPairs, WatchIndex, ::testing::Values(2, 3));

}  // namespace
}  // namespace foresee
