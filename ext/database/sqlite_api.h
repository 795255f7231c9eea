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
  /// Without the extension by which SQLite says more.
  int primary() const noexcept { return code & 0xff; }
  bool is_damage() const noexcept override { return primary() == SQLITE_CORRUPT; }
  /// Damage, or a table that is missing: to repeat the statement does not help, and SQLite keeps the transaction.
  bool is_of_contents() const noexcept { return is_damage() || primary() == SQLITE_ERROR; }
  int code;
};

}  // namespace foresee
