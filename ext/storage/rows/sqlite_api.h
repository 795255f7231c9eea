// SQLite API for storage/ and sqlite/: the only header that includes SQLite, as a table of function pointers.
// A loadable extension gets the table from the host (sqlite/loaded_sqlite.cpp). In an application the library
// has its own table, of the SQLite that it is linked with (sqlite/linked_sqlite.cpp). Both variants consist
// of the same object files.
#pragma once

#include <sqlite3ext.h>

SQLITE_EXTENSION_INIT3
