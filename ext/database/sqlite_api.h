// SQLite API for storage/ and sqlite/, the only header that includes SQLite, and the exception with its result codes.
// The API is a table of function pointers. A loadable extension gets it from the host (sqlite/loaded_sqlite.cpp). In an
// application the library has its own table, of the SQLite that it is linked with (sqlite/linked_sqlite.cpp). Both
// variants consist of the same object files.
#pragma once

#include <sqlite3ext.h>

#include <string>

#include "base/error.h"

SQLITE_EXTENSION_INIT3

namespace foresee {

/// An error of SQLite or damage of the stored bytes; `code` is the result code of the callback.
struct StoreError : Error {
  StoreError(int code, const std::string& message) : Error(message), code(code) {}
  int code;
};

}  // namespace foresee
