// INSERT INTO ships(ships) VALUES('rebuild' | 'optimize' | 'integrity-check').
#include "database.h"

namespace foresee::testing {
namespace {

struct TableCommands : ::testing::Test {
  TableCommands() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, +name);"
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000)"
        "INSERT INTO ships SELECT i, i % 37, i % 41, i FROM n");
  }

  std::string command(const std::string& word) {
    return db.error_of("INSERT INTO ships(ships) VALUES(" + word + ")");
  }
  std::string sums() {
    return db.rows("SELECT count(*), sum(x), sum(y), sum(name), sum(id = name) FROM ships");
  }

  Database db;
};

TEST_F(TableCommands, ChangeNoContents) {
  const std::string before = sums();
  for (const char* word : {"'rebuild'", "'optimize'", "'integrity-check'"}) {
    EXPECT_EQ(command(word), "") << word;
    EXPECT_EQ(sums(), before) << word;
  }
  db.exec("BEGIN; DELETE FROM ships WHERE id % 2");
  EXPECT_EQ(command("'rebuild'"), "");
  EXPECT_EQ(command("'integrity-check'"), "");
  db.exec("ROLLBACK");
  EXPECT_EQ(sums(), before);
  EXPECT_EQ(command("'integrity-check'"), "");
}

TEST_F(TableCommands, UnknownOnesAreToldTheKnown) {
  const std::string rest = "; known are 'rebuild', 'optimize' and 'integrity-check'";
  EXPECT_EQ(command("'vacuum'"), "ships: no command 'vacuum'" + rest);
  EXPECT_EQ(command("''"), "ships: no command ''" + rest);
  EXPECT_EQ(command("7"), "ships: no command 7" + rest);
  EXPECT_EQ(command("x'00'"), "ships: no command a blob of 1 bytes" + rest);
}

TEST_F(TableCommands, TheIntegrityCheckFindsABrokenNode) {
  db.exec(
      "UPDATE ships_node SET data = zeroblob(length(data)) WHERE rowid = (SELECT max(rowid) FROM "
      "ships_node)");
  EXPECT_EQ(db.code_of("INSERT INTO ships(ships) VALUES('integrity-check')"), SQLITE_CORRUPT_VTAB);
  EXPECT_EQ(command("'integrity-check'").substr(0, 7), "ships: ");
}

TEST_F(TableCommands, TheIntegrityCheckFindsALostRow) {
  db.exec("DELETE FROM ships_map WHERE rowid = 77");
  EXPECT_EQ(db.code_of("INSERT INTO ships(ships) VALUES('integrity-check')"), SQLITE_CORRUPT_VTAB);
  EXPECT_EQ(command("'rebuild'"), "");
  EXPECT_EQ(command("'integrity-check'"), "");
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 77"), "3.0");
}

}  // namespace
}  // namespace foresee::testing
