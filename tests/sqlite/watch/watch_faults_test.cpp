// Every write and sync of a commit that a watch settles fails in turn; a trigger on a shadow table fails it;
// it is interrupted. The commit fails whole or does its work: table, pairs and changes always belong
// together.
#include <filesystem>

#include "sqlite/database.h"
#include "sqlite/fault_steps.h"
#include "sqlite/faulty_files.h"

namespace foresee::testing {
namespace {

constexpr const char* objects =
    "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 60)"
    "INSERT INTO ships SELECT i, i % 5, i * 37 % 100, i * 53 % 90, i % 7 - 3, i % 5 - 2, 0.5 FROM n";

std::string contents(Database& db) {
  return db.rows("SELECT * FROM ships ORDER BY id") + "\n" + db.rows("SELECT * FROM alerts_log") + "\n" +
         db.rows("SELECT a, b, t FROM alerts_pair WHERE state = 1");
}

void expect_up_to_date(Database& db) {
  EXPECT_EQ(db.rows("SELECT fault FROM predictive_watches"), "NULL");
  EXPECT_EQ(db.error_of("INSERT INTO alerts(alerts) VALUES('integrity-check')"), "");
}

TEST(WatchFaults, FilesThatFailLeaveTheCommitWholeOrNotAtAll) {
  TemporaryFile file;
  FaultyFiles files;
  {
    Database db(file.path());
    db.exec(
        "PRAGMA page_size = 512; CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r)");
    db.exec(objects);
    db.exec("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 10, within = 3)");
  }
  const std::string copy = file.path("copy.db");
  const auto copy_original = [&] {
    for (const char* end : {"", "-journal"}) std::filesystem::remove(copy + end);
    std::filesystem::copy_file(file.path(), copy);
  };
  const std::string sql =
      "BEGIN; UPDATE ships SET t = 9, x = x + 5 WHERE id % 9 = 1; DELETE FROM ships WHERE id = 7; COMMIT";
  std::string before, after;
  copy_original();
  {
    Database db(copy);
    before = contents(db);
    db.exec(sql);
    after = contents(db);
  }
  for (const FileFault fault : all_file_faults) {
    bool fired = true;
    for (long n = 0; fired && !::testing::Test::HasFailure(); n = next_fault(n)) {
      copy_original();
      bool failed;
      {
        Database db("file:" + copy + "?vfs=faulty");
        db.exec("PRAGMA cache_size = 4; SELECT count(*) FROM sqlite_schema");
        files.arm(fault, n, false);
        failed = !db.error_of(sql).empty();
        fired = files.disarm();
        if (sqlite3_get_autocommit(db.handle()) == 0) db.error_of("ROLLBACK");
      }
      Database db(copy);
      db.exec("PRAGMA synchronous = OFF");
      const std::string found = contents(db);
      EXPECT_TRUE(found == after || (failed && found == before)) << "fault at operation " << n;
      expect_up_to_date(db);
    }
  }
}

struct WatchCommit : ::testing::Test {
  WatchCommit() {
    db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r)");
    db.exec(objects);
    db.exec("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 10, within = 3)");
  }

  Database db;
};

TEST_F(WatchCommit, FailsWholeWhereAShadowTableRefuses) {
  const std::string before = contents(db);
  for (const char* event :
       {"INSERT ON alerts_log", "UPDATE ON alerts_pair", "INSERT ON alerts_pair", "INSERT ON alerts_meta"}) {
    db.exec(std::string("CREATE TRIGGER forbid BEFORE ") + event +
            " BEGIN SELECT raise(ABORT, 'forbidden'); END");
    db.error_of("UPDATE ships SET x = x + 5 WHERE id % 9 = 1");
    EXPECT_EQ(contents(db), before) << event;
    db.exec("DROP TRIGGER forbid");
    expect_up_to_date(db);
  }
  db.exec("UPDATE ships SET x = x + 5 WHERE id % 9 = 1");
  EXPECT_NE(contents(db), before);
  expect_up_to_date(db);
}

TEST_F(WatchCommit, FailsWholeWhereItIsInterrupted) {
  const std::string before = contents(db);
  bool stopped = true;
  for (int steps = 1; stopped && !HasFailure(); steps += 1 + steps / 4) {
    int left = steps;
    db.exec("BEGIN; UPDATE ships SET x = x + 5 WHERE id % 9 = 1");
    sqlite3_progress_handler(
        db.handle(), 1, [](void* count) { return --*static_cast<int*>(count) < 0 ? 1 : 0; }, &left);
    const std::string error = db.error_of("COMMIT");
    sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
    stopped = !error.empty();
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("ROLLBACK");
    if (stopped) {
      EXPECT_EQ(contents(db), before) << steps;
    }
    expect_up_to_date(db);
  }
  EXPECT_NE(contents(db), before);
}

}  // namespace
}  // namespace foresee::testing
