// Where outlines rest: shared by content, in one transaction with the rows that name them, checked when read.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* create_hulls =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, shape, heading, r);";

std::string square(int size) {
  const std::string s = std::to_string(size);
  return "POLYGON((0 0, " + s + " 0, " + s + " " + s + ", 0 " + s + ", 0 0))";
}

std::string insert_hull(int id, int size) {
  return "INSERT INTO ships(id, t, x, y, shape) VALUES(" + std::to_string(id) + ", 0, 0, 0, '" +
         square(size) + "');";
}

std::string stored_outlines(Database& db) {
  return db.rows("SELECT count(*) FROM ships_shape");
}

TEST(OutlineStorage, EqualContentIsStoredOnce) {
  Database db;
  db.exec(create_hulls);
  for (int id = 1; id <= 100; ++id) db.exec(insert_hull(id, id % 3 + 1));
  EXPECT_EQ(stored_outlines(db), "3");
  db.exec("INSERT INTO ships(id, t, x, y, shape) VALUES(999, 0, 0, 0, ' polygon((0 0,1 0,1 1,0 1.0,0 0))')");
  EXPECT_EQ(stored_outlines(db), "3");
  db.exec("UPDATE ships SET heading = id % 360");
  EXPECT_EQ(stored_outlines(db), "3");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(OutlineStorage, WhatIsTakenBackIsStoredAnewWhenItComesAgain) {
  Database db;
  db.exec(create_hulls);
  db.exec("BEGIN;" + insert_hull(1, 1) + "ROLLBACK;" + insert_hull(1, 1));
  EXPECT_EQ(stored_outlines(db), "1");
  db.exec("BEGIN;" + insert_hull(2, 2) + "SAVEPOINT a;" + insert_hull(3, 3) + "ROLLBACK TO a;" +
          insert_hull(4, 4) + insert_hull(3, 3) + "RELEASE a; COMMIT");
  EXPECT_EQ(db.rows("SELECT id, shape FROM ships ORDER BY id"),
            "1|" + square(1) + "\n2|" + square(2) + "\n3|" + square(3) + "\n4|" + square(4));
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(OutlineStorage, AStatementThatFailsLeavesNone) {
  Database db;
  db.exec(create_hulls + insert_hull(1, 1));
  db.exec("CREATE TABLE feed(id, shape)");
  db.exec("INSERT INTO feed VALUES(5, '" + square(5) + "'), (6, '" + square(6) + "'), (1, '" + square(7) +
          "')");
  const std::string all = " INTO ships(id, t, x, y, shape) SELECT id, 0, 0, 0, shape FROM feed";
  EXPECT_EQ(db.error_of("INSERT" + all), "UNIQUE constraint failed: ships.id");
  EXPECT_EQ(stored_outlines(db), "1");
  // The texts were read before: they must not be believed stored.
  db.exec("INSERT OR IGNORE" + all);
  EXPECT_EQ(db.rows("SELECT id, shape FROM ships ORDER BY id"),
            "1|" + square(1) + "\n5|" + square(5) + "\n6|" + square(6));
  db.exec("INSERT OR REPLACE" + all);
  EXPECT_EQ(db.rows("SELECT shape FROM ships WHERE id = 1"), square(7));
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(OutlineStorage, OptimizeAndRebuildDropWhatNoRowHas) {
  for (const char* command : {"optimize", "rebuild"}) {
    Database db;
    db.exec(create_hulls + insert_hull(1, 1) + insert_hull(2, 2) + insert_hull(3, 3));
    db.exec("UPDATE ships SET shape = NULL WHERE id = 2; DELETE FROM ships WHERE id = 3");
    EXPECT_EQ(stored_outlines(db), "3");
    db.exec("INSERT INTO ships(ships) VALUES('" + std::string(command) + "')");
    EXPECT_EQ(stored_outlines(db), "1");
    db.exec(insert_hull(3, 3) + insert_hull(4, 1));
    EXPECT_EQ(db.rows("SELECT shape FROM ships ORDER BY id"),
              square(1) + "\nNULL\n" + square(3) + "\n" + square(1));
    db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  }
}

TEST(OutlineStorage, AQuestionUnderWayKeepsItsOutlines) {
  Database db;
  db.exec(create_hulls);
  for (int id = 1; id <= 300; ++id) db.exec(insert_hull(id, id));
  sqlite3_stmt* window = nullptr;
  ASSERT_EQ(
      sqlite3_prepare_v2(db.handle(), "SELECT id FROM predictive_window(0, 'ships')", -1, &window, nullptr),
      SQLITE_OK);
  ASSERT_EQ(sqlite3_step(window), SQLITE_ROW);
  db.exec("DELETE FROM ships; INSERT INTO ships(ships) VALUES('optimize')");
  int rows = 1;
  while (sqlite3_step(window) == SQLITE_ROW) ++rows;
  EXPECT_EQ(sqlite3_finalize(window), SQLITE_OK) << sqlite3_errmsg(db.handle());
  EXPECT_EQ(rows, 300);
}

TEST(OutlineStorage, AQuestionUnderWayOutlivesARollback) {
  Database db;
  db.exec(std::string(create_hulls) + "BEGIN; SAVEPOINT q");
  for (int id = 1; id <= 1200; ++id) db.exec(insert_hull(id, id));
  sqlite3_stmt* window = nullptr;
  ASSERT_EQ(
      sqlite3_prepare_v2(db.handle(), "SELECT id FROM predictive_window(0, 'ships')", -1, &window, nullptr),
      SQLITE_OK);
  ASSERT_EQ(sqlite3_step(window), SQLITE_ROW);
  db.exec("ROLLBACK TO q; COMMIT");
  int rows = 1;
  while (sqlite3_step(window) == SQLITE_ROW) ++rows;
  EXPECT_EQ(sqlite3_finalize(window), SQLITE_OK) << sqlite3_errmsg(db.handle());
  EXPECT_EQ(rows, 1200);
}

TEST(OutlineStorage, TwoConnectionsGiveNumbersInTurn) {
  const TemporaryFile file;
  Database a(file.path()), b(file.path());
  a.exec("PRAGMA journal_mode = WAL;" + std::string(create_hulls) + insert_hull(1, 1));
  EXPECT_EQ(b.rows("SELECT shape FROM ships"), square(1));
  a.exec("BEGIN;" + insert_hull(2, 2) + "ROLLBACK");
  b.exec(insert_hull(3, 3));  // under the number that a took back
  EXPECT_EQ(a.rows("SELECT shape FROM ships ORDER BY id"), square(1) + "\n" + square(3));
  a.exec(insert_hull(2, 2));
  EXPECT_EQ(b.rows("SELECT shape FROM ships ORDER BY id"), square(1) + "\n" + square(2) + "\n" + square(3));
  b.exec("DELETE FROM ships WHERE id = 1; INSERT INTO ships(ships) VALUES('optimize');" + insert_hull(4, 4));
  a.exec(insert_hull(5, 1));
  EXPECT_EQ(a.rows("SELECT shape FROM ships ORDER BY id"),
            square(2) + "\n" + square(3) + "\n" + square(4) + "\n" + square(1));
  a.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

// What a took back is b's: a's memory of it must not be believed, read or turned.
TEST(OutlineStorage, ANumberThatWasTakenBackMayBeAnothers) {
  const TemporaryFile file;
  Database a(file.path()), b(file.path());
  a.exec("PRAGMA journal_mode = WAL;" + std::string(create_hulls));
  a.exec("BEGIN;" + insert_hull(2, 2) + "ROLLBACK");
  b.exec(insert_hull(3, 3));
  EXPECT_EQ(a.rows("SELECT id, shape FROM ships"), "3|" + square(3));
  a.exec("BEGIN;" + insert_hull(4, 4) + "ROLLBACK");
  b.exec(insert_hull(5, 5));
  a.exec("UPDATE ships SET heading = 90");
  a.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  EXPECT_EQ(a.rows("SELECT id FROM predictive_window(0, 'ships', 4, 5, -5, -4)"), "5");
}

TEST(OutlineStorage, GoesWhereTheTableGoes) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(create_hulls + insert_hull(1, 1));
    db.exec("ALTER TABLE ships RENAME TO fleet");
    db.exec("INSERT INTO fleet(id, t, x, y, shape) VALUES(2, 0, 0, 0, '" + square(2) + "')");
    db.exec(create_hulls + insert_hull(1, 3) + "VACUUM");  // the old name is free
    EXPECT_EQ(db.rows("SELECT shape FROM fleet ORDER BY id"), square(1) + "\n" + square(2));
    db.exec("DROP TABLE ships");
    EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'ships%'"), "0");
  }
  Database db;
  db.exec("ATTACH '" + file.path() + "' AS old");
  EXPECT_EQ(db.rows("SELECT shape FROM old.fleet ORDER BY id"), square(1) + "\n" + square(2));
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(0, 'fleet')"), "1|2");
}

TEST(OutlineStorage, IsRefusedByNameWhereItIsNotKnown) {
  Database db;
  db.exec(create_hulls);
  EXPECT_EQ(db.rows("SELECT value FROM ships_meta WHERE key = 'features'"), "blocks,shapes");
  db.exec("CREATE VIRTUAL TABLE plain USING moving_objects(id, x, y, r)");
  EXPECT_EQ(db.rows("SELECT value FROM plain_meta WHERE key = 'features'"), "blocks");
  EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema WHERE name = 'plain_shape'"), "0");
}

TEST(OutlineStorage, DamageIsSaidAndChangesNothing) {
  const std::string path_of_damage[][2] = {
      {"DELETE FROM ships_shape WHERE number = 1", "outline 1"},
      {"UPDATE ships_shape SET data = x'00' WHERE number = 1", "outline 1 is damaged: it is too short"},
      {"UPDATE ships_shape SET data = zeroblob(length(data)) WHERE number = 1",
       "outline 1 is damaged: its checksum is wrong"},
      {"UPDATE ships_shape SET data = 7 WHERE number = 1", "outline 1 is damaged: it is no blob"},
      {"UPDATE ships_shape SET hash = 3 WHERE number = 1", "outline 1 is damaged: its hash"},
      {"UPDATE ships_shape SET number = number + 10", "outline 1"},
  };
  for (const auto& [damage, words] : path_of_damage) {
    const TemporaryFile file;
    {
      Database db(file.path());
      db.exec(create_hulls + insert_hull(1, 1) + insert_hull(2, 2));
      db.exec(damage);
    }
    Database db(file.path());
    for (const char* statement :
         {"SELECT shape FROM ships", "SELECT * FROM predictive_join(9, 'ships')",
          "SELECT * FROM predictive_window(9, 'ships', 0)", "UPDATE ships SET heading = 45 WHERE id = 1",
          "INSERT INTO ships(ships) VALUES('integrity-check')"})
      EXPECT_NE(db.error_of(statement).find(words), std::string::npos)
          << damage << "; " << statement << ": " << db.error_of(statement);
    EXPECT_EQ(db.rows("SELECT count(*), sum(heading) FROM ships"), "2|0.0");
    db.exec(
        "UPDATE ships SET shape = NULL; INSERT INTO ships(ships) VALUES('rebuild');"
        "INSERT INTO ships(ships) VALUES('integrity-check')");
  }
}

TEST(OutlineStorage, NumbersBeyondWhatADoubleHoldsAreDamage) {
  Database db;
  db.exec(create_hulls + insert_hull(1, 1));
  for (const char* number : {"9223372036854775807", "9007199254740992", "-5", "0"}) {
    db.exec("UPDATE ships_shape SET number = " + std::string(number));
    EXPECT_NE(db.error_of(insert_hull(2, 2)).find("ships"), std::string::npos);
    EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "1");
  }
}

}  // namespace
}  // namespace foresee::testing
