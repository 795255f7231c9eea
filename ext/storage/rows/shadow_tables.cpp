#include "storage/rows/shadow_tables.h"

#include <algorithm>
#include <cstring>

#include "storage/rows/store_error.h"

namespace foresee::storage {
namespace {

std::string full_name(const QualifiedName& name, const std::string& suffix) {
  return format_sql("\"%w\".\"%w_%w\"", name.schema.c_str(), name.table.c_str(), suffix.c_str());
}

}  // namespace

bool is_one_of(std::string_view suffix, std::span<const char* const> suffixes) {
  for (const char* known : suffixes)
    if (suffix.size() == std::strlen(known) &&
        sqlite3_strnicmp(suffix.data(), known, static_cast<int>(suffix.size())) == 0)
      return true;
  return false;
}

void ShadowTables::create() const {
  std::string sql;
  for (const ShadowTable& table : tables_)
    sql += "CREATE TABLE " + full_name(name_, table.suffix) + table.definition + ";";
  execute(db_, sql);
}

void ShadowTables::rename(const std::string& new_table) const {
  for (const ShadowTable& table : tables_)
    execute(db_, "ALTER TABLE " + full_name(name_, table.suffix) +
                     format_sql(" RENAME TO \"%w_%w\"", new_table.c_str(), table.suffix.c_str()));
}

void ShadowTables::drop() const {
  for (const ShadowTable& table : tables_)
    execute(db_, "DROP TABLE IF EXISTS " + full_name(name_, table.suffix));
}

void ShadowTables::require_tables() const {
  // Names are compared here: a longer statement takes longer to compile than the few rows to read.
  Statement without_pages(db_, format_sql("SELECT name, type FROM \"%w\".sqlite_schema WHERE "
                                          "coalesce(rootpage, 0) <= 0",
                                          name_.schema.c_str()));
  Statement::Run run(without_pages);
  while (run.step()) {
    const std::string shadow = run.text(0), type = run.text(1);
    const bool is_view = type == "view";
    if ((!is_view && type != "table") || !is_ours(shadow)) continue;
    throw StoreError(SQLITE_CORRUPT_VTAB,
                     name_.table + ": " + shadow + " is a " + (is_view ? "view" : "virtual table") +
                         ", where foresee keeps a table of its own: DROP " + (is_view ? "VIEW " : "TABLE ") +
                         shadow + ", then DROP TABLE " + name_.table + " or restore what was there");
  }
}

bool ShadowTables::is_ours(const std::string& name) const {
  return std::any_of(tables_.begin(), tables_.end(), [&](const ShadowTable& table) {
    return sqlite3_stricmp(name.c_str(), (name_.table + "_" + table.suffix).c_str()) == 0;
  });
}

Statement ShadowTables::statement(const std::string& sql) const {
  std::string result;
  std::size_t done = 0;
  for (auto open = sql.find('{'); open != std::string::npos; open = sql.find('{', done)) {
    const auto close = sql.find('}', open);
    result += sql.substr(done, open - done);
    result += full_name(name_, sql.substr(open + 1, close - open - 1));
    done = close + 1;
  }
  return {db_, result + sql.substr(done)};
}

}  // namespace foresee::storage
