#include "storage/rows/text.h"

#include <cstddef>
#include <new>

namespace foresee {
namespace {

/// SQLite says null for NULL, and out of memory for anything.
std::string text_or_no_memory(int type, const unsigned char* text, int size) {
  if (text != nullptr) return {reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
  if (type != SQLITE_NULL) throw std::bad_alloc();
  return "";
}

}  // namespace

// Asked in this order: the type before it is converted, the size of what it was converted to.
std::string text_of(sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  const unsigned char* text = sqlite3_value_text(value);
  return text_or_no_memory(type, text, sqlite3_value_bytes(value));
}

std::string text_of(sqlite3_stmt* row, int column) {
  const int type = sqlite3_column_type(row, column);
  const unsigned char* text = sqlite3_column_text(row, column);
  return text_or_no_memory(type, text, sqlite3_column_bytes(row, column));
}

std::string without_nul(std::string text) {
  for (std::size_t at = 0; (at = text.find('\0', at)) != std::string::npos;) text.replace(at, 1, "\\0");
  return text;
}

}  // namespace foresee
