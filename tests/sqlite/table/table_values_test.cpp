// Values of a moving_objects table: which ones it stores, and the errors of all others.
#include <cmath>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct TableValues : ::testing::Test {
  TableValues() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, until);"
        "CREATE VIRTUAL TABLE rockets USING moving_objects(id, x, vx, fx, m);"
        "CREATE VIRTUAL TABLE crates USING moving_objects(id, x, y, ax, ay, hx, hy);"
        "CREATE VIRTUAL TABLE guests USING moving_objects(id, x, until)");
  }

  /// The value of `column` of a ship as read back after an INSERT of `value`, or the error.
  std::string ship(const std::string& column, const std::string& value) {
    db.exec("DELETE FROM ships; INSERT INTO ships(id, t, x, y) VALUES(7, 0, 1, 2)");
    const std::string error = db.error_of("UPDATE ships SET " + column + " = " + value + " WHERE id = 7");
    if (!error.empty()) {
      EXPECT_EQ(db.rows("SELECT * FROM ships"), "7|0.0|1.0|2.0|0.0|0.0|0.0|NULL")
          << "a refused value changed it";
      return error;
    }
    return db.rows("SELECT " + column + " FROM ships");
  }

  Database db;
};

TEST_F(TableValues, IntegersAndNumericTextConvert) {
  EXPECT_EQ(ship("x", "5"), "5.0");
  EXPECT_EQ(ship("x", "'5'"), "5.0");
  EXPECT_EQ(ship("x", "' -2.5e3 '"), "-2500.0");
  EXPECT_EQ(ship("x", "9007199254740992"), "9007199254740992.0");
  EXPECT_EQ(ship("x", "-9223372036854775808"), ship("x", "-9223372036854775808.0"));
  EXPECT_EQ(ship("vx", "'0.1'"), "0.1");
  EXPECT_EQ(ship("until", "'12'"), "12.0");
}

TEST_F(TableValues, EveryBitComesBack) {
  for (const char* number :
       {"-0.0", "4.9406564584124654e-324", "-2.2250738585072009e-308", "1.7976931348623157e308", "0.1",
        "3.141592653589793", "1e22", "123456789.12345678"}) {
    EXPECT_EQ(ship("x", number), db.rows(std::string("SELECT ") + number)) << number;
    EXPECT_EQ(ship("vy", number), db.rows(std::string("SELECT ") + number)) << number;
  }
}

TEST_F(TableValues, NullAndEmptyTextAreZeroOrUnbounded) {
  for (const char* null : {"NULL", "''"}) {
    EXPECT_EQ(ship("vx", null), "0.0");
    EXPECT_EQ(ship("r", null), "0.0");
    EXPECT_EQ(ship("until", null), "NULL");
  }
  db.exec(
      "INSERT INTO crates VALUES(1, 0, 0, NULL, '', NULL, ''); INSERT INTO rockets VALUES(1, 0, NULL, NULL, "
      "2)");
  EXPECT_EQ(db.rows("SELECT * FROM crates"), "1|0.0|0.0|0.0|0.0|0.0|0.0");
  EXPECT_EQ(db.rows("SELECT * FROM rockets"), "1|0.0|0.0|0.0|2.0");
}

TEST_F(TableValues, NanIsNull) {
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(db.handle(), "INSERT INTO ships(id, t, x, y, vx) VALUES(1, 0, ?1, 0, ?2)", -1, &insert,
                     nullptr);
  sqlite3_bind_double(insert, 1, 1);
  sqlite3_bind_double(insert, 2, std::nan(""));
  EXPECT_EQ(sqlite3_step(insert), SQLITE_DONE);
  sqlite3_reset(insert);
  sqlite3_bind_double(insert, 1, std::nan(""));
  EXPECT_EQ(sqlite3_step(insert), SQLITE_CONSTRAINT);
  EXPECT_STREQ(sqlite3_errmsg(db.handle()),
               "ships.x of row 1 is NULL: a position is needed; write a finite number");
  sqlite3_finalize(insert);
  EXPECT_EQ(db.rows("SELECT vx FROM ships"), "0.0");
}

TEST_F(TableValues, APositionAndAReferenceTimeAreNeeded) {
  EXPECT_EQ(ship("x", "NULL"), "ships.x of row 7 is NULL: a position is needed; write a finite number");
  EXPECT_EQ(ship("y", "''"), "ships.y of row 7 is '': a position is needed; write a finite number");
  EXPECT_EQ(ship("t", "NULL"),
            "ships.t of row 7 is NULL: a declared reference time is needed; write the time at which the "
            "position holds");
  EXPECT_EQ(db.error_of("INSERT INTO ships(id, x, y) VALUES(1, 1, 2)"),
            "ships.t of row 1 is NULL: a declared reference time is needed; write the time at which the "
            "position holds");
}

TEST_F(TableValues, AValueThatIsNoNumberIsRefused) {
  for (const char* column : {"t", "x", "vx", "r", "until"}) {
    const std::string what = std::string("ships.") + column + " of row 7 is ";
    EXPECT_EQ(ship(column, "'abc'"), what + "'abc': not a number; write a finite number");
    EXPECT_EQ(ship(column, "'12abc'"), what + "'12abc': not a number; write a finite number");
    EXPECT_EQ(ship(column, "'inf'"), what + "'inf': not a number; write a finite number");
    EXPECT_EQ(ship(column, "' '"), what + "' ': not a number; write a finite number");
    EXPECT_EQ(ship(column, "'0x10'"), what + "'0x10': not a number; write a finite number");
    EXPECT_EQ(ship(column, "x'3132'"), what + "a blob of 2 bytes: not a number; write a finite number");
  }
  EXPECT_EQ(ship("x", "'" + std::string(39, 'a') + "\xc3\xa9zz'"),
            "ships.x of row 7 is '" + std::string(39, 'a') + "...': not a number; write a finite number");
}

/// Python, for one, raises UnicodeDecodeError in place of a message with other bytes.
TEST_F(TableValues, AMessageIsUtf8WhateverItQuotes) {
  const auto message_of = [&](const std::string& bytes) {
    return db.error_of("INSERT INTO ships(id, t, x, y) VALUES(1, 0, CAST(x'" + bytes + "' AS TEXT), 0)");
  };
  const auto quoted = [](const std::string& text) {
    return "ships.x of row 1 is '" + text + "': not a number; write a finite number";
  };
  EXPECT_EQ(message_of("c3a4e282acf09f9880efbfbf"), quoted("\u00e4\u20ac\U0001F600\uffff"));
  EXPECT_EQ(message_of("ff41c3"), quoted("?A?"));
  EXPECT_EQ(message_of("c080e08080f0808080"), quoted("?????????")) << "longer than needed";
  EXPECT_EQ(message_of("eda080f4908080f5"), quoted("????????")) << "surrogates, beyond U+10FFFF";
  EXPECT_EQ(message_of("e282f09f98c3c3a4"), quoted("??????\u00e4")) << "cut off";
}

TEST_F(TableValues, ADateIsNoTime) {
  EXPECT_EQ(ship("t", "'2026-11-21 12:00:00'"),
            "ships.t of row 7 is '2026-11-21 12:00:00': a date, where seconds are stored; write "
            "unixepoch('2026-11-21 12:00:00')");
  EXPECT_EQ(ship("until", "'2026-11-21'"),
            "ships.until of row 7 is '2026-11-21': a date, where seconds are stored; write "
            "unixepoch('2026-11-21')");
  EXPECT_EQ(ship("x", "'2026-11-21'"),
            "ships.x of row 7 is '2026-11-21': not a number; write a finite number");
  EXPECT_EQ(ship("t", "'2026-1-21'"), "ships.t of row 7 is '2026-1-21': not a number; write a finite number");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_position('2026-11-21T12:00Z', 'ships')"),
            "predictive_position: at must be a number, not '2026-11-21T12:00Z': write "
            "unixepoch('2026-11-21T12:00Z')");
}

TEST_F(TableValues, InfinitiesAreRefused) {
  for (const char* column : {"t", "x", "vx", "r"})
    EXPECT_EQ(ship(column, "1e999"),
              std::string("ships.") + column + " of row 7 is inf: not a finite number; write a finite one");
  EXPECT_EQ(ship("x", "-1e999"), "ships.x of row 7 is -inf: not a finite number; write a finite one");
  EXPECT_EQ(ship("until", "9e999"),
            "ships.until of row 7 is inf: not a finite number; write NULL for no end");
  EXPECT_EQ(ship("x", "'1e999'").substr(0, 18), "ships.x of row 7 i");
  EXPECT_NE(ship("x", "'1e999'").find("not a finite number"), std::string::npos);
}

TEST_F(TableValues, AnIntegerThatNoDoubleHoldsIsRefused) {
  EXPECT_EQ(ship("x", "9007199254740993"),
            "ships.x of row 7 is 9007199254740993: no double holds this integer;"
            " write 9007199254740992 for the nearest that one does");
  EXPECT_NE(ship("x", "9223372036854775807").find("no double holds this integer"), std::string::npos);
  EXPECT_NE(ship("t", "'9007199254740993'").find("no double holds this integer"), std::string::npos);
  EXPECT_EQ(ship("x", "9223372036854774784"), ship("x", "9223372036854774784.0"));
}

TEST_F(TableValues, ExtentsAreNeverNegative) {
  EXPECT_EQ(ship("r", "-1"), "ships.r of row 7 is -1: a radius is never negative; write 0 or more");
  EXPECT_EQ(ship("r", "'-0.5'").substr(0, 21), "ships.r of row 7 is -");
  EXPECT_EQ(ship("r", "-0.0"), "-0.0");
  EXPECT_EQ(db.error_of("INSERT INTO crates VALUES(3, 0, 0, 0, 0, 1, -1e-300)"),
            "crates.hy of row 3 is -1e-300: a half extent is never negative; write 0 or more");
}

TEST_F(TableValues, AMassIsPositive) {
  EXPECT_EQ(db.error_of("INSERT INTO rockets VALUES(1, 0, 0, 5, 0)"),
            "rockets.m of row 1 is 0: a mass is never 0 or negative; write a number greater than 0");
  EXPECT_EQ(db.error_of("INSERT INTO rockets VALUES(1, 0, 0, 5, -2.5)"),
            "rockets.m of row 1 is -2.5: a mass is never 0 or negative; write a number greater than 0");
  EXPECT_EQ(db.error_of("INSERT INTO rockets(id, x, fx) VALUES(1, 0, 5)"),
            "rockets.m of row 1 is NULL: a force needs a mass; write a number greater than 0");
}

TEST_F(TableValues, TheQuotientOfForceAndMassIsFinite) {
  EXPECT_EQ(db.error_of("INSERT INTO rockets VALUES(1, 0, 0, 1e300, 1e-300)"),
            "rockets.fx of row 1 is 1e+300: divided by the mass 1e-300 it overflows;"
            " write a smaller force or a greater mass");
  db.exec("INSERT INTO rockets VALUES(1, 0, 0, 1e-300, 1e300)");
  EXPECT_EQ(db.rows("SELECT fx, m FROM rockets"), "1e-300|1e+300");
}

TEST_F(TableValues, AMotionDoesNotEndBeforeItsReferenceTime) {
  db.exec("INSERT INTO ships(id, t, x, y, until) VALUES(1, 10, 0, 0, 10)");
  EXPECT_EQ(
      db.error_of("INSERT INTO ships(id, t, x, y, until) VALUES(2, 10, 0, 0, 9.5)"),
      "ships.until of row 2 is 9.5: before the reference time 10; write 10 or more, or NULL for no end");
  EXPECT_EQ(db.error_of("UPDATE ships SET t = 11 WHERE id = 1"),
            "ships.until of row 1 is 10: before the reference time 11; write 11 or more, or NULL for no end");
  EXPECT_EQ(db.error_of("INSERT INTO guests VALUES(1, 0, -1)"),
            "guests.until of row 1 is -1: before the reference time 0; write 0 or more, or NULL for no end");
}

TEST_F(TableValues, AWrongRowAmongManyChangesNothing) {
  EXPECT_EQ(db.error_of("INSERT INTO guests(id, x) VALUES(1, 0), (2, 0), (3, 'abc')"),
            "guests.x of row 3 is 'abc': not a number; write a finite number");
  EXPECT_EQ(db.rows("SELECT count(*) FROM guests"), "0");
}

}  // namespace
}  // namespace foresee::testing
