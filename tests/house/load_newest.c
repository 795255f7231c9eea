/* Loads the extension given as argument into the SQLite that this program carries, and joins. */
#include <sqlite3.h>
#include <stdio.h>

static int rows_as_expected = 0;

static int check_row(void* unused, int columns, char** values, char** names) {
  (void)unused, (void)columns, (void)names;
  printf("SQLite %s: a %s, b %s, t %s\n", sqlite3_libversion(), values[0], values[1], values[2]);
  rows_as_expected += sqlite3_stricmp(values[0], "1") == 0 && sqlite3_stricmp(values[1], "2") == 0 &&
                      sqlite3_stricmp(values[2], "95.0") == 0;
  return 0;
}

int main(int argc, char** argv) {
  sqlite3* db = NULL;
  char* message = NULL;
  int rc = argc == 2 ? sqlite3_open(":memory:", &db) : SQLITE_MISUSE;
  if (rc == SQLITE_OK) rc = sqlite3_enable_load_extension(db, 1);
  if (rc == SQLITE_OK) rc = sqlite3_load_extension(db, argv[1], NULL, &message);
  if (rc == SQLITE_OK)
    rc = sqlite3_exec(db,
                      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, r);"
                      "INSERT INTO ships VALUES(1, 0, 6, 30), (2, 1200, -6, 30), (3, 5000, 0, 30);"
                      "SELECT a, b, t FROM predictive_join(300);",
                      check_row, NULL, &message);
  if (rc != SQLITE_OK) fprintf(stderr, "%s\n", message ? message : sqlite3_errmsg(db));
  sqlite3_free(message);
  sqlite3_close(db);
  return rc == SQLITE_OK && rows_as_expected == 1 ? 0 : 1;
}
