// File faults: every read, write and sync of a statement fails in turn, once or for good. Nothing crashes,
// and the statement fails or does its work. The next process that opens the file finds a sound table, as
// before the statement or as after it.
#include <filesystem>

#include "fault_steps.h"
#include "faulty_files.h"
#include "sanitized.h"
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

class FileFaults : public ::testing::TestWithParam<const char*> {
 protected:
  /// A file with a tree of several levels, in small pages.
  void SetUp() override {
    Database db(original_.path());
    db.exec("PRAGMA page_size = 512");
    db.exec(std::string("PRAGMA journal_mode = ") + GetParam());
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name);"
        "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 200)"
        "INSERT INTO ships SELECT i, i % 5, i * 37 % 100, i * 53 % 90, i % 7 - 3, i % 5 - 2, 0.5, 'n' || i "
        "FROM n");
    before_ = contents(db);
  }

  static std::string contents(Database& db) { return db.rows("SELECT * FROM ships ORDER BY id"); }

  void copy_original() const {
    for (const char* end : {"", "-journal", "-wal", "-shm"})
      std::filesystem::remove(original_.path("copy.db") + end);
    std::filesystem::copy_file(original_.path(), original_.path("copy.db"));
  }

  /// The contents of the table after `sql` without a fault.
  std::string done(const std::string& sql) const {
    copy_original();
    Database db(original_.path("copy.db"));
    db.exec(sql);
    return contents(db);
  }

  /// Runs `sql` with the nth operation failing, for n = 0, 1, … until no operation fails.
  void run(const std::string& sql) {
    const std::string after = done(sql);
    for (const FileFault fault : all_file_faults)
      for (const bool for_good : {false, true}) {
        long n = 0;
        while (disturbed(sql, after, fault, n, for_good) && !HasFailure()) n = next_fault(n);
      }
  }

  bool disturbed(const std::string& sql, const std::string& after, FileFault fault, long n, bool for_good) {
    copy_original();
    bool fired, failed;
    {
      Database db("file:" + original_.path("copy.db") + "?vfs=faulty");
      db.exec("PRAGMA cache_size = 4");
      db.exec("SELECT count(*) FROM sqlite_schema");
      files_.arm(fault, n, for_good);
      failed = !db.error_of(sql).empty();
      fired = files_.disarm();
      EXPECT_TRUE(fired || !failed) << sql;
      if (sqlite3_get_autocommit(db.handle()) == 0) db.error_of("ROLLBACK");
    }
    Database db(original_.path("copy.db"));
    db.exec("PRAGMA synchronous = OFF");
    const std::string found = contents(db);
    EXPECT_TRUE(found == after || (failed && found == before_))
        << sql << ": fault " << static_cast<int>(fault) << " at operation " << n;
    EXPECT_EQ(db.error_of("INSERT INTO ships(ships) VALUES('integrity-check')"), "") << sql;
    return fired;
  }

  TemporaryFile original_;
  FaultyFiles files_;
  std::string before_;
};

TEST_P(FileFaults, Insert) {
  run("INSERT INTO ships VALUES(1000, 9, 1, 1, 0, 0, 1, 'new'), (NULL, 9, 2, 2, 0, 0, 1, x'00')");
}

TEST_P(FileFaults, BulkLoad) {
  run("BEGIN; INSERT INTO ships SELECT id + 500, t + 1, x + 9, y, vx, vy, r, name FROM ships;"
      "INSERT INTO ships SELECT id + 5000, t, x, y - 9, vx, vy, r, name FROM ships WHERE id > 500; COMMIT");
}

TEST_P(FileFaults, Update) {
  run("UPDATE ships SET t = t + 10, x = x + 10 * vx, y = y + 10 * vy WHERE id % 3 = 0");
  run("BEGIN; UPDATE ships SET x = -x WHERE id = 7; SAVEPOINT a; UPDATE ships SET id = id + 1000 WHERE id < "
      "20;"
      "ROLLBACK TO a; UPDATE ships SET id = -id WHERE id > 190; COMMIT");
}

TEST_P(FileFaults, Delete) {
  run("DELETE FROM ships WHERE id % 4 <> 1");
  run("DELETE FROM ships");
}

TEST_P(FileFaults, Commands) {
  run("INSERT INTO ships(ships) VALUES('rebuild')");
  run("INSERT INTO ships(ships) VALUES('optimize')");
  run("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST_P(FileFaults, Queries) {
  run("SELECT * FROM ships");
  run("SELECT count(*) FROM predictive_join(10, 'ships')");
  run("SELECT * FROM predictive_position(10, 'ships')");
  run("SELECT * FROM predictive_track(0, 10, 5, 'ships')");
  run("SELECT * FROM predictive_sweep(10, 'ships')");
  run("SELECT count(*) FROM predictive_window(10, 'ships', 20, 60)");
  run("SELECT * FROM predictive_nearest(10, 'ships', 9, 50, 50)");
  run("SELECT * FROM predictive_avoid(10, 'ships', 5, 1)");
}

INSTANTIATE_TEST_SUITE_P(JournalModes, FileFaults, ::testing::Values("delete", "wal"),
                         [](const auto& info) { return std::string(info.param); });

/// A failed read makes SQLite roll back the whole transaction, so a statement or COMMIT that reads must report it.
struct FailedReads : ::testing::Test {
  FailedReads() {
    Database db(file.path());
    db.exec(
        "PRAGMA page_size = 512; PRAGMA synchronous = OFF; CREATE TABLE other(mark);"
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy);"
        "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 6000)"
        "INSERT INTO ships SELECT i, 0, i * 7919 % 10007, i * 104729 % 10009, 0, 0 FROM n");
  }

  std::string faulty() const { return "file:" + file.path() + "?vfs=faulty"; }

  TemporaryFile file;
  FaultyFiles files;
};

TEST_F(FailedReads, AtCommitLoseNoRowOfAnotherTable) {
  Database db(faulty());
  db.exec("PRAGMA synchronous = OFF; PRAGMA cache_size = 10");
  Random random(1);
  int failed = 0, committed = 0;
  for (int round = 0; round < (sanitized ? 120 : 300) && !HasFailure(); ++round) {
    const std::string mark = std::to_string(1000000 + round);
    Database(file.path()).exec("UPDATE ships SET x = x + 1 WHERE id = 7");  // so that nodes are read again
    db.exec("BEGIN IMMEDIATE");
    for (int i = 0; i < 100; ++i)
      db.exec("UPDATE ships SET x = x + 1, t = " + mark +
              " WHERE id = " + std::to_string(1 + (round * 100 + i) % 6000));
    db.exec("INSERT INTO other VALUES(" + mark + ")");
    files.arm(FileFault::read_fails, static_cast<long>(random.below(1600)), FaultyFiles::once);
    const bool fails = !db.error_of("COMMIT").empty();
    const bool fired = files.disarm();
    ++(fails ? failed : committed);
    EXPECT_EQ(fails, fired) << "an error that COMMIT does not report, or invents";
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("ROLLBACK");
    const std::string stored = fails ? "0|0" : "1|100";
    EXPECT_EQ(Database(file.path())
                  .rows("SELECT (SELECT count(*) FROM other WHERE mark = " + mark +
                        "), (SELECT count(*) FROM ships WHERE t = " + mark + ")"),
              stored)
        << "round " << round;
  }
  EXPECT_GT(failed, 20);
  EXPECT_GT(committed, 5);
}

TEST_F(FailedReads, InRebuildBesideAnOpenQueryAreErrors) {
  int failed = 0;
  for (long n = 0;; n = n + 1 + n / 4) {
    Database db(faulty());
    db.exec("PRAGMA synchronous = OFF; PRAGMA cache_size = 10; BEGIN; INSERT INTO other VALUES(1)");
    sqlite3_stmt* query = nullptr;
    ASSERT_EQ(sqlite3_prepare_v2(db.handle(), "SELECT id FROM predictive_window(9, 'ships', 0, 5000)", -1,
                                 &query, nullptr),
              SQLITE_OK);
    ASSERT_EQ(sqlite3_step(query), SQLITE_ROW);
    files.arm(FileFault::read_fails, n, FaultyFiles::once);
    const bool fails = !db.error_of("INSERT INTO ships(ships) VALUES('rebuild')").empty();
    const bool fired = files.disarm();
    EXPECT_EQ(fails, fired) << "at read " << n;
    EXPECT_EQ(sqlite3_get_autocommit(db.handle()) != 0, fails) << "at read " << n;
    sqlite3_finalize(query);
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("ROLLBACK");
    failed += fails;
    if (!fired || HasFailure()) break;
  }
  EXPECT_GT(failed, 10);
}

}  // namespace
}  // namespace foresee::testing
