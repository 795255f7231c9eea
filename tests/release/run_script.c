/* Loads foresee into an SQLite of its own, runs a script and prints every row: doubles as 16 hexadecimal digits.

     run_script MODULE DATABASE SCRIPT

   MODULE is a path without ending. One program for every target of a release: tests/release/targets.py compiles it with
   the newest SQLite and runs it natively, in an emulator or by Wine. An error of a statement is a line of the output;
   the status is 0 if the module was loaded, the script ran to its end, and the process ended without a fault. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sqlite3.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#endif

static char* contents(const char* path) {
  FILE* file = fopen(path, "rb");
  char* text = NULL;
  long size;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 &&
      (text = malloc((size_t)size + 1)) != NULL) {
    rewind(file);
    text[fread(text, 1, (size_t)size, file)] = 0;
  }
  fclose(file);
  return text;
}

static void print_column(sqlite3_stmt* statement, int i) {
  const int type = sqlite3_column_type(statement, i);
  if (i > 0) putchar('|');
  if (type == SQLITE_FLOAT) {
    const double value = sqlite3_column_double(statement, i);
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf("%016llx", (unsigned long long)bits);
  } else if (type != SQLITE_NULL) {
    fputs((const char*)sqlite3_column_text(statement, i), stdout);
  }
}

/* Runs the statements of the script one after the other, whatever became of those before. */
static void run(sqlite3* db, const char* script) {
  sqlite3_stmt* statement;
  while (*script != 0) {
    const char* start = script;
    if (sqlite3_prepare_v2(db, start, -1, &statement, &script) != SQLITE_OK) {
      printf("error: %s\n", sqlite3_errmsg(db));
      if (script == start) return;
    }
    while (statement != NULL && sqlite3_step(statement) == SQLITE_ROW) {
      for (int i = 0; i < sqlite3_column_count(statement); ++i) print_column(statement, i);
      putchar('\n');
    }
    if (statement != NULL && sqlite3_finalize(statement) != SQLITE_OK)
      printf("error: %s\n", sqlite3_errmsg(db));
  }
}

int main(int count, char** arguments) {
  sqlite3* db = NULL;
  char *message = NULL, *script;
  if (count != 4 || (script = contents(arguments[3])) == NULL) {
    fprintf(stderr, "usage: run_script MODULE DATABASE SCRIPT\n");
    return 2;
  }
#ifdef _WIN32
  _setmode(_fileno(stdout), _O_BINARY);
#endif
  if (sqlite3_open(arguments[2], &db) != SQLITE_OK) {
    fprintf(stderr, "%s\n", sqlite3_errmsg(db));
    return 1;
  }
  sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 1, NULL);
  if (sqlite3_load_extension(db, arguments[1], NULL, &message) != SQLITE_OK) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  run(db, script);
  free(script);
  return sqlite3_close(db) != SQLITE_OK || fflush(stdout) != 0;
}
