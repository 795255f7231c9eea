// Plans through the life of a database: rollbacks, savepoints, two connections, kept statements, VACUUM, ATTACH.
#include <map>

#include "sqlite/database.h"
#include "sqlite/lives/old_statements.h"
#include "sqlite/random_numbers.h"

namespace foresee::testing {
namespace {

constexpr const char* create = "CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y, plan, r, +name);";
constexpr const char* all = "SELECT id, x, plan, r FROM robots ORDER BY id";
constexpr const char* check = "INSERT INTO robots(robots) VALUES ('integrity-check')";

/// 'LINESTRING M(at 0 0, …)' with so many legs; each takes 1.
std::string plan_text(int at, int legs) {
  std::string text = "LINESTRING M(";
  for (int i = 0; i <= legs; ++i)
    text += (i ? ", " : "") + std::to_string(at + i % 5) + " 0 " + std::to_string(i);
  return text + ")";
}

std::string insert(int id, int legs) {
  return "INSERT OR REPLACE INTO robots(id, plan, r) VALUES (" + std::to_string(id) + ", '" +
         plan_text(id, legs) + "', 0.5);";
}

std::string row(int id, int legs) {
  return std::to_string(id) + "|" + std::to_string(id) + ".0|" + plan_text(id, legs) + "|0.5";
}

struct PlanLives : ::testing::Test {
  PlanLives() { db.exec(create); }
  void expect_sound(const std::string& rows) {
    EXPECT_EQ(db.rows(all), rows);
    EXPECT_EQ(db.error_of(check), "");
    Database other(file.path());
    EXPECT_EQ(other.rows(all), rows);
    EXPECT_EQ(other.error_of(check), "");
  }
  TemporaryFile file;
  Database db{file.path()};
};

TEST_F(PlanLives, RolledBackTransactionsAndSavepoints) {
  db.exec(insert(1, 40) + insert(2, 3));
  db.exec("BEGIN;" + insert(1, 5) + insert(3, 100) + "DELETE FROM robots WHERE id = 2; ROLLBACK");
  expect_sound(row(1, 40) + "\n" + row(2, 3));
  db.exec(
      "BEGIN;" + insert(1, 17) + "SAVEPOINT s;" + insert(1, 70) + insert(2, 33) +
      "UPDATE robots SET r = 9; SAVEPOINT s2; UPDATE robots SET plan = NULL, x = x, y = y; ROLLBACK TO s2");
  EXPECT_EQ(db.rows("SELECT id, plan, r FROM robots ORDER BY id"),
            "1|" + plan_text(1, 70) + "|9.0\n2|" + plan_text(2, 33) + "|9.0");
  db.exec("ROLLBACK TO s");
  EXPECT_EQ(db.rows(all), row(1, 17) + "\n" + row(2, 3));
  db.exec("RELEASE s; COMMIT");
  expect_sound(row(1, 17) + "\n" + row(2, 3));
}

TEST_F(PlanLives, AFailedStatementChangesNothing) {
  db.exec(insert(1, 20) + insert(2, 20));
  EXPECT_NE(db.error_of(
                "UPDATE robots SET plan = CASE id WHEN 2 THEN 'prose' ELSE 'LINESTRING M(0 0 0, 1 1 1)' END"),
            "");
  expect_sound(row(1, 20) + "\n" + row(2, 20));
  db.exec("BEGIN;" + insert(1, 30));
  EXPECT_NE(db.error_of(
                "UPDATE robots SET plan = CASE id WHEN 2 THEN 'prose' ELSE 'LINESTRING M(0 0 0, 1 1 1)' END"),
            "");
  db.exec("COMMIT");
  expect_sound(row(1, 30) + "\n" + row(2, 20));
}

TEST_F(PlanLives, TwoConnections) {
  Database other(file.path());
  db.exec(insert(1, 40));
  EXPECT_EQ(other.rows(all), row(1, 40));
  other.exec("UPDATE robots SET plan = '" + plan_text(1, 7) + "'");
  EXPECT_EQ(db.rows(all), row(1, 7));
  db.exec("BEGIN;" + insert(1, 9));
  EXPECT_EQ(other.rows(all), row(1, 7));
  EXPECT_EQ(other.error_of(insert(2, 1)), "database is locked");
  db.exec("COMMIT");
  other.exec(insert(2, 1));
  expect_sound(row(1, 9) + "\n" + row(2, 1));
}

// Connection 1 has the chunk of the first plan in memory; the new plan gets the same number.
TEST_F(PlanLives, AChunkNumberIsUsedAgainByAnotherConnection) {
  const std::string position = "SELECT x, y FROM predictive_position(5, 'robots') WHERE id = 1";
  db.exec("INSERT INTO robots(id, plan) VALUES (1, 'LINESTRING M(0 0 0, 10 0 10)')");
  Database reader(file.path());
  EXPECT_EQ(reader.rows("SELECT id FROM predictive_window(100, 'robots') WHERE now = 0"), "1");
  EXPECT_EQ(reader.rows(position), "5.0|0.0");
  Database(file.path()).exec("DELETE FROM robots");
  Database(file.path())
      .exec("INSERT INTO robots(id, plan) VALUES (1, 'LINESTRING M(0 0 0, 0 1000 10)'), (2, '" +
            plan_text(2, 3) + "')");
  EXPECT_EQ(reader.rows(position), "0.0|500.0");
  EXPECT_EQ(reader.rows("SELECT x, y FROM predictive_track(5, 5, 1, 'robots') WHERE id = 1"), "0.0|500.0");
}

// The tree of chunks has nothing within reach here, and the other tree still has.
TEST_F(PlanLives, NearestOfPlainRowsBesideAFarPlan) {
  db.exec(
      "WITH n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 1599) "
      "INSERT INTO robots(id, x, y, r) SELECT i, i % 40 * 10, i / 40 * 10, 0 FROM n;"
      "INSERT INTO robots(id, plan, r) VALUES (9999, 'LINESTRING M(5000 5000 0, 5001 5000 100)', 0)");
  for (int x = 0; x < 400; x += 39)
    for (int y = 0; y < 400; y += 26) {
      const auto nearest = [&](const std::string& method) {
        return db.rows(
            "SELECT id, distance FROM predictive_nearest WHERE h = 0 AND tbl = 'robots' AND k = 5 AND now = "
            "10 "
            "AND x = " +
            std::to_string(x) + " AND y = " + std::to_string(y) + " AND method = '" + method + "'");
      };
      EXPECT_EQ(nearest("tree"), nearest("scan")) << x << ' ' << y;
    }
}

// After each change every connection must answer by plain rows and by plans as the scan does.
TEST_F(PlanLives, RandomChangesOfTwoConnections) {
  Engine random(71);
  Database other(file.path());
  const auto change = [&](Database& writer) {
    const int id = drawn(random, 1, 60), kind = drawn(random, 0, 9);
    const std::string place =
        std::to_string(drawn(random, 0, 300)) + ", " + std::to_string(drawn(random, 0, 300));
    if (kind < 4) {
      writer.exec(insert(id, drawn(random, 1, 40)));
    } else if (kind < 7) {
      for (int i = 0; i < 30; ++i)
        writer.exec("INSERT OR REPLACE INTO robots(id, x, y, r) VALUES (" +
                    std::to_string(drawn(random, 1, 900)) + ", " + place + " + " + std::to_string(10 * i) +
                    ", 0)");
    } else if (kind < 9) {
      writer.exec("DELETE FROM robots WHERE id BETWEEN " + std::to_string(id) + " AND " +
                  std::to_string(id + 3));
    } else {
      writer.exec("BEGIN;" + insert(id, 9) + insert(id + 1, 30) + "ROLLBACK");
    }
  };
  for (int step = 0; step < 60; ++step) {
    change(drawn(random, 0, 1) ? db : other);
    for (Database* reader : {&db, &other}) {
      const std::string id = std::to_string(drawn(random, 1, 60)), t = std::to_string(drawn(random, 0, 30));
      const std::string position = "SELECT id, x, y FROM predictive_position(" + t + ", 'robots') WHERE id ";
      EXPECT_EQ(reader->rows(position + "= " + id), reader->rows(position + "+ 0 = " + id)) << step;
      const auto nearest = [&](const char* method) {
        return reader->rows(
            "SELECT id, distance, t FROM predictive_nearest WHERE h = 5 AND tbl = 'robots' AND k = 7 "
            "AND x = 40 AND y = 50 AND now = " +
            t + " AND method = '" + method + "' ORDER BY rank");
      };
      EXPECT_EQ(nearest("tree"), nearest("scan")) << step;
      const auto window = [&](const char* method) {
        return reader->rows(
            "SELECT id, t FROM predictive_window WHERE h = 5 AND tbl = 'robots' AND x0 = 0 AND "
            "x1 = 40 AND now = " +
            t + " AND method = '" + method + "' ORDER BY id");
      };
      EXPECT_EQ(window("tree"), window("scan")) << step;
    }
  }
  EXPECT_EQ(db.error_of(check), "");
}

TEST_F(PlanLives, VacuumRenameAttachAndDrop) {
  db.exec(insert(1, 40) + insert(2, 16) + "DELETE FROM robots WHERE id = 2; VACUUM");
  expect_sound(row(1, 40));
  db.exec("INSERT INTO robots(robots) VALUES ('rebuild'); INSERT INTO robots(robots) VALUES ('optimize')");
  expect_sound(row(1, 40));
  db.exec("ALTER TABLE robots RENAME TO carts");
  EXPECT_EQ(db.rows("SELECT plan FROM carts"), plan_text(1, 40));
  EXPECT_EQ(db.error_of("INSERT INTO carts(id, plan) VALUES (3, 'x')"),
            "carts.plan of row 3: at character 1: expected LINESTRING M or LINESTRING ZM, found 'x'");
  db.exec("ALTER TABLE carts RENAME TO robots");
  TemporaryFile second;
  db.exec("ATTACH '" + second.path() +
          "' AS two; CREATE VIRTUAL TABLE two.robots USING moving_objects(id, x, y, plan, r);"
          "INSERT INTO two.robots SELECT id, x, y, plan, r FROM main.robots");
  EXPECT_EQ(db.rows("SELECT id, x, plan, r FROM two.robots"), row(1, 40));
  EXPECT_EQ(db.rows("SELECT name, schema, objects FROM foresee_tables ORDER BY schema"),
            "robots|main|1\nrobots|two|1");
  db.exec("DETACH two");
  db.exec("VACUUM INTO '" + second.path("copy.db") + "'");
  EXPECT_EQ(Database(second.path("copy.db")).rows(all), row(1, 40));
  db.exec("DROP TABLE robots");
  EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema"), "0");
}

TEST_F(PlanLives, StatementsKeptOverSchemaChanges) {
  KeepingDriver driver(file.path());
  const std::string update = "UPDATE robots SET plan = '" + plan_text(1, 33) + "' WHERE id = 1";
  driver.exec(insert(1, 40));
  EXPECT_EQ(driver.rows(all), row(1, 40));
  driver.exec("CREATE TABLE q(x)");
  driver.exec(update);
  EXPECT_EQ(driver.rows(all), row(1, 33));
  db.exec("DROP TABLE robots");
  db.exec("CREATE VIRTUAL TABLE robots USING moving_objects(id, r, plan, x, y, +name)");
  driver.exec(insert(1, 8));
  EXPECT_EQ(driver.rows(all), row(1, 8));
  driver.exec(update);
  expect_sound(row(1, 33));
}

TEST_F(PlanLives, AScanWhosePlansAreRewrittenReadsThemAsTheyAre) {
  std::map<int, int> legs;
  for (int id = 1; id <= 300; ++id) db.exec(insert(id, legs[id] = 1 + id % 40));
  sqlite3_stmt* scan = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(db.handle(), "SELECT id, plan FROM robots", -1, &scan, nullptr), SQLITE_OK);
  int rows = 0;
  while (sqlite3_step(scan) == SQLITE_ROW) {
    const int id = sqlite3_column_int(scan, 0);
    EXPECT_EQ(reinterpret_cast<const char*>(sqlite3_column_text(scan, 1)), plan_text(id, legs[id]));
    for (const int other : {id, 1 + id * 7 % 300, 1 + id * 11 % 300})
      db.exec("UPDATE robots SET plan = '" + plan_text(other, legs[other] = 1 + (id + other) % 50) +
              "' WHERE id = " + std::to_string(other));
    if (id % 7 == 0) db.exec("DELETE FROM robots WHERE id = " + std::to_string(1 + id * 13 % 300));
    ++rows;
  }
  EXPECT_EQ(sqlite3_finalize(scan), SQLITE_OK);
  EXPECT_LT(rows, 300);
  EXPECT_GT(rows, 200);
  EXPECT_EQ(db.error_of(check), "");
}

/// Else the object would vanish on the way of its new plan.
TEST(PlanUntil, OfTheOldPlanDoesNotCutTheNextOne) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE robots USING moving_objects(id, t, x, y, vx, vy, plan, r, until, +name)");
  db.exec("INSERT INTO robots(id, plan, r, until) VALUES (7, 'LINESTRING M(0 0 0, 10 0 50)', 1, 40)");
  const std::string
      later = "plan = 'LINESTRING M(0 0 0, 20 0 90)'",
      refusal =
          "robots.until of row 7 is 40: before the end of the new plan, 90; set until to NULL too, or "
          "cut the plan with plan_cut";
  EXPECT_EQ(db.error_of("UPDATE robots SET " + later), refusal);
  EXPECT_EQ(db.error_of("UPDATE robots SET plan = q FROM (SELECT 'LINESTRING M(0 0 0, 20 0 90)' AS q)"),
            refusal);
  db.exec("UPDATE robots SET r = q FROM (SELECT 2 AS q)");  // the same plan
  EXPECT_EQ(db.rows("SELECT until FROM robots"), "40.0");
  db.exec("UPDATE robots SET plan = 'LINESTRING M(0 0 0, 10 0 30)'");  // which ends before it
  EXPECT_EQ(db.rows("SELECT until FROM robots"), "40.0");
  db.exec("UPDATE robots SET until = NULL, " + later);
  db.exec("UPDATE robots SET plan = 'LINESTRING M(0 0 0, 20 0 99)'");
  EXPECT_EQ(db.rows("SELECT until FROM robots"), "NULL");
  db.exec(
      "UPDATE robots SET until = 40; INSERT OR REPLACE INTO robots(id, plan, r, until) "
      "VALUES (7, 'LINESTRING M(0 0 0, 20 0 80)', 1, 40)");  // another row
}

}  // namespace
}  // namespace foresee::testing
