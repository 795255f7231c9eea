// How storage says what went wrong.
#pragma once

#include <string>

#include "base/error.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

/// A failure of SQLite or of the stored bytes; `code` is what the callback returns.
struct StoreError : Error {
  StoreError(int code, const std::string& message) : Error(message), code(code) {}
  int code;
};

}  // namespace foresee
