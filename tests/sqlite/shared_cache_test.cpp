// Connections that share a cache: who reads uncommitted rows sees what is committed once it is.
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
  counts();  // what waits in the writer's memory is nowhere to be read
  writer.exec("INSERT INTO ships VALUES(3, 0); COMMIT");
  EXPECT_EQ(counts(), "3 3 3");
  writer.exec("BEGIN; DELETE FROM ships WHERE id = 1");
  counts();
  writer.exec("ROLLBACK");
  EXPECT_EQ(counts(), "3 3 3");
}

}  // namespace
}  // namespace foresee::testing
