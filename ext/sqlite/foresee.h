/* C interface of foresee linked into an application.
** Call it once per connection, or pass it to sqlite3_auto_extension.
**
**   sqlite3_open("fleet.db", &db);
**   sqlite3_foresee_init(db, &message, 0);
*/
#ifndef FORESEE_H
#define FORESEE_H

struct sqlite3;
struct sqlite3_api_routines;

#ifdef __cplusplus
extern "C"
#endif
    int
    sqlite3_foresee_init(struct sqlite3* db, char** message, const struct sqlite3_api_routines* api);

#endif
