// Interrupts of predictive_join: an interrupt ends a long join within 50 ms, and the join calls the progress
// handler while it runs.
#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

using Clock = std::chrono::steady_clock;

/// All objects at one point: 200 million pairs.
struct JoinInterrupt : ::testing::Test {
  JoinInterrupt() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r);"
        "WITH RECURSIVE i(n) AS (VALUES (1) UNION ALL SELECT n + 1 FROM i WHERE n < 20000)"
        "INSERT INTO ships SELECT n, 0, 0, n % 7, n % 5, 1 FROM i");
  }

  /// Milliseconds from sqlite3_interrupt to the end of the statement.
  double latency(const std::string& sql, std::chrono::milliseconds after) {
    Clock::time_point queried;
    std::thread other([&] {
      std::this_thread::sleep_for(after);
      queried = Clock::now();
      sqlite3_interrupt(db.handle());
    });
    const int rc = db.code_of(sql);
    const Clock::time_point ended = Clock::now();
    other.join();
    EXPECT_EQ(rc, SQLITE_INTERRUPT) << sql;
    return std::chrono::duration<double, std::milli>(ended - queried).count();
  }

  double median_latency(const std::string& sql) {
    std::vector<double> all;
    for (int after : {30, 60, 90, 120, 150}) all.push_back(latency(sql, std::chrono::milliseconds(after)));
    std::sort(all.begin(), all.end());
    return all[all.size() / 2];
  }

  Database db;
};

TEST_F(JoinInterrupt, EndsAJoinThatFindsRowsAllTheTime) {
  for (const std::string method : {"grid", "scan"})
    EXPECT_LT(
        median_latency("SELECT count(d_cpa + t) FROM predictive_join(600) WHERE method = '" + method + "'"),
        50)
        << method;
}

TEST_F(JoinInterrupt, EndsAJoinWithHelperThreads) {
  db.exec("PRAGMA threads = 2");
  for (const std::string order : {"", " ORDER BY t"})
    EXPECT_LT(
        median_latency("SELECT count(d_cpa + t) FROM (SELECT * FROM predictive_join(600)" + order + ")"), 50)
        << order;
}

TEST_F(JoinInterrupt, EndsAJoinThatFindsNothing) {
  // Each ship ends before it could meet another: candidates without end, no row.
  db.exec(
      "CREATE VIRTUAL TABLE brief USING moving_objects(id, t, x, vx, until);"
      "INSERT INTO brief SELECT id, id, 0, 1, id + 0.5 FROM ships");
  EXPECT_LT(median_latency("SELECT count(*) FROM predictive_join(30000, 'brief', 1, NULL, 0, 'scan')"), 50);
}

TEST_F(JoinInterrupt, LeavesTheNextStatementAlone) {
  latency("SELECT count(*) FROM predictive_join(600)", std::chrono::milliseconds(20));
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(0) WHERE a = 20000"), "0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(0) WHERE b = 20000"), "19999");
}

TEST_F(JoinInterrupt, CallsTheProgressHandler) {
  int calls = 0;
  sqlite3_progress_handler(
      db.handle(), 1, [](void* count) { return ++*static_cast<int*>(count) > 20 ? 1 : 0; }, &calls);
  EXPECT_EQ(
      db.code_of("SELECT count(*) FROM predictive_join(30000, 'ships') WHERE dt > 1e9 AND method = 'scan'"),
      SQLITE_INTERRUPT);
  EXPECT_GT(calls, 20);
  sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
}

}  // namespace
}  // namespace foresee::testing
