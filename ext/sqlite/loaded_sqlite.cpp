// Table of SQLite's functions for a loadable extension: the host passes it to the entry point.
#include "database/sqlite_api.h"

const sqlite3_api_routines* sqlite3_api = nullptr;
