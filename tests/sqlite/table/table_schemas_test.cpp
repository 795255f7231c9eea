// Schemas of a moving_objects table and operations on whole databases: ATTACH, temp, VACUUM, dump, views.
#include <sstream>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

const std::string three = "1|0.5|a\n2|1.5|b\n3|2.5|c";

void fill(Database& db, const std::string& table) {
  db.exec("CREATE VIRTUAL TABLE " + table + " USING moving_objects(id, x, +n TEXT)");
  db.exec("INSERT INTO " + table + " VALUES(1, 0.5, 'a'), (2, 1.5, 'b'), (3, 2.5, 'c')");
}

std::string contents(Database& db, const std::string& table) {
  return db.rows("SELECT * FROM " + table + " ORDER BY id");
}

TEST(TableSchemas, AttachedAndTemporary) {
  TemporaryFile file;
  Database db(file.path());
  db.exec("ATTACH '" + file.path("other.db") + "' AS other");
  fill(db, "main.ships");
  fill(db, "other.ships");
  fill(db, "temp.ships");
  db.exec("DELETE FROM other.ships WHERE id = 2; UPDATE temp.ships SET x = 9 WHERE id = 1");
  EXPECT_EQ(contents(db, "main.ships"), three);
  EXPECT_EQ(contents(db, "other.ships"), "1|0.5|a\n3|2.5|c");
  EXPECT_EQ(contents(db, "temp.ships"), "1|9.0|a\n2|1.5|b\n3|2.5|c");
  db.exec("BEGIN; DELETE FROM main.ships; DELETE FROM other.ships; ROLLBACK");
  EXPECT_EQ(contents(db, "other.ships"), "1|0.5|a\n3|2.5|c");
  db.exec("INSERT INTO other.ships(ships) VALUES('integrity-check')");
  db.exec("DETACH other");
  db.exec("ATTACH '" + file.path("other.db") + "' AS again");
  EXPECT_EQ(contents(db, "again.ships"), "1|0.5|a\n3|2.5|c");
}

TEST(TableSchemas, NamesThatNeedQuotes) {
  Database db;
  db.exec("ATTACH ':memory:' AS \"my \"\"db\"");
  for (std::string name : {"\"my ships\"", "\"it's\"", "\"say \"\"x\"\"\"", "\"select\"", "\"a.b\"",
                           "\"\xc3\xa9t\xc3\xa9\"", "\"50%w\""}) {
    const std::string table = "\"my \"\"db\"." + name;
    fill(db, table);
    EXPECT_EQ(contents(db, table), three) << name;
    db.exec("BEGIN; DELETE FROM " + table + "; ROLLBACK");
    db.exec("INSERT INTO " + table + "(" + name + ") VALUES('integrity-check'), ('rebuild')");
    db.exec("ALTER TABLE " + table + " RENAME TO \"new \"\"name\"");
    EXPECT_EQ(contents(db, "\"my \"\"db\".\"new \"\"name\""), three) << name;
    db.exec("DROP TABLE \"my \"\"db\".\"new \"\"name\"");
  }
  EXPECT_EQ(db.rows("SELECT count(*) FROM \"my \"\"db\".sqlite_schema"), "0");
}

TEST(TableSchemas, RenameMovesTheShadowTables) {
  Database db;
  fill(db, "ships");
  db.exec("ALTER TABLE ships RENAME TO fleet");
  EXPECT_EQ(contents(db, "fleet"), three);
  EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'ships%'"), "0");
  EXPECT_EQ(db.error_of("INSERT INTO fleet(id, x) VALUES(1, 1)"), "UNIQUE constraint failed: fleet.id");
  EXPECT_EQ(db.error_of("INSERT INTO fleet(id, x) VALUES(9, 'z')"),
            "fleet.x of row 9 is 'z': not a number; write a finite number");
  db.exec("INSERT INTO fleet(fleet) VALUES('optimize')");
}

TEST(TableSchemas, RenameToAColumnsNameIsRefused) {
  Database db;
  fill(db, "ships");
  EXPECT_NE(db.error_of("ALTER TABLE ships RENAME TO n"), "");
  EXPECT_NE(db.error_of("ALTER TABLE ships RENAME TO x"), "");
  EXPECT_EQ(contents(db, "ships"), three);
}

TEST(TableSchemas, DropLeavesNothing) {
  Database db;
  fill(db, "ships");
  db.exec("DROP TABLE ships");
  EXPECT_EQ(db.rows("SELECT name FROM sqlite_schema"), "");
}

TEST(TableSchemas, ADropDuringAScanIsRefused) {
  Database db;
  fill(db, "ships");
  sqlite3_stmt* scan = nullptr;
  sqlite3_prepare_v2(db.handle(), "SELECT * FROM ships", -1, &scan, nullptr);
  EXPECT_EQ(sqlite3_step(scan), SQLITE_ROW);
  EXPECT_EQ(db.code_of("DROP TABLE ships") & 0xff, SQLITE_LOCKED);
  sqlite3_finalize(scan);
  db.exec("DROP TABLE ships");
}

TEST(TableSchemas, VacuumAndVacuumInto) {
  TemporaryFile file;
  {
    Database db(file.path());
    fill(db, "ships");
    db.exec("DELETE FROM ships WHERE id = 2; VACUUM");
    EXPECT_EQ(contents(db, "ships"), "1|0.5|a\n3|2.5|c");
    db.exec("INSERT INTO ships VALUES(4, 4, 'd')");
    db.exec("VACUUM INTO '" + file.path("copy.db") + "'");
    db.exec("INSERT INTO ships VALUES(5, 5, 'e')");
    db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  }
  Database copy(file.path("copy.db"));
  EXPECT_EQ(contents(copy, "ships"), "1|0.5|a\n3|2.5|c\n4|4.0|d");
  copy.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(TableSchemas, VacuumNeedsNoResetOfStatements) {
  TemporaryFile file;
  Database db(file.path());
  fill(db, "ships");
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 2"), "1.5");
  db.exec("UPDATE ships SET x = 5 WHERE id = 2; VACUUM; PRAGMA journal_mode = WAL");
  EXPECT_EQ(db.rows("PRAGMA wal_checkpoint(TRUNCATE)"), "0|0|0");
  Database other(file.path());
  other.exec("UPDATE ships SET x = 6 WHERE id = 2; CREATE TABLE plain(a)");
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 2"), "6.0");
}

TEST(TableSchemas, ABackupIsACopy) {
  Database from, to;
  fill(from, "ships");
  sqlite3_backup* backup = sqlite3_backup_init(to.handle(), "main", from.handle(), "main");
  EXPECT_EQ(sqlite3_backup_step(backup, -1), SQLITE_DONE);
  sqlite3_backup_finish(backup);
  EXPECT_EQ(contents(to, "ships"), three);
  from.exec("UPDATE ships SET x = 0");
  backup = sqlite3_backup_init(to.handle(), "main", from.handle(), "main");
  EXPECT_EQ(sqlite3_backup_step(backup, -1), SQLITE_DONE);
  sqlite3_backup_finish(backup);
  EXPECT_EQ(to.rows("SELECT sum(x) FROM ships"), "0.0") << "what was read before the backup is not kept";
}

// --- protection --------------------------------------------------------------------------------------------

TEST(TableSafety, DefensiveModeProtectsTheShadowTables) {
  Database db;
  sqlite3_db_config(db.handle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  fill(db, "ships");
  db.exec("UPDATE ships SET x = 3 WHERE id = 1; INSERT INTO ships(ships) VALUES('rebuild')");
  for (std::string shadow : {"ships_node", "ships_map", "ships_aux", "ships_meta"})
    EXPECT_EQ(db.error_of("DELETE FROM " + shadow), "table " + shadow + " may not be modified");
  EXPECT_NE(db.error_of("DROP TABLE ships_node"), "");
  db.exec("ALTER TABLE ships RENAME TO fleet; DROP TABLE fleet");
}

TEST(TableSafety, DefensiveModeProtectsEachKindOfShadowTable) {
  Database db;
  sqlite3_db_config(db.handle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  db.exec(
      "CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y, shape, heading, plan, +n);"
      "INSERT INTO robots(id, shape, heading, plan) "
      "VALUES(1, 'POLYGON((0 0, 1 0, 0 1, 0 0))', 0, 'LINESTRING M(0 0 0, 4 0 9)')");
  std::istringstream names(db.rows("SELECT name FROM sqlite_schema WHERE name GLOB 'robots[_]*'"));
  int count = 0;
  for (std::string shadow; std::getline(names, shadow); ++count)
    EXPECT_EQ(db.error_of("DELETE FROM " + shadow), "table " + shadow + " may not be modified");
  EXPECT_EQ(count, 8);
  db.exec("INSERT INTO robots(robots) VALUES('integrity-check')");
}

TEST(TableSafety, ViewsAndTriggersMayUseItWithoutATrustedSchema) {
  Database db;
  db.exec("PRAGMA trusted_schema = OFF");
  fill(db, "ships");
  db.exec("CREATE VIEW v AS SELECT id, x FROM ships");
  EXPECT_EQ(db.rows("SELECT * FROM v ORDER BY id"), "1|0.5\n2|1.5\n3|2.5");
  db.exec(
      "CREATE TRIGGER w INSTEAD OF INSERT ON v BEGIN INSERT INTO ships(id, x) VALUES(new.id, new.x); END");
  db.exec("INSERT INTO v VALUES(4, 4)");
  EXPECT_EQ(db.rows("SELECT count(*) FROM v"), "4");
}

TEST(TableSafety, AReadOnlyDatabaseIsReadAndNotWritten) {
  TemporaryFile file;
  {
    Database db(file.path());
    fill(db, "ships");
  }
  Database db(file.path(), SQLITE_OPEN_READONLY);
  EXPECT_EQ(contents(db, "ships"), three);
  for (const char* write : {"INSERT INTO ships(x) VALUES(1)", "UPDATE ships SET x = 1", "DELETE FROM ships",
                            "INSERT INTO ships(ships) VALUES('rebuild')"})
    EXPECT_EQ(db.error_of(write), "attempt to write a readonly database") << write;
}

TEST(TableSafety, WrongDeclarationsLeaveNothing) {
  Database db;
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, hx, r)"),
            "ships: \"r\": a shape is either a box (hx) or round (r); leave one out");
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE ships USING moving_objects"),
            "ships: no columns are declared; write for example moving_objects(id, t, x, y, vx, vy, r)");
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE ships USING moving_objects()"),
            "ships: no columns are declared; write for example moving_objects(id, t, x, y, vx, vy, r)");
  EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema"), "0");
  fill(db, "ships");
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE ships USING moving_objects(id, x)"),
            "table ships already exists");
  db.exec("CREATE VIRTUAL TABLE IF NOT EXISTS ships USING moving_objects(id, x)");
  EXPECT_EQ(contents(db, "ships"), three);
}

TEST(TableSafety, ManyAuxiliaryColumns) {
  Database db;
  std::string columns = "id, x";
  for (int i = 0; i < 300; ++i) columns += ", +a" + std::to_string(i);
  db.exec("CREATE VIRTUAL TABLE wide USING moving_objects(" + columns + ")");
  db.exec("INSERT INTO wide(id, x, a0, a299) VALUES(1, 2, 'first', 'last')");
  EXPECT_EQ(db.rows("SELECT a0, a1, a299 FROM wide"), "first|NULL|last");
  for (int i = 300; i < 2100; ++i) columns += ", +a" + std::to_string(i);
  EXPECT_NE(db.error_of("CREATE VIRTUAL TABLE wider USING moving_objects(" + columns + ")"), "");
}

TEST(TableSafety, ADumpRestores) {
  // What the shell's .dump writes for a virtual table: its row of the schema, and the shadow tables.
  Database from, to;
  fill(from, "ships");
  to.exec("PRAGMA writable_schema = ON");
  const std::string schema = from.rows("SELECT sql FROM sqlite_schema WHERE name = 'ships'");
  to.exec(
      "BEGIN; INSERT INTO sqlite_schema(type, name, tbl_name, rootpage, sql) VALUES('table', 'ships', "
      "'ships', 0, '" +
      schema + "')");
  to.exec(
      from.rows("SELECT group_concat(sql, ';') FROM sqlite_schema WHERE name LIKE 'ships\\_%' ESCAPE '\\'"));
  for (std::string shadow : {"ships_node", "ships_map", "ships_aux", "ships_meta"}) {
    const std::string columns = from.rows(
        "SELECT group_concat('quote(' || name || ')', '||'',''||') FROM pragma_table_info('" + shadow + "')");
    const std::string values = from.rows("SELECT group_concat('(' || " + columns + " || ')') FROM " + shadow);
    if (values != "NULL") to.exec("INSERT INTO " + shadow + " VALUES" + values);
  }
  to.exec("PRAGMA writable_schema = RESET; COMMIT");
  EXPECT_EQ(contents(to, "ships"), three);
  to.exec("INSERT INTO ships VALUES(4, 4, 'd'); INSERT INTO ships(ships) VALUES('integrity-check')");
}

}  // namespace
}  // namespace foresee::testing
