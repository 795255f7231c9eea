// Connections with a shared cache: a reader of uncommitted rows sees the committed rows after the commit.
#include "database.h"

namespace foresee::testing {
namespace {

TEST(SharedCache, AReaderOfUncommittedRowsIsNotStaleAfterTheCommit) {
  TemporaryFile file;
  const std::string shared = "file:" + file.path() + "?cache=shared";
  Database writer(shared), reader(shared);
  writer.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, x); INSERT INTO ships VALUES(1, 0)");
  reader.exec("PRAGMA read_uncommitted = 1");
  const auto counts = [&] {
    return reader.rows("SELECT count(*) FROM ships") + " " +
           reader.rows("SELECT count(*) FROM predictive_join(1, 'ships', 10)") + " " +
           reader.rows("SELECT count(*) FROM predictive_window(1, 'ships')");
  };
  EXPECT_EQ(counts(), "1 0 1");
  writer.exec("BEGIN; INSERT INTO ships VALUES(2, 0)");
  counts();  // no reader sees the pending changes in the writer's memory
  writer.exec("INSERT INTO ships VALUES(3, 0); COMMIT");
  EXPECT_EQ(counts(), "3 3 3");
  writer.exec("BEGIN; DELETE FROM ships WHERE id = 1");
  counts();
  writer.exec("ROLLBACK");
  EXPECT_EQ(counts(), "3 3 3");
}

TEST(SharedCache, LookUpsOfUncommittedRowsLeaveNothingBehindAfterARollback) {
  TemporaryFile file;
  const std::string shared = "file:" + file.path() + "?cache=shared";
  Database writer(shared), reader(shared);
  writer.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x); CREATE TABLE list(id INTEGER PRIMARY KEY);"
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000)"
      "INSERT INTO ships SELECT i, i FROM n; INSERT INTO list SELECT id FROM ships");
  reader.exec("PRAGMA read_uncommitted = 1");
  const std::string sum = "SELECT sum(x) FROM list l CROSS JOIN ships s ON s.id = l.id";
  EXPECT_EQ(reader.rows(sum), "500500.0");
  for (const char* end : {"ROLLBACK", "COMMIT"}) {
    sqlite3_stmt* running = nullptr;
    sqlite3_prepare_v2(reader.handle(), "SELECT x FROM list l CROSS JOIN ships s ON s.id = l.id", -1,
                       &running, nullptr);
    EXPECT_EQ(sqlite3_step(running), SQLITE_ROW);
    // 'rebuild' and an INSERT without an id write before the end of the transaction.
    writer.exec(
        "BEGIN; UPDATE ships SET x = 0; INSERT INTO ships(ships) VALUES('rebuild');"
        "INSERT INTO ships(x) VALUES(0); UPDATE ships SET x = 1 WHERE id < 500");
    reader.rows(sum);
    while (sqlite3_step(running) == SQLITE_ROW) continue;
    writer.exec(end);
    sqlite3_finalize(running);
    EXPECT_EQ(reader.rows(sum), std::string(end) == "COMMIT" ? "499.0" : "500500.0");
  }
}

}  // namespace
}  // namespace foresee::testing
