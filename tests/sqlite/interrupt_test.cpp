// An interrupt and a progress handler stop a long computation, on every version of SQLite.
#include "database.h"
#include "sqlite/statement_interrupt.h"

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

TEST_F(StatementInterruptTest, LetsAComputationRun) {
  EXPECT_EQ(db.rows("SELECT busy(900)"), "ran");
}

TEST_F(StatementInterruptTest, NoticesAnInterruptAndRecovers) {
  EXPECT_EQ(db.rows("SELECT busy(100000000)"), "error: interrupted");
  EXPECT_EQ(db.rows("SELECT busy(900)"), "ran");
}

TEST_F(StatementInterruptTest, DrivesTheProgressHandler) {
  static int calls;
  calls = 0;
  sqlite3_progress_handler(
      db.handle(), 1, [](void*) { return ++calls > 20 ? 1 : 0; }, nullptr);
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
  EXPECT_EQ(db.rows("SELECT forever()"), "error: interrupted");
  EXPECT_GT(calls, 20);
}

TEST_F(StatementInterruptTest, CostsLittleACheck) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000000; ++i) interrupt.check();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
}

}  // namespace
}  // namespace foresee::testing
