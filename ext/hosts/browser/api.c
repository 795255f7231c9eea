/* What the page calls: SQL in, JSON out.
**
**   foresee_open()            0, or SQLite's error code: a database in memory that knows foresee
**   foresee_query(sql)        the rows of the last statement that has columns, as
**                             {"columns": ["a", ...], "rows": [[1, 2.5, "text", null], ...], "ms": 1.5}
**                             or {"error": "message", "offset": byte of the text or -1};
**                             valid until the next call
**   foresee_texts(sql)        the rows of every statement that has columns, as the shell prints them:
**                             {"results": [{"columns": ["a", ...], "rows": [["1", "2.5", null], ...]}, ...],
**                             "ms": 1.5}, or an error as above
**
** Doubles have 17 digits, so that they are read back as the same doubles; infinities are 1e999. Integers
** beyond 2^53 are strings, as JavaScript's numbers would round them; a blob is a string of hexadecimal
** digits. */
#include <emscripten.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sqlite/foresee.h"
#include "sqlite3.h"

static sqlite3* database;
static sqlite3_str* answer;
static char* given;

static void append_text(const char* text, int bytes) {
  sqlite3_str_appendchar(answer, 1, '"');
  for (int i = 0; i < bytes; ++i) {
    const unsigned char c = (unsigned char)text[i];
    if (c == '"' || c == '\\') {
      sqlite3_str_appendchar(answer, 1, '\\');
      sqlite3_str_appendchar(answer, 1, (char)c);
    } else if (c < 0x20) {
      sqlite3_str_appendf(answer, "\\u%04x", c);
    } else {
      sqlite3_str_appendchar(answer, 1, (char)c);
    }
  }
  sqlite3_str_appendchar(answer, 1, '"');
}

static void append_double(double number) {
  char digits[40];
  if (isinf(number))
    snprintf(digits, sizeof digits, "%s1e999", number < 0 ? "-" : "");
  else
    snprintf(digits, sizeof digits, "%.17g", number);
  sqlite3_str_appendall(answer, digits);
}

static void append_value(sqlite3_stmt* statement, int column) {
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER: {
      const sqlite3_int64 number = sqlite3_column_int64(statement, column);
      const sqlite3_int64 exact = (sqlite3_int64)1 << 53;
      const char* quote = number > exact || number < -exact ? "\"" : "";
      sqlite3_str_appendf(answer, "%s%lld%s", quote, number, quote);
      break;
    }
    case SQLITE_FLOAT:
      append_double(sqlite3_column_double(statement, column));
      break;
    case SQLITE_TEXT:
      append_text((const char*)sqlite3_column_text(statement, column),
                  sqlite3_column_bytes(statement, column));
      break;
    case SQLITE_BLOB: {
      const unsigned char* bytes = sqlite3_column_blob(statement, column);
      const int count = sqlite3_column_bytes(statement, column);
      sqlite3_str_appendchar(answer, 1, '"');
      for (int i = 0; i < count; ++i) sqlite3_str_appendf(answer, "%02x", bytes[i]);
      sqlite3_str_appendchar(answer, 1, '"');
      break;
    }
    default:
      sqlite3_str_appendall(answer, "null");
  }
}

/* As the shell prints it: doubles with 15 digits, and 95.0 apart from 95. */
static void append_as_text(sqlite3_stmt* statement, int column) {
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_NULL:
      sqlite3_str_appendall(answer, "null");
      break;
    case SQLITE_FLOAT:
      sqlite3_str_appendf(answer, "\"%!.15g\"", sqlite3_column_double(statement, column));
      break;
    default: {
      const char* text = (const char*)sqlite3_column_text(statement, column);
      append_text(text, sqlite3_column_bytes(statement, column));
    }
  }
}

static int append_rows(sqlite3_stmt* statement, int as_texts) {
  const int columns = sqlite3_column_count(statement);
  int rc;
  sqlite3_str_appendall(answer, "{\"columns\":[");
  for (int i = 0; i < columns; ++i) {
    const char* name = sqlite3_column_name(statement, i);
    if (i > 0) sqlite3_str_appendchar(answer, 1, ',');
    append_text(name, (int)strlen(name));
  }
  sqlite3_str_appendall(answer, "],\"rows\":[");
  for (int row = 0; (rc = sqlite3_step(statement)) == SQLITE_ROW; ++row) {
    sqlite3_str_appendall(answer, row > 0 ? ",\n[" : "\n[");
    for (int i = 0; i < columns; ++i) {
      if (i > 0) sqlite3_str_appendchar(answer, 1, ',');
      if (as_texts)
        append_as_text(statement, i);
      else
        append_value(statement, i);
    }
    sqlite3_str_appendchar(answer, 1, ']');
  }
  sqlite3_str_appendall(answer, "]");
  return rc;
}

static void append_error(int offset) {
  const char* message = sqlite3_errmsg(database);
  sqlite3_str_reset(answer);
  sqlite3_str_appendall(answer, "{\"error\":");
  append_text(message, (int)strlen(message));
  sqlite3_str_appendf(answer, ",\"offset\":%d}", offset);
}

/* All statements, with the rows of the last one or the texts of all; 0 if one failed, whose error is the answer. */
static int run(const char* sql, int as_texts) {
  int results = 0;
  for (const char* rest = sql; *rest;) {
    sqlite3_stmt* statement;
    const char* first = rest;
    int rc = sqlite3_prepare_v2(database, first, -1, &statement, &rest);
    if (rc != SQLITE_OK) {
      const int within = sqlite3_error_offset(database);
      append_error(within < 0 ? -1 : (int)(first - sql) + within);
      return 0;
    }
    if (!statement) continue;
    if (sqlite3_column_count(statement) > 0) {
      if (as_texts)
        sqlite3_str_appendall(answer, results++ ? "},\n" : "");
      else
        sqlite3_str_reset(answer);
      rc = append_rows(statement, as_texts);
    } else {
      rc = sqlite3_step(statement);
    }
    if (rc != SQLITE_DONE) append_error(-1);
    sqlite3_finalize(statement);
    if (rc != SQLITE_DONE) return 0;
  }
  if (results) sqlite3_str_appendall(answer, "}");
  return 1;
}

int EMSCRIPTEN_KEEPALIVE foresee_open(void) {
  char* message = NULL;
  int rc;
  sqlite3_close(database);
  rc = sqlite3_open(":memory:", &database);
  return rc == SQLITE_OK ? sqlite3_foresee_init(database, &message, NULL) : rc;
}

static const char* finished(void) {
  given = sqlite3_str_finish(answer);
  return given ? given : "{\"error\":\"out of memory\",\"offset\":-1}";
}

const char* EMSCRIPTEN_KEEPALIVE foresee_query(const char* sql) {
  const double start = emscripten_get_now();
  sqlite3_free(given);
  answer = sqlite3_str_new(database);
  if (run(sql, 0)) {
    if (sqlite3_str_length(answer) == 0) sqlite3_str_appendall(answer, "{\"columns\":[],\"rows\":[]");
    sqlite3_str_appendf(answer, ",\"ms\":%.3f}", emscripten_get_now() - start);
  }
  return finished();
}

const char* EMSCRIPTEN_KEEPALIVE foresee_texts(const char* sql) {
  const double start = emscripten_get_now();
  sqlite3_free(given);
  answer = sqlite3_str_new(database);
  sqlite3_str_appendall(answer, "{\"results\":[");
  if (run(sql, 1)) sqlite3_str_appendf(answer, "],\"ms\":%.3f}", emscripten_get_now() - start);
  return finished();
}
