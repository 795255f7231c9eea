// Faults in every step of a watch's life: each read, write and sync fails in turn, a trigger on a shadow
// table fails the commit, an interrupt ends it. The step fails as a whole or does its work: table, pairs and
// changes always agree.
#include <filesystem>

#include "sqlite/faults/fault_steps.h"
#include "sqlite/faults/faulty_files.h"
#include "sqlite/watch/watch_steps.h"

namespace foresee::testing {
namespace {

struct FaultySteps {
  WatchStep step;
  const char* journal_mode;
};

/// Alternates between the two journal modes.
std::vector<FaultySteps> all_faulty_steps() {
  std::vector<FaultySteps> all;
  bool wal = false;
  for (const WatchStep& step : watch_steps) {
    all.push_back({step, wal ? "wal" : "delete"});
    wal = !wal;
    if (every_fault) all.push_back({step, wal ? "wal" : "delete"});
  }
  return all;
}

class WatchFileFaults : public ::testing::TestWithParam<FaultySteps> {
 protected:
  static constexpr int objects = 40;

  void SetUp() override {
    Database db(original_.path());
    db.exec(std::string("PRAGMA page_size = 512; PRAGMA journal_mode = ") + GetParam().journal_mode);
    db.exec(objects_to_watch(objects) + GetParam().step.before);
    before_ = all_of_watch(db);
  }

  void copy_original() const {
    for (const char* end : {"", "-journal", "-wal", "-shm"}) std::filesystem::remove(copy_ + end);
    std::filesystem::copy_file(original_.path(), copy_);
  }

  std::string done() const {
    copy_original();
    Database db(copy_);
    db.exec(GetParam().step.sql);
    return all_of_watch(db);
  }

  /// False if no operation failed.
  bool disturbed(const std::string& after, FileFault fault, long n, bool for_good) {
    copy_original();
    bool fired, failed;
    {
      Database db("file:" + copy_ + "?vfs=faulty");
      db.exec("PRAGMA cache_size = 4; SELECT count(*) FROM sqlite_schema");
      files_.arm(fault, n, for_good);
      failed = !db.error_of(GetParam().step.sql).empty();
      fired = files_.disarm();
      EXPECT_TRUE(fired || !failed);
      if (sqlite3_get_autocommit(db.handle()) == 0) db.error_of("ROLLBACK");
    }
    Database db(copy_);
    db.exec("PRAGMA synchronous = OFF");
    const std::string found = all_of_watch(db);
    EXPECT_TRUE(found == after || (failed && found == before_))
        << "fault " << static_cast<int>(fault) << " at operation " << n;
    expect_watches_are_sound(db);
    return fired;
  }

  TemporaryFile original_;
  const std::string copy_ = original_.path("copy.db");
  FaultyFiles files_;
  std::string before_;
};

TEST_P(WatchFileFaults, LeaveTheStepUndoneOrDone) {
  const std::string after = done();
  for (const FileFault fault : all_file_faults) {
    long n = 0;
    while (disturbed(after, fault, n, n % 2 == 1) && !HasFailure()) {
      if (every_fault) disturbed(after, fault, n, n % 2 == 0);
      n = next_fault_of_many(n);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, WatchFileFaults, ::testing::ValuesIn(all_faulty_steps()),
                         [](const auto& info) {
                           return std::string(info.param.step.name) + "_" + info.param.journal_mode;
                         });

struct WatchCommit : ::testing::Test {
  WatchCommit() { db.exec(objects_to_watch(60) + create_alerts); }

  Database db;
};

TEST_F(WatchCommit, FailsWholeWhereAShadowTableRefuses) {
  const std::string before = all_of_watch(db);
  for (const char* event : {"INSERT ON alerts_log", "UPDATE ON alerts_pair", "INSERT ON alerts_pair",
                            "INSERT ON alerts_back", "INSERT ON alerts_due", "INSERT ON alerts_meta"}) {
    db.exec(std::string("CREATE TRIGGER forbid BEFORE ") + event +
            " BEGIN SELECT raise(ABORT, 'forbidden'); END");
    EXPECT_NE(db.error_of("UPDATE ships SET t = 6, x = x + 5 WHERE id % 9 = 1"), "") << event;
    db.exec("DROP TRIGGER forbid");
    EXPECT_EQ(all_of_watch(db), before) << event;
    expect_watches_are_sound(db);
  }
  db.exec("UPDATE ships SET x = x + 5 WHERE id % 9 = 1");
  EXPECT_NE(all_of_watch(db), before);
  expect_watches_are_sound(db);
}

TEST_F(WatchCommit, FailsWholeWhereItIsInterrupted) {
  const std::string before = all_of_watch(db);
  bool stopped = true;
  int stops = 0;
  for (int steps = 1; stopped && !HasFailure(); steps += 1 + steps / 4) {
    int left = steps;
    db.exec("BEGIN; UPDATE ships SET x = x + 5 WHERE id % 9 = 1");
    sqlite3_progress_handler(
        db.handle(), 1, [](void* count) { return --*static_cast<int*>(count) < 0 ? 1 : 0; }, &left);
    stopped = !db.error_of("COMMIT").empty();
    sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
    stops += stopped;
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("ROLLBACK");
    if (stopped) {
      EXPECT_EQ(all_of_watch(db), before) << steps;
    }
    expect_watches_are_sound(db);
  }
  EXPECT_GT(stops, 5);
  EXPECT_NE(all_of_watch(db), before);
}

}  // namespace
}  // namespace foresee::testing
