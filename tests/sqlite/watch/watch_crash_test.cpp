// kill -9 during commits that update a watch, many times on one file. The next process that opens the file
// finds the rows of the join. A reader from before continues to fold changes from its position.
#include "sanitized.h"
#include "sqlite/faults/killed_writer.h"
#include "sqlite/watch/watch_lives.h"
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

/// Random transactions, each of which also updates a row with its number.
[[noreturn]] void commit_until_killed(const std::string& path, const char* journal_mode,
                                      const WatchLife& life, unsigned seed, Announce announce) {
  sqlite3* db = nullptr;
  sqlite3_open(path.c_str(), &db);
  sqlite3_foresee_init(db, nullptr, nullptr);
  const auto run = [&](const std::string& sql) {
    if (sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) _exit(1);
  };
  run(std::string("PRAGMA journal_mode = ") + journal_mode + "; PRAGMA cache_size = 20");
  LifeScript script(life, seed);
  for (std::int64_t number = 1;; ++number) {
    const std::string time = std::to_string(seed * 10 + static_cast<unsigned>(number) % 10);
    run("BEGIN;" + script.changes(number % 4 == 0 ? 60 : 6));
    if (number % 3 == 0) run("INSERT INTO alerts(alerts, now) VALUES('advance', " + time + ")");
    run("UPDATE progress SET k = " + std::to_string(number) + "; COMMIT");
    announce(number);
  }
}

class WatchCrash : public ::testing::TestWithParam<const char*> {};

TEST_P(WatchCrash, LeavesTheJoinAndItsChanges) {
  for (const std::size_t i : {0U, 8U}) {  // one table; two
    const WatchLife& life = watch_lives()[i];
    const TemporaryFile file;
    {
      Database db(file.path());
      db.exec("PRAGMA page_size = 1024; CREATE TABLE progress(k); INSERT INTO progress VALUES (0);" +
              LifeScript(life, 0).tables());
    }
    WatchReader reader;
    for (unsigned seed = 1; seed <= (sanitized ? 4U : 12U) && !HasFailure(); ++seed) {
      Database(file.path()).exec("UPDATE progress SET k = 0");
      const std::int64_t announced = write_and_kill(seed, [&](Announce announce) {
        commit_until_killed(file.path(), GetParam(), life, seed, announce);
      });
      Database db(file.path());
      const std::string after = std::string(" of ") + life.name + " after kill " + std::to_string(seed);
      EXPECT_GE(std::stoll(db.rows("SELECT k FROM progress")), announced);
      expect_up_to_date(db, after);
      expect_joined(db, life.join, after);
      reader.read(db, after);
      if (!HasFailure()) reader.expect_rows(db, after);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(JournalModes, WatchCrash, ::testing::Values("delete", "wal"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace foresee::testing
