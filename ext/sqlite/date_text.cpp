#include "sqlite/date_text.h"

#include <string_view>

#include "storage/rows/value_text.h"

namespace foresee {

std::optional<std::string> as_unixepoch(sqlite3_value* value) {
  if (sqlite3_value_type(value) != SQLITE_TEXT) return std::nullopt;
  const std::string text = text_of(value);
  if (sqlite3_stricmp(text.c_str(), "now") == 0) return "unixepoch('now')";
  constexpr std::string_view date = "dddd-dd-dd";
  if (text.size() < date.size() || text.size() > 40) return std::nullopt;
  for (std::size_t i = 0; i < date.size(); ++i) {
    const bool fits = date[i] == 'd' ? text[i] >= '0' && text[i] <= '9' : text[i] == date[i];
    if (!fits) return std::nullopt;
  }
  return "unixepoch(" + shown(value) + ")";
}

}  // namespace foresee
