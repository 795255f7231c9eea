// Exception of storage: an error message with SQLite's result code.
#pragma once

#include <string>

#include "base/error.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

/// An error of SQLite or damage of the stored bytes; `code` is the result code of the callback.
struct StoreError : Error {
  StoreError(int code, const std::string& message) : Error(message), code(code) {}
  int code;
};

}  // namespace foresee
