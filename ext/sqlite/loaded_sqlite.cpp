// SQLite's functions in a loadable extension: what the host hands to the entry point.
#include "storage/rows/sqlite_api.h"

const sqlite3_api_routines* sqlite3_api = nullptr;
