// kill -9 during a bulk load or a series of updates: the next process that opens the file finds a sound
// table. The table holds every transaction whose COMMIT had returned, and no part of any other.
//
// The killed process writes the same rows to an ordinary table in the same transactions. Both tables must be
// equal afterwards.
#include "killed_writer.h"

namespace foresee::testing {
namespace {

/// An unbounded sequence of transactions, each announced after its COMMIT has returned.
[[noreturn]] void write_until_killed(const std::string& path, const char* journal_mode, std::uint64_t seed,
                                     Announce announce) {
  sqlite3* db = nullptr;
  sqlite3_open(path.c_str(), &db);
  sqlite3_foresee_init(db, nullptr, nullptr);
  Random random(seed);
  const auto run = [&](const std::string& sql) {
    if (sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) _exit(1);
  };
  const auto both = [&](const std::string& before, const std::string& after) {
    run(before + "ships" + after);
    run(before + "model" + after);
  };
  run(std::string("PRAGMA journal_mode = ") + journal_mode + "; PRAGMA cache_size = 20");
  for (std::int64_t number = 1;; ++number) {
    const std::string k = std::to_string(number), from = std::to_string(number * 100'000);
    run("BEGIN");
    const std::uint64_t many = random.below(4) == 0 ? 3000 : 30;
    both("WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " +
             std::to_string(1 + random.below(many)) + ") INSERT INTO ",
         " SELECT " + from + " + i, " + k +
             ", i * 37.5 % 1000, i * 53.25 % 900, i % 7 - 3, i % 5 - 2, 0.5 FROM n");
    const std::string some = std::to_string(3 + random.below(20));
    both("UPDATE ", " SET t = t + 1, x = x + vx, y = y + vy WHERE id % " + some + " = " + k + " % " + some);
    both("DELETE FROM ", " WHERE id % 11 = " + k + " % 11 AND id % 3 = 0");
    run("INSERT INTO progress VALUES(" + k + ")");
    run("COMMIT");
    announce(number);
  }
}

void expect_whole(const std::string& path, std::int64_t announced) {
  Database db(path);
  EXPECT_EQ(db.error_of("INSERT INTO ships(ships) VALUES('integrity-check')"), "");
  const std::string kept = db.rows("SELECT coalesce(max(k), 0) FROM progress");
  EXPECT_GE(std::stoll(kept), announced);
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), db.rows("SELECT count(*) FROM model"));
  EXPECT_EQ(db.rows("SELECT * FROM ships EXCEPT SELECT * FROM model LIMIT 3"), "");
}

class Crash : public ::testing::TestWithParam<const char*> {};

TEST_P(Crash, KeepsEveryCommittedTransactionAndNoHalfOne) {
  for (std::uint64_t seed = 1; seed <= 12 && !HasFailure(); ++seed) {
    TemporaryFile file;
    {
      Database db(file.path());
      db.exec(
          "PRAGMA page_size = 1024;"
          "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
          "CREATE TABLE model(id INTEGER PRIMARY KEY, t REAL, x REAL, y REAL, vx REAL, vy REAL, r REAL);"
          "CREATE TABLE progress(k)");
    }
    expect_whole(file.path(), write_and_kill(seed, [&](Announce announce) {
                   write_until_killed(file.path(), GetParam(), seed, announce);
                 }));
  }
}

INSTANTIATE_TEST_SUITE_P(JournalModes, Crash, ::testing::Values("delete", "wal"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace foresee::testing
