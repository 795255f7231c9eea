// Shared by the fuzzers: a connection, and statements that are made of a fuzzer's bytes.
//
// A number that SQL must give back is written with all its digits. Small whole numbers are the most frequent:
// they produce objects that touch, tie and coincide, where errors are likely.
#pragma once

#include <sqlite3.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string>

#include "bytes.h"
#include "sqlite/foresee.h"

namespace foresee::testing {

/// Ends the run: libFuzzer keeps the bytes that led here.
[[noreturn]] inline void fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
}

class Connection {
 public:
  Connection() {
    if (sqlite3_open(":memory:", &db_) != SQLITE_OK) fail("no database");
    if (sqlite3_foresee_init(db_, nullptr, nullptr) != SQLITE_OK) fail("no foresee");
  }
  ~Connection() {
    if (sqlite3_close(db_) != SQLITE_OK) fail(std::string("close: ") + sqlite3_errmsg(db_));
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  sqlite3* handle() { return db_; }
  bool in_transaction() { return sqlite3_get_autocommit(db_) == 0; }

  /// The primary result code.
  int run(const std::string& sql) { return sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr) & 0xff; }
  void must(const std::string& sql) {
    if (run(sql) != SQLITE_OK) fail(sql + ": " + sqlite3_errmsg(db_));
  }
  /// All rows as text, doubles bit for bit; "error" and the message if it fails.
  std::string rows(const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(db_, sql.c_str(), -1, &statement, nullptr) != SQLITE_OK)
      return std::string("error ") + sqlite3_errmsg(db_);
    std::string text;
    int rc;
    while ((rc = sqlite3_step(statement)) == SQLITE_ROW) {
      for (int i = 0; i < sqlite3_column_count(statement); ++i) {
        char digits[40];
        if (sqlite3_column_type(statement, i) == SQLITE_FLOAT) {
          std::snprintf(digits, sizeof digits, "%a", sqlite3_column_double(statement, i));
          text += digits;
        } else if (const unsigned char* value = sqlite3_column_text(statement, i)) {
          text += reinterpret_cast<const char*>(value);
        }
        text += '|';
      }
      text += '\n';
    }
    sqlite3_finalize(statement);
    return rc == SQLITE_DONE ? text : std::string("error ") + sqlite3_errmsg(db_);
  }

 private:
  sqlite3* db_ = nullptr;
};

/// As they are read back; the last but one is not a number.
inline constexpr const char* fuzz_outlines[] = {
    "'POLYGON((0 0, 2 0, 0 2, 0 0))'",
    "'POLYGON((-1 -1, 3 -1, 3 0, 0 0, 0 3, -1 3, -1 -1))'",
    "'POLYGON((0 0, 6 0, 6 6, 0 6, 0 0), (2 2, 3 2, 3 3, 2 2))'",
    "'MULTIPOLYGON(((4 4, 5 4, 4 5, 4 4)), ((-4 -4, -5 -4, -4 -5, -4 -4)))'",
    "'POLYGON((0 0, 1 1))'",
    "NULL",
};
inline constexpr const char* fuzz_meshes[] = {
    "'TIN Z(((0 0 0, 2 0 0, 0 2 0, 0 0 0)))'",
    "'POLYHEDRALSURFACE Z(((0 0 0, 0 3 0, 3 0 0, 0 0 0)), ((0 0 0, 3 0 0, 0 0 3, 0 0 0)), ((0 0 0, 0 0 3, 0 "
    "3 0, "
    "0 0 0)), ((3 0 0, 0 3 0, 0 0 3, 3 0 0)))'",
    "'TIN Z(((-1 -1 1, 3 -1 0, 0 3 2, -1 -1 1)), ((3 -1 0, -1 -1 1, 0 -4 -1, 3 -1 0)))'",
    "'MULTIPOLYGON Z(((4 4 4, 5 4 4, 4 5 4, 4 4 4)), ((0 0 -2, 1 0 -2, 0 1 -1, 0 0 -2)))'",
    "'POLYHEDRALSURFACE Z(((0 0 0, 2 0 0, 0 2 0, 0 0 0)))'",
    "NULL",
};

struct FuzzTable {
  const char* columns;  ///< those after the id
  int numbers;
  int axes;
  std::span<const char* const> shapes = {};  ///< one of them follows the numbers, if the table has any
};

inline constexpr FuzzTable fuzz_tables[] = {
    {"x", 1, 1},
    {"x, vx, hx", 3, 1},
    {"t, x, y, vx, vy, r", 6, 2},
    {"x, y, hx, hy", 4, 2},
    {"t, x, y, vx, vy, ax, ay, hx, hy, until", 10, 2},
    {"t, x, y, z, vx, vy, vz, r, hz", 9, 3},
    {"t, x, y, z, vx, vy, vz, fx, fy, fz, m, r, until", 13, 3},
    {"t, x, y, vx, vy, r, heading, shape", 7, 2, fuzz_outlines},
    {"t, x, y, z, vx, vy, vz, r, heading, shape", 9, 3, fuzz_meshes},
};

/// The parts one after the other. Every compiler also evaluates them in this order, unlike the operands of +.
inline std::string in_order(std::initializer_list<std::string> parts) {
  std::string whole;
  for (const std::string& part : parts) whole += part;
  return whole;
}

inline std::string literal(double number) {
  if (std::isinf(number)) return number > 0 ? "9e999" : "-9e999";
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.17g", number);
  return std::strpbrk(digits, ".e") ? digits : std::string(digits) + ".0";
}

inline double fuzz_number(FuzzBytes& bytes) {
  switch (bytes.in_range(0, 7)) {
    case 0: {
      const auto bits = bytes.any<std::uint64_t>();
      double number;
      std::memcpy(&number, &bits, sizeof number);
      return std::isnan(number) ? 0 : number;
    }
    case 1: {
      const int exponent = bytes.in_range(-80, 80);
      return std::ldexp(bytes.any<std::int8_t>(), exponent);
    }
    case 2:
      return bytes.any<std::int16_t>() / 16.0;
    default:
      return bytes.in_range(-9, 9);
  }
}

inline std::string fuzz_values(FuzzBytes& bytes, const FuzzTable& table) {
  std::string list;
  for (int i = 0; i < table.numbers; ++i) list += (i ? ", " : "") + literal(fuzz_number(bytes));
  if (!table.shapes.empty())
    list += std::string(", ") + table.shapes[bytes.in_range<std::size_t>(0, table.shapes.size() - 1)];
  return list;
}

inline std::string fuzz_id(FuzzBytes& bytes) {
  return std::to_string(bytes.in_range(-4, 60));
}

/// Three numbers for the axes that the table has, NULL for the others.
inline std::string fuzz_axes(FuzzBytes& bytes, const FuzzTable& table) {
  std::string list;
  for (int axis = 0; axis < 3; ++axis)
    list += (axis ? ", " : "") + (axis < table.axes ? literal(fuzz_number(bytes)) : std::string("NULL"));
  return list;
}

/// A query for which every method must give the same rows; METHOD stands for its name.
inline std::string fuzz_question(FuzzBytes& bytes, const FuzzTable& table) {
  const std::string h = literal(std::fabs(fuzz_number(bytes)));
  const int kind = bytes.in_range(0, 3);
  if (kind == 0) {
    const double x = fuzz_number(bytes);
    return in_order({"SELECT * FROM predictive_window(", h, ", 'ships', ", literal(x), ", ",
                     literal(x + std::fabs(fuzz_number(bytes))), ", NULL, NULL, NULL, NULL, NULL, ",
                     fuzz_axes(bytes, table), ", METHOD) ORDER BY id"});
  }
  if (kind == 1)
    return in_order({"SELECT * FROM predictive_nearest(", h, ", 'ships', ",
                     std::to_string(bytes.in_range(0, 9)), ", ", fuzz_axes(bytes, table), ", NULL, ",
                     fuzz_axes(bytes, table), ", METHOD) ORDER BY rank"});
  const std::string within = literal(std::fabs(fuzz_number(bytes)));
  const std::string now = bytes.flag() ? "NULL" : literal(fuzz_number(bytes));
  const std::string probe = kind == 2 ? " WHERE a = " + fuzz_id(bytes) : "";
  return "SELECT a, b, t, t_end, dt, dt_end FROM predictive_join(" + h + ", 'ships', " + within + ", NULL, " +
         now + ", METHOD)" + probe + " ORDER BY a, b";
}

inline std::string with_method(std::string question, const std::string& method) {
  return question.replace(question.find("METHOD"), 6, "'" + method + "'");
}

/// The methods of the join; a window or nearest refuses "grid".
inline constexpr const char* fuzz_methods[] = {"auto", "tree", "grid"};

}  // namespace foresee::testing
