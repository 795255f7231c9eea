// The one place through which storage/ and sqlite/ see SQLite: a table of its functions. A loadable extension
// is handed it by the host (sqlite/loaded_sqlite.cpp); linked into an application, the library has its own,
// of the SQLite that it is linked with (sqlite/linked_sqlite.cpp). So both are made of the same objects.
#pragma once

#include <sqlite3ext.h>

SQLITE_EXTENSION_INIT3
