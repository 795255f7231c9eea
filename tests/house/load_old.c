/* Hands the extension given as argument the table of functions that an older SQLite has: the version is
** faked, and what it does not know is null. Too old a one is refused in words; in others all answers come. */
#define SQLITE_CORE /* the functions of this program's own SQLite, and the table only as a struct */
#include <dlfcn.h>
#include <sqlite3ext.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

typedef int (*Entry)(sqlite3* db, char** message, const sqlite3_api_routines* api);

static const sqlite3_api_routines* real = NULL;

static int take_table(sqlite3* db, char** message, const sqlite3_api_routines* api) {
  (void)db, (void)message;
  real = api;
  return SQLITE_OK;
}

static int faked_number = 0;
static const char* faked_text = NULL;
static int number(void) {
  return faked_number;
}
static const char* text(void) {
  return faked_text;
}

/* From `end` on the older table does not go. */
static sqlite3_api_routines older_table(int version, const char* shown, size_t end) {
  sqlite3_api_routines table;
  memset(&table, 0, sizeof table);
  memcpy(&table, real, end);
  faked_number = version, faked_text = shown;
  table.libversion_number = number, table.libversion = text;
  return table;
}

static int rows = 0;
static int count_row(void* unused, int columns, char** values, char** names) {
  (void)unused, (void)columns, (void)values, (void)names;
  return ++rows, 0;
}

static int gives(sqlite3* db, const char* sql, int expected) {
  char* message = NULL;
  rows = 0;
  int rc = sqlite3_exec(db, sql, count_row, NULL, &message);
  if (rc == SQLITE_OK && rows == expected) return 1;
  printf("%s: %s: %d rows, expected %d: %s\n", faked_text, sql, rows, expected, message ? message : "");
  sqlite3_free(message);
  return 0;
}

static int works(Entry entry, const sqlite3_api_routines* table) {
  sqlite3* db = NULL;
  sqlite3_open(":memory:", &db);
  int good = entry(db, NULL, table) == SQLITE_OK;
  good &= gives(db,
                "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, r);"
                "INSERT INTO ships VALUES(1, 0, 6, 30), (2, 1200, -6, 30), (3, 5000, 0, 30);",
                0);
  good &= gives(db, "SELECT a, b, t FROM predictive_join(300)", 1);
  good &= gives(db, "SELECT a, b FROM predictive_join(300, 'ships') WHERE t IN (95, 96) AND dt > 0", 1);
  good &= gives(db, "SELECT a, b FROM predictive_join(300, 'ships') WHERE a = 2 OR b = 2", 1);
  good &= gives(db, "SELECT a, b FROM predictive_join(300, 'ships', NULL) WHERE a = 2 OR b = 2", 1);
  good &= gives(db, "SELECT * FROM predictive_explain(300)", 7);
  good &= gives(db, "SELECT * FROM predictive_window(300, 'ships', 500, 700)", 2);
  good &= gives(db, "SELECT * FROM predictive_nearest(300, 'ships', 2, 600)", 2);
  good &= gives(db, "SELECT * FROM predictive_position(0)", 3);
  good &= gives(db, "SELECT *, tbl FROM predictive_track(0, 60, 60) ORDER BY t, id", 6);
  good &= gives(db, "SELECT foresee_version(), foresee_debug()", 1);
  good &= gives(db, "BEGIN; SAVEPOINT a; DELETE FROM ships WHERE id = 1; ROLLBACK TO a; COMMIT", 0);
  good &= gives(db, "INSERT INTO ships(ships) VALUES ('rebuild'), ('integrity-check'); DROP TABLE ships", 0);
  return sqlite3_close(db) == SQLITE_OK && good;
}

static int is_refused(Entry entry, const sqlite3_api_routines* table) {
  sqlite3* db = NULL;
  char* message = NULL;
  sqlite3_open(":memory:", &db);
  int rc = entry(db, &message, table);
  printf("%s\n", message ? message : "");
  int good = rc == SQLITE_ERROR && message && strstr(message, "3.31") && strstr(message, faked_text);
  good &= sqlite3_exec(db, "SELECT * FROM predictive_join(1)", NULL, NULL, NULL) == SQLITE_ERROR;
  sqlite3_free(message);
  return sqlite3_close(db) == SQLITE_OK && good;
}

int main(int argc, char** argv) {
  void* library = argc == 2 ? dlopen(argv[1], RTLD_NOW) : NULL;
  Entry entry = NULL;
  sqlite3* db = NULL;
  if (library) *(void**)&entry = dlsym(library, "sqlite3_foresee_init");
  sqlite3_auto_extension((void (*)(void))take_table);
  sqlite3_open(":memory:", &db);
  sqlite3_close(db);
  sqlite3_reset_auto_extension();
  if (!entry || !real) return 1;

  sqlite3_api_routines table = older_table(3039000, "3.39.0", offsetof(sqlite3_api_routines, value_encoding));
  int good = works(entry, &table);
  table = older_table(3037002, "3.37.2", offsetof(sqlite3_api_routines, error_offset));
  good &= works(entry, &table);
  table = older_table(3031000, "3.31.0", offsetof(sqlite3_api_routines, create_filename));
  good &= works(entry, &table);
  table = older_table(3030001, "3.30.1", offsetof(sqlite3_api_routines, hard_heap_limit64));
  good &= is_refused(entry, &table);
  return good ? 0 : 1;
}
