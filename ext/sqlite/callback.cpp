#include "sqlite/callback.h"

#include <exception>
#include <new>

#include "database/sqlite_api.h"
#include "index/pages.h"

namespace foresee {
namespace {

/// The bytes of the character that starts here; 0 if they are not UTF-8. Safe before the NUL that ends a text.
int size_of_character(const unsigned char* text) {
  const auto continues = [&](int i, unsigned char from = 0x80, unsigned char to = 0xBF) {
    return from <= text[i] && text[i] <= to;
  };
  const unsigned char first = *text;
  if (first < 0x80) return 1;
  if (0xC2 <= first && first <= 0xDF) return continues(1) ? 2 : 0;
  if (0xE0 <= first && first <= 0xEF)
    return continues(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF) && continues(2) ? 3 : 0;
  if (0xF0 <= first && first <= 0xF4)
    return continues(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF) && continues(2) &&
                   continues(3)
               ? 4
               : 0;
  return 0;
}

/// A message may quote bytes of a damaged file or a wrong value: those that are not UTF-8 become '?', since hosts such
/// as Python fail to decode the message otherwise.
void mend_utf8(char* message) {
  for (auto* text = reinterpret_cast<unsigned char*>(message); *text != 0;) {
    const int size = size_of_character(text);
    if (size == 0) *text = '?';
    text += size == 0 ? 1 : size;
  }
}

int report(char** message, int code, const char* text) noexcept {
  if (message == nullptr) return code;  // an application may pass null to the entry point
  sqlite3_free(*message);
  *message = sqlite3_mprintf("%s", text);
  if (*message != nullptr) mend_utf8(*message);
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

void result_error(sqlite3_context* context, int rc, char* message) noexcept {
  if (rc == SQLITE_NOMEM || (message == nullptr && rc != SQLITE_INTERRUPT))
    sqlite3_result_error_nomem(context);
  else if (message != nullptr)
    sqlite3_result_error(context, message, -1);
  if (rc == SQLITE_INTERRUPT) sqlite3_result_error_code(context, rc);
  sqlite3_free(message);
}

}  // namespace foresee
