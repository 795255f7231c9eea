// Interrupts and progress handlers: both stop a long computation, on every version of SQLite.
#include <chrono>

#include "database.h"
#include "database/sqlite_api.h"
#include "database/statement.h"

namespace foresee::testing {
namespace {

/// An SQL function that computes until it is stopped: 'stopped', or 'ran' after `argument` checks.
void busy(sqlite3_context* context, int, sqlite3_value** arguments) {
  auto* interrupt = static_cast<StatementInterrupt*>(sqlite3_user_data(context));
  const int checks = sqlite3_value_int(arguments[0]);
  try {
    for (int i = 0; i < checks; ++i) {
      if (i == 1000) sqlite3_interrupt(sqlite3_context_db_handle(context));
      interrupt->check();
    }
    sqlite3_result_text(context, "ran", -1, SQLITE_STATIC);
  } catch (const Interrupted&) {
    sqlite3_result_error_code(context, SQLITE_INTERRUPT);
  }
}

struct StatementInterruptTest : ::testing::Test {
  StatementInterruptTest() {
    sqlite3_create_function(db.handle(), "busy", 1, SQLITE_UTF8, &interrupt, busy, nullptr, nullptr);
  }
  ~StatementInterruptTest() override { interrupt.finalize(); }

  Database db;
  StatementInterrupt interrupt{db.handle()};
};

/// SQLite reports "database schema has changed" when an interrupt stops it while it reads the schema again.
TEST(StatementOfTheExtension, SaysInterruptedAlsoAfterAChangeOfTheSchema) {
  const TemporaryFile file;
  Database reader(file.path());
  Database writer(file.path());
  writer.exec("CREATE TABLE a(x)");
  Statement select(reader.handle(), "SELECT x FROM a");
  select.prepare();
  writer.exec("CREATE TABLE b(x)");
  sqlite3_progress_handler(
      reader.handle(), 1, [](void*) { return 1; }, nullptr);
  try {
    Statement::Run(select).step();
    ADD_FAILURE() << "was not interrupted";
  } catch (const StoreError& error) {
    EXPECT_EQ(error.code & 0xff, SQLITE_INTERRUPT);
    EXPECT_STREQ(error.what(), "interrupted");
  }
  sqlite3_progress_handler(reader.handle(), 0, nullptr, nullptr);
  EXPECT_FALSE(Statement::Run(select).step());
}

TEST_F(StatementInterruptTest, LetsAComputationRun) {
  EXPECT_EQ(db.rows("SELECT busy(900)"), "ran");
}

TEST_F(StatementInterruptTest, SeesAnInterruptAndRecovers) {
  EXPECT_EQ(db.rows("SELECT busy(100000000)"), "error: interrupted");
  EXPECT_EQ(db.rows("SELECT busy(900)"), "ran");
}

TEST_F(StatementInterruptTest, DrivesTheProgressHandler) {
  sqlite3_create_function(
      db.handle(), "forever", 0, SQLITE_UTF8, &interrupt,
      [](sqlite3_context* context, int, sqlite3_value**) {
        try {
          for (;;) static_cast<StatementInterrupt*>(sqlite3_user_data(context))->check();
        } catch (const Interrupted&) {
          sqlite3_result_error_code(context, SQLITE_INTERRUPT);
        }
      },
      nullptr, nullptr);
  static int calls;
  // SQLite calls the handler once per N of its own instructions: a check per millisecond runs a thousand.
  for (const int instructions : {1, 1000}) {
    calls = 0;
    sqlite3_progress_handler(
        db.handle(), instructions, [](void*) { return ++calls > 20 ? 1 : 0; }, nullptr);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(db.rows("SELECT forever()"), "error: interrupted");
    EXPECT_GT(calls, 20);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << "some 20 milliseconds";
  }
}

TEST_F(StatementInterruptTest, CostsLittlePerCheck) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000000; ++i) interrupt.check();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
}

TEST(CommitInterrupt, LeavesAllOfATransactionOrNothing) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy); INSERT INTO ships VALUES(1, 2, 3, "
      "4, 5)");
  static int left;
  for (int queried = 1;; queried += queried) {
    db.exec(
        "BEGIN; WITH RECURSIVE i(n) AS (VALUES (2) UNION ALL SELECT n + 1 FROM i WHERE n < 1000)"
        "INSERT INTO ships SELECT n, n, n % 7, 1, n % 5 FROM i");
    left = queried;
    sqlite3_progress_handler(
        db.handle(), 1, [](void*) { return --left == 0 ? 1 : 0; }, nullptr);
    const int rc = db.code_of("COMMIT");
    sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
    if (rc == SQLITE_OK) break;
    EXPECT_EQ(rc, SQLITE_INTERRUPT) << queried;
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("ROLLBACK");
    EXPECT_EQ(db.rows("SELECT count(*), sum(x) FROM ships"), "1|2.0") << queried;
  }
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "1000");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(PlanInterrupt, LeavesThePlanOrTheNewOne) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y, plan);"
      "CREATE TABLE p AS WITH RECURSIVE i(n) AS (VALUES (0) UNION ALL SELECT n + 1 FROM i WHERE n < 40000)"
      "SELECT plan_points(n, n % 77, n % 50) AS plan FROM i;"
      "INSERT INTO robots(id, plan) SELECT 1, plan_shift(plan, 5) FROM p");
  static int left;
  int interrupted = 0;
  for (int queried = 100;; queried += queried / 2) {
    left = queried;
    sqlite3_progress_handler(
        db.handle(), 1, [](void*) { return --left == 0 ? 1 : 0; }, nullptr);
    const int rc = db.code_of("UPDATE robots SET plan = (SELECT plan FROM p)");
    sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
    const std::string plan = rc == SQLITE_OK ? "LINESTRING M(0 0 0, 1 1 1, " : "LINESTRING M(0 0 5, 1 1 6, ";
    ASSERT_EQ(db.rows("SELECT substr(plan, 1, 27) FROM robots"), plan) << queried;
    ASSERT_EQ(db.rows("SELECT count(*) FROM robots, plan_rows(plan)"), "40000") << queried;
    ASSERT_EQ(db.error_of("INSERT INTO robots(robots) VALUES ('integrity-check')"), "") << queried;
    if (rc == SQLITE_OK) break;
    ++interrupted;
  }
  EXPECT_GT(interrupted, 5);
}

}  // namespace
}  // namespace foresee::testing
