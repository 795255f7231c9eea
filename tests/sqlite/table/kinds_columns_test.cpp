// Columns category and mask: their values and refusals, their place in a declaration, and what reads them back after
// changes, rollbacks, commands and from a file.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* create =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, category, mask, +name TEXT)";

/// What `column` reads back after an INSERT of `value`, or the error.
std::string stored(Database& db, const std::string& column, const std::string& value) {
  db.exec("DELETE FROM ships; INSERT INTO ships(id, x) VALUES(7, 1)");
  const std::string error =
      db.error_of("INSERT OR REPLACE INTO ships(id, x, " + column + ") VALUES(7, 2, " + value + ")");
  if (!error.empty()) {
    EXPECT_EQ(db.rows("SELECT * FROM ships"), "7|1.0|1|4294967295|NULL") << "a refused value changed it";
    return error;
  }
  return db.rows("SELECT " + column + " FROM ships");
}

TEST(KindsColumns, TakeWholeNumbersOf32Bits) {
  Database db;
  db.exec(create);
  for (const std::string column : {"category", "mask"}) {
    for (const char* seven : {"7", "7.0", "'7'", "' 7.0 '", "'7e0'"})
      EXPECT_EQ(stored(db, column, seven), "7") << seven;
    for (const char* zero : {"0", "-0.0", "'0'"}) EXPECT_EQ(stored(db, column, zero), "0") << zero;
    EXPECT_EQ(stored(db, column, "4294967295"), "4294967295");
    for (const char* null : {"NULL", "''"})
      EXPECT_EQ(stored(db, column, null), column == "mask" ? "4294967295" : "1") << null;
    const auto refused = [&](const std::string& value, const std::string& shown) {
      EXPECT_EQ(stored(db, column, value),
                "ships." + column + " of row 7 is " + shown +
                    ": not 32 bits; write a whole number from 0 to 4294967295, or NULL");
    };
    for (const char* value : {"-1", "4294967296", "1.5", "'all'", "9223372036854775807"})
      refused(value, value);
    refused("'1.5'", "1.5"), refused("'-1'", "-1");
    EXPECT_NE(stored(db, column, "x'07'").find("not 32 bits"), std::string::npos);
    EXPECT_NE(stored(db, column, "1e999").find("not 32 bits"), std::string::npos);
  }
}

TEST(KindsColumns, AreDeclaredAfterTheMotionInAnyOrder) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE one USING moving_objects(id, t, x, y, vx, vy, r, until, mask, category INTEGER, "
      "+name)");
  db.exec("INSERT INTO one VALUES(1, 0, 0, 0, 0, 0, 1, NULL, 6, 5, 'n')");
  EXPECT_EQ(db.rows("SELECT category, mask, typeof(mask), name, until FROM one WHERE category = 5"),
            "5|6|integer|n|NULL");
  db.exec(
      "CREATE VIRTUAL TABLE two USING moving_objects(id, x, category); INSERT INTO two(id, x) VALUES(1, 0)");
  EXPECT_EQ(db.rows("SELECT * FROM two"), "1|0.0|1");
  db.exec(
      "CREATE VIRTUAL TABLE three USING moving_objects(id, x, mask); INSERT INTO three(id, x) VALUES(1, 0)");
  EXPECT_EQ(db.rows("SELECT * FROM three"), "1|0.0|4294967295");
  const auto error = [&](const std::string& columns) {
    return db.error_of("CREATE VIRTUAL TABLE wrong USING moving_objects(id, x, " + columns + ")");
  };
  EXPECT_EQ(error("category, vx"),
            "wrong: \"vx\": category and mask come after the motion columns; move it before category");
  EXPECT_EQ(error("+name, mask"),
            "wrong: \"mask\": motion columns come before the auxiliary columns; move it before +name");
  EXPECT_EQ(error("mask, mask"),
            "wrong: \"mask\": a column named mask is declared already; choose another name");
  EXPECT_EQ(error("category TEXT"),
            "wrong: \"category TEXT\": category holds an integer; write category or category INTEGER");
}

TEST(KindsColumns, AnUpdateOfThemAloneIsRolledBackAndKept) {
  TemporaryFile file;
  const std::string read = "SELECT sum(category), sum(mask) FROM ships";
  {
    Database db(file.path());
    db.exec(std::string("PRAGMA page_size = 512;") + create);
    db.exec(
        "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400)"
        "INSERT INTO ships SELECT i, i * 37 % 200, 1 << i % 9, i % 5, 'n' FROM n");
    const std::string before = db.rows(read);
    db.exec("BEGIN; UPDATE ships SET category = 2147483648 WHERE id % 3 = 0");
    const std::string changed = db.rows(read);
    EXPECT_NE(changed, before);
    db.exec("SAVEPOINT s; UPDATE ships SET mask = 0; ROLLBACK TO s");
    EXPECT_EQ(db.rows(read), changed);
    EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window WHERE h = 0 AND mask = 2147483648"), "133");
    db.exec("ROLLBACK");
    EXPECT_EQ(db.rows(read), before);
    EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window WHERE h = 0 AND mask = 2147483648"), "0");
    db.exec(
        "UPDATE ships SET category = 2147483648 WHERE id % 3 = 0;"
        "INSERT INTO ships(ships) VALUES('integrity-check'); INSERT INTO ships(ships) VALUES('optimize');"
        "INSERT INTO ships(ships) VALUES('integrity-check'); INSERT INTO ships(ships) VALUES('rebuild');"
        "INSERT INTO ships(ships) VALUES('integrity-check')");
    EXPECT_EQ(db.rows("SELECT value FROM ships_meta WHERE key = 'features'"), "blocks,kinds");
  }
  Database db(file.path());
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window WHERE h = 0 AND mask = 2147483648"), "133");
  EXPECT_EQ(
      db.rows("SELECT count(*), sum(mask) FROM ships WHERE category = 2147483648"),
      "133|" +
          db.rows(
              "SELECT sum(i % 5) FROM (WITH n(i) AS (SELECT 3 UNION ALL SELECT i + 3 FROM n WHERE i < 397) "
              "SELECT i FROM n WHERE i < 400)"));
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(KindsColumns, ATableWithoutThemHasNoFeature) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, x)");
  EXPECT_EQ(db.rows("SELECT value FROM ships_meta WHERE key = 'features'"), "blocks");
}

}  // namespace
}  // namespace foresee::testing
