// Exception barrier of the SQLite callbacks: guarded() turns an exception into a result code and a message.
// Every callback runs its body in it, so no exception crosses the C boundary.
//
//   return guarded(&cursor->pVtab->zErrMsg, [&] { next(cursor); });        // in xNext
//
// Error becomes SQLITE_ERROR; StoreError and Refusal carry their own code; BrokenTree becomes
// SQLITE_CORRUPT_VTAB, std::bad_alloc SQLITE_NOMEM, Interrupted SQLITE_INTERRUPT.
#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "base/error.h"
#include "database/sqlite_api.h"

namespace foresee {

/// A refused request with its result code: SQLITE_CONSTRAINT for values and conflicts (which OR IGNORE
/// skips), SQLITE_MISMATCH for an id that is not an integer.
struct Refusal : Error {
  Refusal(int code, const std::string& message) : Error(message), code(code) {}
  int code;
};

/// The result code of the exception in flight. Replaces `*message` by the exception's message, in SQLite's
/// memory. Requires: called from a catch block.
int code_of_exception(char** message) noexcept;

/// Runs `body`, which returns a result code or nothing (SQLITE_OK). Returns that code, or the code of the
/// exception that it throws. `message` is a virtual table's &zErrMsg or a constructor's pzErr.
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

/// Gives a scalar or aggregate function the error of guarded(), and frees `message`.
void result_error(sqlite3_context* context, int rc, char* message) noexcept;

/// Runs the body of such a function; an exception becomes its error, with the function's name in front.
template <class Body>
void report_by_name(sqlite3_context* context, const char* name, Body&& body) noexcept {
  char* message = nullptr;
  const int rc = guarded(&message, std::forward<Body>(body));
  if (message != nullptr) message = sqlite3_mprintf("%s: %z", name, message);
  if (rc != SQLITE_OK) result_error(context, rc, message);
}

}  // namespace foresee
