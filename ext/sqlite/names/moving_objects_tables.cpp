#include "sqlite/names/moving_objects_tables.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <string_view>

#include "sqlite/host.h"
#include "sqlite/names/select.h"

namespace foresee {
namespace {

/// The words of an SQL text one after another: names without their quotes, everything else a letter at a
/// time.
class Words {
 public:
  explicit Words(std::string_view rest) : rest_(rest) {}

  /// The next word in lower case; "" at the end.
  std::string next() {
    skip_space();
    if (rest_.empty()) return "";
    const char first = rest_.front();
    if (std::strchr("\"'`[", first)) return quoted(first == '[' ? ']' : first);
    std::size_t length = 0;
    while (length < rest_.size() && is_name(rest_[length])) ++length;
    return lower(take(std::max<std::size_t>(length, 1)));
  }

 private:
  static bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '$' || (c & 0x80);
  }

  static std::string lower(std::string_view word) {
    std::string text(word);
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  }

  std::string_view take(std::size_t length) {
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(taken.size());
    return taken;
  }

  void skip_past(std::string_view end, std::size_t from) {
    const std::size_t found = rest_.find(end, from);
    take(found == std::string_view::npos ? rest_.size() : found + end.size());
  }

  void skip_space() {
    for (;;) {
      if (rest_.starts_with("--"))
        skip_past("\n", 2);
      else if (rest_.starts_with("/*"))
        skip_past("*/", 2);
      else if (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())))
        take(1);
      else
        return;
    }
  }

  /// A name in quotes; the closing quote stands for itself where it is doubled.
  std::string quoted(char close) {
    take(1);
    std::string name;
    while (!rest_.empty()) {
      const char c = take(1).front();
      if (c == close && (close == ']' || rest_.empty() || rest_.front() != close)) break;
      if (c == close) take(1);
      name += c;
    }
    return lower(name);
  }

  std::string_view rest_;
};

void add_tables(sqlite3* db, const std::string& schema, std::vector<VisibleTable>& tables) {
  Select select(db, "SELECT name, sql FROM \"%w\".sqlite_master WHERE type IN ('table', 'view')",
                schema.c_str());
  while (select.step()) tables.push_back({schema, select.text(0), uses_moving_objects(select.text(1))});
}

}  // namespace

bool uses_moving_objects(const std::string& sql) {
  Words words(sql);
  if (words.next() != "create" || words.next() != "virtual" || words.next() != "table") return false;
  words.next();  // the table's name
  return words.next() == "using" && words.next() == "moving_objects";
}

std::vector<VisibleTable> visible_tables(sqlite3* db) {
  std::vector<VisibleTable> tables;
  for (const std::string& schema : schema_names(db)) add_tables(db, schema, tables);
  return tables;
}

}  // namespace foresee
