// The one place through which storage/ and sqlite/ see SQLite: linked statically (SQLITE_CORE) or through the
// table of functions that SQLite hands to a loadable extension. sqlite/entry.cpp defines that table.
#pragma once

#include <sqlite3ext.h>

SQLITE_EXTENSION_INIT3
