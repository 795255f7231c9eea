#include "database/value_text.h"

#include <cstddef>
#include <new>

#include "base/integer_of.h"
#include "base/number_text.h"
#include "base/text/wkt_lexer.h"

namespace foresee {

namespace {

/// SQLite returns a null pointer for NULL, and for any value without memory.
std::string_view text_or_no_memory(int type, const unsigned char* text, int size) {
  if (text != nullptr) return {reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
  if (type != SQLITE_NULL) throw std::bad_alloc();
  return {};
}

}  // namespace

std::string_view cut_off(std::string_view text, std::size_t limit) {
  const auto is_inside_character = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
  };
  while (limit > 0 && limit < text.size() && is_inside_character(limit)) --limit;
  return text.substr(0, limit);
}

// The order matters: the type before the conversion, the size after it.
std::string text_of(sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  const unsigned char* text = sqlite3_value_text(value);
  return std::string(text_or_no_memory(type, text, sqlite3_value_bytes(value)));
}

std::string text_of(sqlite3_stmt* row, int column, std::size_t limit) {
  const int type = sqlite3_column_type(row, column);
  const unsigned char* text = sqlite3_column_text(row, column);
  return std::string(cut_off(text_or_no_memory(type, text, sqlite3_column_bytes(row, column)), limit));
}

bool is_null_or_empty(sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  return type == SQLITE_NULL || (type == SQLITE_TEXT && sqlite3_value_bytes(value) == 0);
}

std::string without_nul(std::string text) {
  for (std::size_t at = 0; (at = text.find('\0', at)) != std::string::npos;) text.replace(at, 1, "\\0");
  return text;
}

std::string shown(sqlite3_value* value) {
  constexpr std::size_t limit = 40;
  switch (sqlite3_value_type(value)) {
    case SQLITE_NULL:
      return "NULL";
    case SQLITE_INTEGER:
      return std::to_string(sqlite3_value_int64(value));
    case SQLITE_FLOAT:
      return shown(sqlite3_value_double(value));
    case SQLITE_BLOB:
      return "a blob of " + std::to_string(sqlite3_value_bytes(value)) + " bytes";
    default: {
      const std::string text = without_nul(text_of(value));
      if (text.size() <= limit) return std::string("'").append(text).append("'");
      return std::string("'").append(cut_off(text, limit)).append("...'");
    }
  }
}

bool is_inexact(sqlite3_value* value) {
  if (sqlite3_value_numeric_type(value) != SQLITE_INTEGER) return false;
  constexpr std::int64_t all_exact = std::int64_t{1} << 53;
  const std::int64_t integer = sqlite3_value_int64(value);
  if (-all_exact <= integer && integer <= all_exact) return false;
  return integer_of(sqlite3_value_double(value)) != integer;
}

std::optional<std::string> as_unixepoch(sqlite3_value* value) {
  if (sqlite3_value_type(value) != SQLITE_TEXT) return std::nullopt;
  const std::string text = text_of(value);
  if (sqlite3_stricmp(text.c_str(), "now") == 0) return "unixepoch('now')";
  const bool has_quote = text.find('\'') != std::string::npos;
  if (text.size() > 40 || has_quote || !starts_with_date(text)) return std::nullopt;
  return "unixepoch(" + shown(value) + ")";
}

}  // namespace foresee
