#include "database/value_text.h"

#include <gtest/gtest.h>

#include <new>

#include "storage/database.h"

namespace foresee {
namespace {

/// The result of text_of() for an SQL function's argument; `starved`: while SQLite gets no memory.
struct Reading {
  bool starved = false;
  std::string text;
};

void read_argument(sqlite3_context* context, int, sqlite3_value** arguments) {
  auto& reading = *static_cast<Reading*>(sqlite3_user_data(context));
  const sqlite3_int64 limit = reading.starved ? sqlite3_hard_heap_limit64(sqlite3_memory_used()) : -1;
  try {
    reading.text = text_of(arguments[0]);
  } catch (const std::bad_alloc&) {
    reading.text = "no memory";
  }
  if (reading.starved) sqlite3_hard_heap_limit64(limit);
}

TEST(Text, IsAsLongAsItIs) {
  Database db;
  Reading reading;
  sqlite3_create_function(db, "reading_of", 1, SQLITE_UTF8, &reading, read_argument, nullptr, nullptr);
  db.run("SELECT reading_of('s' || char(0) || 'x')");
  EXPECT_EQ(reading.text, std::string("s\0x", 3));
  EXPECT_EQ(without_nul(reading.text), "s\\0x");
  db.run("SELECT reading_of(NULL)");
  EXPECT_EQ(reading.text, "");
  db.run("SELECT reading_of(1.5)");
  EXPECT_EQ(reading.text, "1.5");
}

void test_exactness(sqlite3_context* context, int, sqlite3_value** arguments) {
  sqlite3_result_int(context, is_inexact(arguments[0]));
}

TEST(Values, AreInexactIfNoDoubleHoldsTheInteger) {
  Database db;
  sqlite3_create_function(db, "is_inexact", 1, SQLITE_UTF8, nullptr, test_exactness, nullptr, nullptr);
  const auto is_inexact = [&](const std::string& value) {
    return db.number("SELECT is_inexact(" + value + ")");
  };
  for (const char* value : {"9007199254740993", "'9007199254740993'", "9223372036854775807"})
    EXPECT_EQ(is_inexact(value), 1) << value;
  for (const char* value :
       {"9007199254740992", "-9223372036854775808", "0.1", "1e300", "'east'", "NULL", "x'00'"})
    EXPECT_EQ(is_inexact(value), 0) << value;
}

void show_argument(sqlite3_context* context, int, sqlite3_value** arguments) {
  *static_cast<std::string*>(sqlite3_user_data(context)) = shown(arguments[0]);
}

TEST(Text, ShowsAValueAsAMessageNeedsIt) {
  Database db;
  std::string text;
  sqlite3_create_function(db, "show", 1, SQLITE_UTF8, &text, show_argument, nullptr, nullptr);
  const auto shown_text = [&](const std::string& value) {
    db.run("SELECT show(" + value + ")");
    return text;
  };
  EXPECT_EQ(shown_text("NULL"), "NULL");
  EXPECT_EQ(shown_text("9007199254740993"), "9007199254740993");
  EXPECT_EQ(shown_text("0.1"), "0.1");
  EXPECT_EQ(shown_text("-3.0"), "-3");
  EXPECT_EQ(shown_text("x'3132'"), "a blob of 2 bytes");
  EXPECT_EQ(shown_text("'a' || char(0) || 'b'"), "'a\\0b'");
  EXPECT_EQ(shown_text("printf('%.*c', 40, 'x')"), "'" + std::string(40, 'x') + "'");
  EXPECT_EQ(shown_text("printf('%.*c', 41, 'x')"), "'" + std::string(40, 'x') + "...'");
}

TEST(Text, IsAnErrorWithoutMemory) {
  Database db;
  Reading reading{.starved = true, .text = ""};
  // Stored in UTF-16: the conversion to UTF-8 allocates memory.
  sqlite3_create_function(db, "reading_of", 1, SQLITE_UTF16, &reading, read_argument, nullptr, nullptr);
  sqlite3_exec(db,
               "PRAGMA encoding = 'UTF-16'; CREATE TABLE texts AS SELECT hex(zeroblob(5000)) AS x;"
               "SELECT reading_of(x) FROM texts",
               nullptr, nullptr, nullptr);
  EXPECT_EQ(reading.text, "no memory");
}

}  // namespace
}  // namespace foresee
