// How does a C++ failure reach SQLite? Every callback runs its body in guarded(), so that no exception
// crosses the C boundary: it becomes a result code and, where there is one to tell, a message.
//
//   return guarded(&cursor->pVtab->zErrMsg, [&] { next(cursor); });        // in xNext
//
// Error becomes SQLITE_ERROR; StoreError and Refusal bring their own code; BrokenTree becomes
// SQLITE_CORRUPT_VTAB, std::bad_alloc SQLITE_NOMEM, Interrupted SQLITE_INTERRUPT.
#pragma once

#include <string>
#include <type_traits>

#include "base/error.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

/// What was asked is refused with this result code: SQLITE_CONSTRAINT for values and conflicts (which
/// OR IGNORE skips), SQLITE_MISMATCH for an id that is no integer.
struct Refusal : Error {
  Refusal(int code, const std::string& message) : Error(message), code(code) {}
  int code;
};

/// The result code of the exception in flight; its message goes to `*message`, in SQLite's memory, in place
/// of what was there. Requires: called from a catch block.
int code_of_exception(char** message) noexcept;

/// Runs `body`, which returns a result code or nothing (SQLITE_OK), and answers for what it throws. `message`
/// is a virtual table's &zErrMsg or a constructor's pzErr.
template <class Body>
int guarded(char** message, Body&& body) noexcept {
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<Body>>) {
      body();
      return SQLITE_OK;
    } else {
      return body();
    }
  } catch (...) {
    return code_of_exception(message);
  }
}

}  // namespace foresee
