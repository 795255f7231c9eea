#include "sqlite/callback.h"

#include <exception>
#include <new>

#include "index/pages.h"
#include "storage/rows/store_error.h"

namespace foresee {
namespace {

int report(char** message, int code, const char* text) noexcept {
  if (message == nullptr) return code;  // an application may pass null to the entry point
  sqlite3_free(*message);
  *message = sqlite3_mprintf("%s", text);
  return code;
}

}  // namespace

int code_of_exception(char** message) noexcept {
  try {
    throw;
  } catch (const StoreError& error) {
    return report(message, error.code, error.what());
  } catch (const Refusal& error) {
    return report(message, error.code, error.what());
  } catch (const BrokenTree& error) {
    return report(message, SQLITE_CORRUPT_VTAB, error.what());
  } catch (const Interrupted&) {
    return SQLITE_INTERRUPT;
  } catch (const std::bad_alloc&) {
    return SQLITE_NOMEM;
  } catch (const std::exception& error) {
    return report(message, SQLITE_ERROR, error.what());
  } catch (...) {
    return SQLITE_ERROR;
  }
}

}  // namespace foresee
