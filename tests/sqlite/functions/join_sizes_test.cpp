// Join order that SQLite's planner chooses for tables of moving objects and functions: it follows from the
// numbers of objects.
#include <initializer_list>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

class PlannedOrder : public ::testing::Test {
 protected:
  PlannedOrder() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r);"
        "CREATE VIRTUAL TABLE boats USING moving_objects(id, x, y, vx, vy, r);"
        "CREATE TABLE zones(x0, x1); CREATE TABLE list(id INTEGER PRIMARY KEY)");
    fill("ships", 400);
    fill("boats", 10);
  }
  void fill(const std::string& table, int objects) {
    db.exec("WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " + std::to_string(objects) +
            ") INSERT INTO " + table + " SELECT i, i * 7 % 100, i * 11 % 100, 1, 0, 0.5 FROM n");
  }
  /// Makes the table report this number of objects.
  void pretend(const std::string& table, std::int64_t objects) {
    db.exec("UPDATE " + table + "_meta SET value = " + std::to_string(objects) + " WHERE key = 'objects'; " +
            "UPDATE " + table + "_meta SET value = random() WHERE key = 'stamp'");
    db.rows("SELECT count(*) FROM predictive_window(1, '" + table + "')");
  }
  /// The tables of a SELECT from the outermost loop to the innermost, by their names in it.
  std::string order(const std::string& from) {
    const std::string steps = db.rows("EXPLAIN QUERY PLAN SELECT * FROM " + from);
    std::string names;
    for (std::size_t at = 0; (at = steps.find_first_of("SN", at)) != std::string::npos; ++at)
      for (const std::string step : {"SCAN ", "SEARCH "})
        if (steps.compare(at, step.size(), step) == 0)
          names += (names.empty() ? "" : " ") + steps.substr(at + step.size(), 1);
    return names;
  }
  Database db;
};

const std::string pairs = "ships s JOIN predictive_join(3, 'ships') j ON j.a = s.id";

TEST_F(PlannedOrder, AJoinIsComputedOnceAndItsShipsAreLookedUp) {
  for (const std::int64_t objects : {400, 1000000, 0, 1}) {
    pretend("ships", objects);
    EXPECT_EQ(order(pairs), "j s") << objects;
    EXPECT_EQ(order("predictive_join(3, 'ships') j JOIN ships s ON j.b = s.id"), "j s") << objects;
    EXPECT_EQ(order(pairs + " JOIN ships o ON o.id = j.b"), "j s o") << objects;
    EXPECT_EQ(order(pairs + " WHERE s.x < 10"), "j s") << objects;
  }
}

TEST_F(PlannedOrder, FewShipsAreQueriedOneByOne) {
  for (const std::int64_t objects : {10000, 1000000}) {
    pretend("ships", objects);
    for (const char* few : {"s.id < 20", "s.id BETWEEN 1001 AND 1020",
                            "s.x BETWEEN 1 AND 2 AND s.y BETWEEN 1 AND 2", "s.id IN (1, 2, 3)"})
      EXPECT_EQ(order(pairs + " WHERE " + few), "s j") << objects << " " << few;
    EXPECT_EQ(order(pairs + " WHERE s.id > 3"), "j s");
    EXPECT_EQ(order(pairs + " WHERE s.id > -9000000000000000000"), "j s");
  }
}

TEST_F(PlannedOrder, TheSizesOfBothTablesCount) {
  const std::string by_boat = "boats b JOIN predictive_join(3, 'boats', 0, 'ships') j ON j.a = b.id",
                    by_ship = "ships s JOIN predictive_join(3, 'boats', 0, 'ships') j ON j.b = s.id";
  pretend("ships", 1000000);
  EXPECT_EQ(order(by_boat), "b j");
  EXPECT_EQ(order(by_ship), "j s");
  pretend("ships", 10);
  EXPECT_EQ(order(by_boat), "j b");
  EXPECT_EQ(order(by_ship), "j s");
}

TEST_F(PlannedOrder, ANameThatIsBoundLaterStandsForTheLargestTable) {
  pretend("ships", 1000000);
  const std::string written = "boats b JOIN predictive_join(3, 'boats') j ON j.a = b.id",
                    bound = "boats b JOIN predictive_join(3, ?1) j ON j.a = b.id",
                    left_out = "boats b JOIN predictive_join(3) j ON j.a = b.id",
                    computed = "boats b JOIN predictive_join(3, lower('BOATS')) j ON j.a = b.id";
  for (const std::string& unknown : {bound, left_out, computed}) EXPECT_EQ(order(unknown), "b j") << unknown;
  if (sqlite3_libversion_number() >= 3038000) {
    EXPECT_EQ(order(written), "j b");
    EXPECT_EQ(order("boats b JOIN predictive_join(3, 'BOATS', 0, NULL) j ON j.a = b.id"), "j b");
  }
  pretend("ships", 10);
  for (const std::string& unknown : {bound, left_out, computed}) EXPECT_EQ(order(unknown), "j b") << unknown;
}

TEST_F(PlannedOrder, ATableOfAnotherSchemaIsAnotherTable) {
  db.exec(
      "ATTACH ':memory:' AS aux; CREATE VIRTUAL TABLE aux.boats USING moving_objects(id, x, y, vx, vy, r)");
  pretend("aux.boats", 1000000);
  db.rows("SELECT count(*) FROM predictive_window WHERE h = 1 AND tbl = 'boats' AND schema = 'aux'");
  if (sqlite3_libversion_number() < 3038000) return;
  const std::string join =
      "boats b JOIN predictive_join WHERE h = 3 AND tbl = 'boats' AND a = b.id AND schema = ";
  EXPECT_EQ(order(join + "'main'"), "p b");
  EXPECT_EQ(order(join + "'aux'"), "b p");
  EXPECT_EQ(order(join + "?1"), "b p");
}

TEST_F(PlannedOrder, AWindowPerRowOfATableIsFollowedByLookUps) {
  for (const std::int64_t objects : {0, 400, 1000000}) {
    pretend("ships", objects);
    EXPECT_EQ(order("zones z JOIN predictive_window(3, 'ships', z.x0, z.x1) w JOIN ships s ON s.id = w.id"),
              "z w s");
    EXPECT_EQ(order("ships s JOIN predictive_nearest(3, 'ships', 2, 0, 0) n ON n.id = s.id"), "n s");
    EXPECT_EQ(order("ships s LEFT JOIN predictive_join(3, 'ships') j ON j.a = s.id WHERE s.x < 10"), "s j");
  }
}

TEST_F(PlannedOrder, AnOrdinaryTableIsTheInnerLoopForFewObjectsAndTheOuterLoopForMany) {
  pretend("ships", 1000);
  EXPECT_EQ(order("list l JOIN ships s ON s.id = l.id"), "s l");
  pretend("ships", 100000000);
  EXPECT_EQ(order("ships s JOIN list l ON s.id = l.id"), "l s");
}

TEST_F(PlannedOrder, TheNumberOfObjectsGoesThroughRenamingVacuumAndAttaching) {
  const std::string join = "fleet f JOIN list l ON l.id = f.id",
                    stored = "SELECT value FROM fleet_meta WHERE key = 'objects'";
  db.exec("BEGIN; DELETE FROM ships WHERE id > 300; ALTER TABLE ships RENAME TO fleet");
  EXPECT_EQ(db.rows(stored), "300");
  EXPECT_EQ(order(join), "f l");
  db.exec(
      "ROLLBACK; BEGIN; ALTER TABLE ships RENAME TO fleet; DELETE FROM fleet WHERE id > 200; COMMIT; VACUUM");
  EXPECT_EQ(db.rows(stored), "200");
  pretend("fleet", 100000000);
  db.exec("VACUUM");
  EXPECT_EQ(order(join), "l f");
  TemporaryFile file;
  db.exec("INSERT INTO fleet(fleet) VALUES('rebuild'); VACUUM INTO '" + file.path() + "'; DROP TABLE fleet");
  db.exec("ATTACH '" + file.path() + "' AS copy");
  EXPECT_EQ(db.rows(stored), "200");
  EXPECT_EQ(db.rows("SELECT count(*) FROM fleet"), "200");
  EXPECT_EQ(order(join), "f l");
  db.exec("INSERT INTO fleet(fleet) VALUES('integrity-check'); DETACH copy");
}

TEST_F(PlannedOrder, WhatATransactionAddsCountsAtOnce) {
  const std::string join = "boats b JOIN predictive_join(3, 'boats', 0, 'ships') j ON j.a = b.id";
  pretend("ships", 10);
  db.exec("DELETE FROM ships");
  EXPECT_EQ(order(join), "j b");
  db.exec("BEGIN");
  fill("ships", 20000);
  EXPECT_EQ(order(join), "b j");
  db.exec("ROLLBACK");
  EXPECT_EQ(order(join), "j b");
}

}  // namespace
}  // namespace foresee::testing
