// UPDATE and DELETE on moving_objects: changed columns and ids, and columns that keep every bit.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct TableUpdate : ::testing::Test {
  TableUpdate() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, until, +name TEXT, +photo "
        "BLOB);"
        "INSERT INTO ships VALUES(1, 0, -0.0, 0.1, 5e-324, 3, NULL, 'Argo', x'00ff'),"
        "                        (2, 10, 1, 2, 3, 4, 20, 'Beagle', NULL)");
  }

  std::string row(int id) { return db.rows("SELECT * FROM ships WHERE id = " + std::to_string(id)); }

  Database db;
};

TEST_F(TableUpdate, ColumnsThatAreNotSetKeepEveryBit) {
  db.exec("UPDATE ships SET t = 5 WHERE id = 1");
  EXPECT_EQ(row(1), "1|5.0|-0.0|0.1|5e-324|3.0|NULL|Argo|x'00ff'");
  db.exec("UPDATE ships SET t = t + 1");
  EXPECT_EQ(row(1), "1|6.0|-0.0|0.1|5e-324|3.0|NULL|Argo|x'00ff'");
  EXPECT_EQ(row(2), "2|11.0|1.0|2.0|3.0|4.0|20.0|Beagle|NULL");
}

TEST_F(TableUpdate, AuxiliaryColumnsChangeAlone) {
  db.exec("UPDATE ships SET name = upper(name)");
  EXPECT_EQ(row(1), "1|0.0|-0.0|0.1|5e-324|3.0|NULL|ARGO|x'00ff'");
  db.exec("UPDATE ships SET photo = 7, name = NULL WHERE id = 2");
  EXPECT_EQ(row(2), "2|10.0|1.0|2.0|3.0|4.0|20.0|NULL|7");
}

/// SQLite passes the numbers of row 2 as they were at the start, and no value for the columns that it leaves alone.
/// They would be those of row 1, which replaced it.
TEST_F(TableUpdate, RefusesAnObjectThatAnEarlierRowReplaced) {
  const std::string before = db.rows("SELECT * FROM ships ORDER BY id");
  for (const char* set : {"id = id + 1", "id = 3 - id", "id = 2", "rowid = id + 1"})
    EXPECT_EQ(
        db.error_of(std::string("UPDATE OR REPLACE ships SET ") + set),
        "ships: row 2 was replaced by an earlier row of this UPDATE; write DELETE first, or ids that no "
        "row has")
        << set;
  EXPECT_EQ(db.rows("SELECT * FROM ships ORDER BY id"), before);
  // Another statement, or ids that are free by then, are no conflict.
  db.exec(
      "UPDATE OR REPLACE ships SET id = 2 WHERE id = 1; UPDATE OR REPLACE ships SET id = id + 1, y = y + 1");
  EXPECT_EQ(db.rows("SELECT id, name FROM ships"), "3|Argo");
  db.exec("UPDATE OR REPLACE ships SET id = id - 1; UPDATE OR REPLACE ships SET id = id - 1");
  EXPECT_EQ(db.rows("SELECT id, y, name FROM ships"), "1|1.1|Argo");
}

TEST_F(TableUpdate, AMotionUpdateDoesNotTouchTheAuxiliaryTable) {
  // The auxiliary shadow table refuses every write: only an UPDATE that leaves it alone gets through.
  sqlite3_set_authorizer(
      db.handle(),
      [](void*, int action, const char* table, const char*, const char*, const char*) {
        const bool writes = action == SQLITE_UPDATE || action == SQLITE_INSERT || action == SQLITE_DELETE;
        return writes && std::string(table) == "ships_aux" ? SQLITE_DENY : SQLITE_OK;
      },
      nullptr);
  db.exec("UPDATE ships SET x = 9, y = 8");
  sqlite3_set_authorizer(db.handle(), nullptr, nullptr);
  EXPECT_EQ(row(1), "1|0.0|9.0|8.0|5e-324|3.0|NULL|Argo|x'00ff'");
}

TEST_F(TableUpdate, AnIdChangesWithAllItsColumns) {
  db.exec("UPDATE ships SET id = 100 WHERE id = 1");
  EXPECT_EQ(row(1), "");
  EXPECT_EQ(row(100), "100|0.0|-0.0|0.1|5e-324|3.0|NULL|Argo|x'00ff'");
  db.exec("UPDATE ships SET rowid = -5, name = 'Endeavour' WHERE name = 'Beagle'");
  EXPECT_EQ(row(-5), "-5|10.0|1.0|2.0|3.0|4.0|20.0|Endeavour|NULL");
  db.exec("UPDATE ships SET id = id");
  EXPECT_EQ(db.rows("SELECT id FROM ships ORDER BY id"), "-5\n100");
}

TEST_F(TableUpdate, IdsShiftThroughOneAnother) {
  db.exec("INSERT INTO ships(id, t, x, y) VALUES(3, 0, 3, 3)");
  db.exec("UPDATE ships SET id = id + 10");
  EXPECT_EQ(db.rows("SELECT id, name FROM ships ORDER BY id"), "11|Argo\n12|Beagle\n13|NULL");
}

TEST_F(TableUpdate, AnIdIsNeverNullNorText) {
  EXPECT_EQ(db.error_of("UPDATE ships SET id = NULL WHERE id = 1"),
            "ships.id of row 1 would become NULL: every object has an id; write an INTEGER");
  EXPECT_EQ(db.error_of("UPDATE ships SET id = 'abc' WHERE id = 1"),
            "ships.id of row 1 is 'abc': not an integer; write an INTEGER, not NULL");
  EXPECT_EQ(db.error_of("UPDATE ships SET id = id + 0.5 WHERE id = 2"),
            "ships.id of row 2 is 2.5: not an integer; write an INTEGER, not NULL");
  EXPECT_EQ(db.code_of("UPDATE ships SET id = 'abc' WHERE id = 1"), SQLITE_MISMATCH);
  EXPECT_EQ(db.code_of("UPDATE ships SET id = NULL WHERE id = 1"), SQLITE_MISMATCH);
}

TEST_F(TableUpdate, CommandsAreGivenByInsert) {
  EXPECT_EQ(db.error_of("UPDATE ships SET ships = 'rebuild'"),
            "ships.ships takes commands by INSERT only; write INSERT INTO ships(ships) VALUES('rebuild')");
}

TEST_F(TableUpdate, FromAnotherTable) {
  db.exec("CREATE TABLE news(id, x); INSERT INTO news VALUES(1, 50), (2, 60)");
  db.exec("UPDATE ships SET x = news.x FROM news WHERE news.id = ships.id");
  EXPECT_EQ(db.rows("SELECT id, x, y, name FROM ships ORDER BY id"), "1|50.0|0.1|Argo\n2|60.0|2.0|Beagle");
}

TEST_F(TableUpdate, ChangesAreCounted) {
  db.exec("UPDATE ships SET x = 1");
  EXPECT_EQ(sqlite3_changes(db.handle()), 2);
  db.exec("DELETE FROM ships WHERE id = 2");
  EXPECT_EQ(sqlite3_changes(db.handle()), 1);
  db.exec("DELETE FROM ships WHERE id = 2");
  EXPECT_EQ(sqlite3_changes(db.handle()), 0);
}

TEST_F(TableUpdate, ADeletedIdIsFreeAgain) {
  db.exec("DELETE FROM ships WHERE id = 1; INSERT INTO ships(id, t, x, y) VALUES(1, 0, 7, 7)");
  EXPECT_EQ(row(1), "1|0.0|7.0|7.0|0.0|0.0|NULL|NULL|NULL");
  db.exec("DELETE FROM ships");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships_aux"), "0");
}

TEST_F(TableUpdate, TriggersOfOtherTablesWrite) {
  db.exec(
      "CREATE TABLE reports(ship, x);"
      "CREATE TRIGGER move AFTER INSERT ON reports BEGIN UPDATE ships SET x = new.x WHERE id = new.ship; END;"
      "INSERT INTO reports SELECT id, x + 100 FROM ships");
  EXPECT_EQ(db.rows("SELECT id, x FROM ships ORDER BY id"), "1|100.0\n2|101.0");
}

}  // namespace
}  // namespace foresee::testing
