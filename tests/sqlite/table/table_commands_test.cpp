// Commands of a table: INSERT INTO ships(ships) VALUES('rebuild' | 'optimize' | 'integrity-check').
#include <memory>

#include "sqlite/database.h"

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

TEST_F(TableCommands, UnknownCommandsGiveAnErrorThatListsTheKnownOnes) {
  const std::string rest = "; known: 'rebuild', 'optimize' and 'integrity-check'";
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
  db.exec("DELETE FROM ships_map WHERE rowid = 64");
  EXPECT_EQ(db.code_of("INSERT INTO ships(ships) VALUES('integrity-check')"), SQLITE_CORRUPT_VTAB);
  EXPECT_EQ(command("'rebuild'"), "");
  EXPECT_EQ(command("'integrity-check'"), "");
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 77"), "3.0");
}

TEST_F(TableCommands, PragmaIntegrityCheckChecksTheTable) {
  EXPECT_EQ(db.rows("PRAGMA integrity_check"), "ok");
  db.exec("DELETE FROM ships_map WHERE rowid = 64");
  const std::string answer = db.rows("PRAGMA integrity_check");
  // SQLite calls the check of virtual tables since 3.44.
  EXPECT_EQ(answer.substr(0, answer.find(' ')), sqlite3_libversion_number() < 3044000 ? "ok" : "ships:")
      << answer;
}

TEST_F(TableCommands, PragmaIntegrityCheckNamesAMissingShadowTable) {
  if (sqlite3_libversion_number() < 3044000) GTEST_SKIP() << "SQLite calls no check of virtual tables";
  db.exec("DROP TABLE ships_map");
  EXPECT_EQ(db.rows("PRAGMA integrity_check"), "ships: no such table: main.ships_map");
}

// --- tables that cannot be read ----------------------------------------------------------------------------

struct UnreadableTable : ::testing::Test {
  /// A file with the table `ships`, damaged by `sql` and reopened.
  void damage(const std::string& sql) {
    {
      Database before(file.path());
      before.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, +name)");
      before.exec("INSERT INTO ships VALUES(1, 2, 'a'); " + sql);
    }
    db = std::make_unique<Database>(file.path());
  }
  void expect_droppable() {
    EXPECT_NE(db->error_of("INSERT INTO ships(x) VALUES(1)"), "");
    db->exec("BEGIN; DROP TABLE ships; COMMIT");
    EXPECT_EQ(db->rows("SELECT name FROM sqlite_schema"), "");
  }

  TemporaryFile file;
  std::unique_ptr<Database> db;
};

TEST_F(UnreadableTable, WithoutAnyOneOfItsShadowTablesCanBeDropped) {
  for (const char* suffix : {"node", "map", "aux", "meta"}) {
    damage(std::string("DROP TABLE ships_") + suffix);
    SCOPED_TRACE(suffix);
    expect_droppable();
  }
}

TEST_F(UnreadableTable, OfALaterFormatSaysSoAndCanBeDropped) {
  damage("UPDATE ships_meta SET value = 99 WHERE key = 'format'");
  for (const char* sql :
       {"SELECT * FROM ships", "SELECT * FROM ships WHERE id = 1", "INSERT INTO ships(x) VALUES(1)",
        "UPDATE ships SET x = 1", "DELETE FROM ships", "ALTER TABLE ships RENAME TO fleet",
        "INSERT INTO ships(ships) VALUES('integrity-check')", "SELECT * FROM predictive_position(1)"})
    EXPECT_NE(db->error_of(sql).find("stored in format '99'"), std::string::npos) << sql;
  expect_droppable();
}

}  // namespace
}  // namespace foresee::testing
