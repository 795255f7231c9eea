// Random sequences of changes to watched tables: after every commit the rows are those of predictive_join,
// bit for bit in all nine columns. Folding the changes gives the same rows, for a reader after each commit, a
// reader after few commits, and readers that start late. FORESEE_LONG=1 runs eight sequences of each kind:
// some 24,000 commits.
#include <cstdlib>

#include "sanitized.h"
#include "sqlite/faults/faulty_files.h"
#include "sqlite/watch/watch_lives.h"
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

const unsigned seeds = std::getenv("FORESEE_LONG") ? 8 : 1;
constexpr int commits = sanitized ? 20 : 120;

class WatchLives : public ::testing::TestWithParam<WatchLife> {
 protected:
  void expect_all(Database& db, const std::string& after) {
    expect_joined(db, GetParam().join, after);
    if (!HasFatalFailure()) each_.read(db, after);
    if (!HasFatalFailure()) each_.expect_rows(db, after);
    if (!HasFatalFailure()) each_.expect_whole(db, after);
    if (random_() % 8 == 0) late_ = WatchReader(GetParam().tolerance);
    if (!HasFatalFailure()) late_.read(db, after);
    if (!HasFatalFailure()) late_.expect_rows(db, after);
    if (HasFatalFailure() || random_() % 20 > 0) return;
    seldom_.read(db, after);
    if (!HasFatalFailure()) seldom_.expect_rows(db, after);
    if (!HasFatalFailure()) expect_up_to_date(db, after);
  }

  /// The clock is never before a report that moves it, and only 'advance' moves it back.
  void expect_clock(Database& db, const std::string& sql) {
    const double now = std::stod(db.rows("SELECT now FROM predictive_watches"));
    if (sql.find("'advance'") == std::string::npos) {
      ASSERT_GE(now, clock_) << sql;
    }
    clock_ = now;
    const std::string options = GetParam().options;
    if (options.find("manual") != std::string::npos || options.find("ahead") != std::string::npos) return;
    if (std::string(GetParam().columns).starts_with("t, ")) {
      ASSERT_EQ(db.rows("SELECT count(*) FROM ships WHERE t > " + std::to_string(now)), "0") << sql;
    }
  }

  WatchReader each_{GetParam().tolerance}, seldom_{GetParam().tolerance};
  WatchReader late_{GetParam().tolerance};  ///< starts again and again with since = 0
  std::mt19937 random_;
  double clock_ = -1e300;
};

TEST_P(WatchLives, EqualTheJoinAndTheFoldedChanges) {
  for (unsigned seed = 1; seed <= seeds && !HasFatalFailure(); ++seed) {
    const TemporaryFile file;
    LifeScript script(GetParam(), seed);
    each_ = seldom_ = late_ = WatchReader(GetParam().tolerance);
    clock_ = -1e300;
    const auto open = [&] {
      auto opened = std::make_unique<Database>(file.path());
      opened->exec("PRAGMA synchronous = OFF");
      return opened;
    };
    auto db = open();
    db->exec(script.tables());
    for (int commit = 0; commit < commits && !HasFatalFailure(); ++commit) {
      const std::string sql = script.next();
      const std::string after =
          " after commit " + std::to_string(commit) + " of life " + std::to_string(seed) + ": " + sql;
      if (script.below(12) == 0)  // by another connection
        open()->exec(sql);
      else
        db->exec(sql);
      if (script.below(15) == 0) db = open();
      expect_all(*db, after);
      if (!HasFatalFailure()) expect_clock(*db, sql);
    }
    db->exec("BEGIN;" + script.changes(9));
    expect_joined(*db, GetParam().join, " in a transaction");
    db->exec("ROLLBACK");
  }
}

/// About every other commit has a file fault or an interrupt.
TEST_P(WatchLives, GoOnAfterCommitsThatFail) {
  constexpr int fewer = sanitized ? 20 : 50;
  int failures = 0;
  for (unsigned seed = 1; seed <= seeds && !HasFatalFailure(); ++seed) {
    const TemporaryFile file;
    FaultyFiles files;
    LifeScript script(GetParam(), 100 + seed);
    each_ = seldom_ = late_ = WatchReader(GetParam().tolerance);
    const std::string name = "file:" + file.path() + "?vfs=faulty";
    auto db = std::make_unique<Database>(name);
    db->exec(std::string("PRAGMA journal_mode = ") + (seed % 2 ? "delete;" : "wal;") + script.tables());
    for (int commit = 0; commit < fewer && !HasFatalFailure(); ++commit) {
      const std::string sql = script.next();
      int left = script.below(4) == 0 ? script.below(2000) : 1'000'000'000;
      if (script.below(2)) files.arm(all_file_faults[script.below(6)], script.below(30), script.below(2));
      sqlite3_progress_handler(
          db->handle(), 1, [](void* count) { return --*static_cast<int*>(count) < 0 ? 1 : 0; }, &left);
      const bool failed = !db->error_of(sql).empty();
      files.disarm();
      sqlite3_progress_handler(db->handle(), 0, nullptr, nullptr);
      failures += failed;
      if (sqlite3_get_autocommit(db->handle()) == 0) db->error_of("ROLLBACK");
      if (failed && script.below(2)) db = std::make_unique<Database>(name);
      expect_all(*db, " after commit " + std::to_string(commit) + " of life " + std::to_string(seed) +
                          (failed ? ", which failed: " : ": ") + sql);
    }
  }
  EXPECT_GT(failures, 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, WatchLives, ::testing::ValuesIn(watch_lives()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace foresee::testing
