/* foresee linked into an application that has SQLite already: no file to load, one call for each connection.
**
** Build: cc embed_sqlite.c $(pkg-config --cflags --libs foresee)     (docs/hosts/c.md)
** Prints:  Anna and Bruno touch after 95 s
*/
#include <foresee.h>
#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>

static const char* const harbour =
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r, +name TEXT);"
    "INSERT INTO ships VALUES(1,    0,     0,  6, 0, 30, 'Anna'),"
    "                        (2, 1200,     0, -6, 0, 30, 'Bruno'),"
    "                        (3,  600, -1600,  0, 8, 30, 'Clara');";

static const char* const question =
    "SELECT s.name, o.name, j.dt FROM predictive_join(300) j"
    "  JOIN ships s ON s.id = j.a JOIN ships o ON o.id = j.b ORDER BY j.t";

static int print_meeting(void* unused, int columns, char** values, char** names) {
  (void)unused, (void)columns, (void)names;
  printf("%s and %s touch after %g s\n", values[0], values[1], atof(values[2]));
  return 0;
}

int main(void) {
  sqlite3* db = NULL;
  char* message = NULL;
  int rc = sqlite3_open(":memory:", &db);
  if (rc == SQLITE_OK) rc = sqlite3_foresee_init(db, &message, NULL);
  if (rc == SQLITE_OK) rc = sqlite3_exec(db, harbour, NULL, NULL, &message);
  if (rc == SQLITE_OK) rc = sqlite3_exec(db, question, print_meeting, NULL, &message);
  if (rc != SQLITE_OK) fprintf(stderr, "%s\n", message ? message : sqlite3_errmsg(db));
  sqlite3_free(message);
  sqlite3_close(db);
  return rc == SQLITE_OK ? 0 : 1;
}
