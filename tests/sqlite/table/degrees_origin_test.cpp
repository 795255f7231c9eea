// The origin that the first position of a table chooses: transactions, two connections, damage.
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* create_without_origin =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, lat, lon, speed, course, +name)";
constexpr const char* hamburg = "INSERT INTO ships VALUES (1, 53.54, 9.96, 5, 90, 'a')";
constexpr const char* boston = "INSERT INTO ships VALUES (2, 42.36, -71.04, 5, 90, 'b')";

struct DegreesOrigin : ::testing::Test {
  DegreesOrigin() { db.exec(create_without_origin); }

  /// The origin as the table shows it, and as it is stored.
  std::string origin() {
    return db.rows("SELECT origin, (SELECT value FROM ships_meta WHERE key = 'origin') FROM foresee_tables");
  }

  TemporaryFile file;
  Database db{file.path()};
};

TEST_F(DegreesOrigin, IsTheFirstPositionRoundedToATenthOfADegree) {
  EXPECT_EQ(origin(), "NULL|NULL");
  db.exec(hamburg);
  EXPECT_EQ(origin(), "53.5 10|53.5 10");
  EXPECT_EQ(db.rows("SELECT x, y FROM ships"),
            db.rows("SELECT x, y FROM geo_to_plane(53.54, 9.96, 5, 90, 53.5, 10)"));
  EXPECT_EQ(db.error_of(boston),
            "ships: lat, lon of row 2 are 42.36, -71.04: 5844 km from the origin '53.5 10', the limit is "
            "1500; create a table with a nearer "
            "origin, or with origin = globe");
  db.exec("DELETE FROM ships");
  EXPECT_EQ(origin(), "53.5 10|53.5 10") << "it is chosen once";
  EXPECT_EQ(Database(file.path()).rows("SELECT frame, origin, speed_unit, objects FROM foresee_tables"),
            "degrees|53.5 10|mps|0");
}

/// The planes of two tables whose first ships lie on the two sides of the date line have one name.
TEST_F(DegreesOrigin, OnTheDateLineIs180) {
  for (const char* lon : {"179.97", "-179.97", "180", "-180"}) {
    db.exec(std::string(
                "CREATE VIRTUAL TABLE fiji USING moving_objects(id, lat, lon); INSERT INTO fiji VALUES (1, "
                "-17.02, ") +
            lon + ")");
    EXPECT_EQ(db.rows("SELECT origin FROM foresee_tables WHERE name = 'fiji'"), "-17 180") << lon;
    db.exec("DROP TABLE fiji");
  }
}

TEST_F(DegreesOrigin, IsNotChosenByAStatementThatFails) {
  EXPECT_NE(db.error_of("INSERT INTO ships VALUES (1, 53.54, 9.96, 5, 400, 'a')"), "");
  EXPECT_NE(db.error_of("INSERT INTO ships VALUES (1, 53.54, 9.96, 5, 40, 'a'), (2, 95, 9, 5, 40, 'a')"), "");
  EXPECT_EQ(origin(), "NULL|NULL");
  db.exec("BEGIN");
  EXPECT_NE(db.error_of("INSERT INTO ships VALUES (1, 53.54, 9.96, 5, 40, 'a'), (1, 53.54, 9, 5, 40, 'a')"),
            "");
  EXPECT_EQ(origin(), "NULL|NULL");
  db.exec("INSERT OR FAIL INTO ships VALUES (7, 42.36, -71.04, 5, 40, 'a')");
  EXPECT_EQ(origin(), "42.4 -71|NULL") << "the commit writes it";
  db.exec("COMMIT");
  EXPECT_EQ(origin(), "42.4 -71|42.4 -71");
}

TEST_F(DegreesOrigin, IsRolledBackWithItsTransaction) {
  db.exec(std::string("BEGIN; ") + hamburg + "; ROLLBACK");
  EXPECT_EQ(origin(), "NULL|NULL");
  db.exec(std::string("BEGIN; ") + hamburg);
  EXPECT_EQ(db.rows("SELECT lat, lon FROM ships"), "53.54|9.96");
  db.exec("INSERT INTO ships(ships) VALUES('rebuild')");  // writes all rows
  EXPECT_EQ(origin(), "53.5 10|53.5 10");
  db.exec("ROLLBACK");
  EXPECT_EQ(origin(), "NULL|NULL");
  db.exec(boston);
  EXPECT_EQ(db.rows("SELECT lat, lon FROM ships"), "42.36|-71.04");
  EXPECT_EQ(origin(), "42.4 -71|42.4 -71");
}

TEST_F(DegreesOrigin, IsRolledBackToASavepoint) {
  for (const bool writes : {false, true}) {
    const std::string write = writes ? "; INSERT INTO ships(ships) VALUES('rebuild')" : "";
    db.exec("BEGIN; SAVEPOINT one");
    db.exec(hamburg + write);
    db.exec("SAVEPOINT two");
    db.exec("DELETE FROM ships" + write);
    db.exec("ROLLBACK TO two");
    EXPECT_EQ(origin(), writes ? "53.5 10|53.5 10" : "53.5 10|NULL");
    db.exec("ROLLBACK TO one");
    EXPECT_EQ(origin(), "NULL|NULL");
    db.exec(boston + write);
    EXPECT_EQ(db.rows("SELECT id, lat, lon FROM ships"), "2|42.36|-71.04");
    db.exec("SAVEPOINT three" + write + "; ROLLBACK TO three; COMMIT");
    EXPECT_EQ(origin(), "42.4 -71|42.4 -71");
    EXPECT_EQ(Database(file.path()).rows("SELECT id, lat, lon FROM ships"), "2|42.36|-71.04");
    db.exec(std::string("DROP TABLE ships; ") + create_without_origin);
  }
}

TEST_F(DegreesOrigin, IsWrittenWithoutObjects) {
  db.exec(std::string("BEGIN; ") + hamburg + "; DELETE FROM ships; COMMIT");
  EXPECT_EQ(origin(), "53.5 10|53.5 10");
  EXPECT_EQ(Database(file.path()).rows("SELECT origin, objects FROM foresee_tables"), "53.5 10|0");
}

TEST_F(DegreesOrigin, IsThatOfTheFirstConnection) {
  Database second(file.path());
  EXPECT_EQ(second.rows("SELECT count(*) FROM ships"), "0");
  db.exec(std::string("BEGIN; ") + hamburg);
  EXPECT_EQ(second.error_of(boston), "database is locked");
  db.exec("COMMIT");
  EXPECT_EQ(second.error_of(boston).substr(0, 22), "ships: lat, lon of row");
  second.exec("INSERT INTO ships VALUES (3, 54.1, 8.2, 5, 90, 'c')");
  EXPECT_EQ(second.rows("SELECT id, lat, lon FROM ships"), "1|53.54|9.96\n3|54.1|8.2");
  EXPECT_EQ(db.rows("SELECT id, lat, lon FROM ships"), "1|53.54|9.96\n3|54.1|8.2");
  db.exec("DROP TABLE ships");
  db.exec(create_without_origin);
  db.exec(boston);
  EXPECT_EQ(second.rows("SELECT id, lat, lon FROM ships"), "2|42.36|-71.04")
      << "another table of the same name";
}

TEST_F(DegreesOrigin, IsReadAgainByAnOldStatement) {
  Database second(file.path());
  sqlite3_stmt *insert = nullptr, *select = nullptr;
  sqlite3_prepare_v2(db.handle(), "INSERT INTO ships VALUES (NULL, ?, ?, 5, 90, 'c')", -1, &insert, nullptr);
  sqlite3_prepare_v2(db.handle(), "SELECT lat, lon, course FROM ships", -1, &select, nullptr);
  EXPECT_EQ(db.rows_of(select), "");
  sqlite3_reset(select);
  second.exec(hamburg);
  sqlite3_bind_double(insert, 1, 54.5);
  sqlite3_bind_double(insert, 2, 9.5);
  EXPECT_EQ(sqlite3_step(insert), SQLITE_DONE);
  sqlite3_reset(insert);
  EXPECT_EQ(db.rows_of(select), "53.54|9.96|90.0\n54.5|9.5|90.0");
  sqlite3_reset(select);
  EXPECT_EQ(origin(), "53.5 10|53.5 10");
  db.exec(std::string("ALTER TABLE ships RENAME TO boats; DELETE FROM boats; VACUUM"));
  EXPECT_EQ(db.rows("SELECT origin FROM foresee_tables"), "53.5 10");
  sqlite3_finalize(insert);
  sqlite3_finalize(select);
}

/// Random transactions beside an ordinary table that keeps the origin: SQLite rolls both back alike.
TEST_F(DegreesOrigin, FollowsEveryTransaction) {
  Random random(11);
  const auto place = [&] {
    return std::to_string(random.in(45, 48)) + ", " + std::to_string(random.in(7, 10));
  };
  for (int life = 0; life < 25; ++life) {
    db.exec("DROP TABLE IF EXISTS ships; DROP TABLE IF EXISTS model");
    db.exec(create_without_origin);
    db.exec("CREATE TABLE model(origin)");
    bool open = false;
    int savepoints = 0;
    for (int step = 0; step < 30; ++step) {
      const std::uint64_t choice = random.below(9);
      if (choice == 0) {
        db.exec(open ? (random.below(2) ? "COMMIT" : "ROLLBACK") : "BEGIN");
        open = !open, savepoints = 0;
      } else if (choice == 1 && open) {
        db.exec("SAVEPOINT s" + std::to_string(savepoints++));
      } else if (choice == 2 && savepoints > 0) {
        savepoints = static_cast<int>(random.below(static_cast<std::uint64_t>(savepoints))) + 1;
        db.exec("ROLLBACK TO s" + std::to_string(savepoints - 1));
      } else if (choice == 3 && savepoints > 0) {
        savepoints = static_cast<int>(random.below(static_cast<std::uint64_t>(savepoints)));
        db.exec("RELEASE s" + std::to_string(savepoints));
      } else if (choice == 4) {
        db.exec("DELETE FROM ships");
      } else if (choice == 5) {
        db.exec("INSERT INTO ships(ships) VALUES('rebuild')");
      } else if (choice == 6) {
        EXPECT_NE(db.error_of("INSERT INTO ships(lat, lon, speed) VALUES (" + place() + ", 0), (50, 400, 0)"),
                  "");
      } else {
        const std::string at = place();
        db.exec("INSERT INTO ships(lat, lon) VALUES (" + at + ")");
        db.exec(
            "INSERT INTO model SELECT rtrim(rtrim(printf('%.1f', column1), '0'), '.') || ' ' || "
            "rtrim(rtrim(printf('%.1f', column2), '0'), '.') FROM (VALUES (" +
            at + ")) WHERE NOT EXISTS (SELECT 1 FROM model)");
      }
      ASSERT_EQ(db.rows("SELECT origin FROM foresee_tables"), db.rows("SELECT (SELECT origin FROM model)"))
          << life;
      ASSERT_EQ(db.rows("SELECT count(*) FROM ships WHERE lat BETWEEN 44 AND 49 AND lon BETWEEN 6 AND 11"),
                db.rows("SELECT count(*) FROM ships"));
    }
    if (open) db.exec("COMMIT");
    ASSERT_EQ(db.rows("SELECT value FROM ships_meta WHERE key = 'origin'"),
              db.rows("SELECT origin FROM model"));
  }
}

TEST_F(DegreesOrigin, OfDamagedMetaIsCorruption) {
  db.exec(hamburg);
  for (const char* text : {"'x'", "''", "NULL", "7", "x'00ff'", "'91 0'", "'53.5'", "'nan nan'", "'1e999 0'",
                           "'53.5 10 ' || char(0)", "replace(hex(zeroblob(100000)), '0', '9')"}) {
    Database(file.path())
        .exec(std::string("PRAGMA writable_schema = 1; UPDATE ships_meta SET value = ") + text +
              " WHERE key = 'origin'; UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
    Database damaged(file.path());
    for (const char* sql :
         {"SELECT lat FROM ships", "UPDATE ships SET lat = 54", boston, "SELECT course FROM ships",
          "INSERT OR REPLACE INTO ships VALUES (1, 53.54, 9.96, 5, 90, 'a')"}) {
      EXPECT_EQ(damaged.code_of(sql), SQLITE_CORRUPT_VTAB) << text << ' ' << sql;
      EXPECT_EQ(damaged.error_of(sql).substr(0, 7), "ships: ") << damaged.error_of(sql);
    }
    EXPECT_EQ(damaged.rows("SELECT id, x IS NOT NULL FROM ships"), "1|1");
    EXPECT_EQ(damaged.rows("SELECT name, frame, origin FROM foresee_tables"), "ships|NULL|NULL");
    EXPECT_NE(damaged.error_of("INSERT INTO ships(ships) VALUES('integrity-check')"), "") << text;
  }
  Database(file.path()).exec("DROP TABLE ships");
}

TEST_F(DegreesOrigin, ThatIsDeclaredMustBeTheStoredOne) {
  db.exec(
      "CREATE VIRTUAL TABLE zones USING moving_objects(id, lat, lon, origin = '54 8');"
      "INSERT INTO zones VALUES (1, 54, 8); UPDATE zones_meta SET value = '54 9' WHERE key = 'origin'");
  Database again(file.path());
  EXPECT_EQ(again.error_of("SELECT * FROM zones"),
            "zones: stored with the origin '54 9' but declared with '54 8'");
  again.exec("DROP TABLE zones");
}

TEST_F(DegreesOrigin, RefusesPlacesThatNoTableStores) {
  db.exec(
      "CREATE VIRTUAL TABLE zones USING moving_objects(id, lat, lon, speed, course, origin = '54 8');"
      "CREATE VIRTUAL TABLE plain USING moving_objects(id, x, y, vx, vy);"
      "INSERT INTO plain VALUES (1, 1e9, 0, 0, 0), (2, 0, 0, 1.7e308, 1.7e308);"
      "DELETE FROM zones_node; INSERT INTO zones_node SELECT * FROM plain_node;"
      "DELETE FROM zones_map; INSERT INTO zones_map SELECT * FROM plain_map;"
      "UPDATE zones_meta SET value = (SELECT p.value FROM plain_meta p WHERE p.key = zones_meta.key) "
      "WHERE key IN ('root', 'stamp')");
  Database again(file.path());
  EXPECT_EQ(again.error_of("SELECT lat FROM zones WHERE id = 1"),
            "zones: object 1: x, y are 1000000000 m from the origin: the farthest place is at 20003931 m");
  EXPECT_EQ(again.code_of("SELECT lat FROM zones"), SQLITE_CORRUPT_VTAB);
  EXPECT_EQ(again.code_of("UPDATE zones SET lat = 54"), SQLITE_CORRUPT_VTAB);
  EXPECT_EQ(again.code_of("SELECT speed FROM zones WHERE id = 2"), SQLITE_CORRUPT_VTAB);
  again.exec("UPDATE zones SET lat = 54, lon = 8, speed = 1, course = 1 WHERE id = 99");
  again.exec("DELETE FROM zones WHERE id = 1");
}

}  // namespace
}  // namespace foresee::testing
