#include "database/shadow_tables.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "database/sqlite_api.h"

namespace foresee {

bool is_one_of(std::string_view suffix, std::span<const char* const> suffixes) {
  for (const char* known : suffixes)
    if (suffix.size() == std::strlen(known) &&
        sqlite3_strnicmp(suffix.data(), known, static_cast<int>(suffix.size())) == 0)
      return true;
  return false;
}

void throw_damaged(const QualifiedName& name, const std::string& what) {
  throw StoreError(SQLITE_CORRUPT_VTAB, name.table + ": " + what);
}

std::string without_name(const QualifiedName& name, std::string_view message) {
  const std::string front = name.table + ": ";
  if (message.starts_with(front)) message.remove_prefix(front.size());
  return std::string(message);
}

ShadowTables::ShadowTables(sqlite3* db, QualifiedName name, std::vector<ShadowTable> tables)
    : db_(db),
      name_(std::move(name)),
      tables_(std::move(tables)),
      prefix_(format_sql("\"%w\".\"%w_", name_.schema.c_str(), name_.table.c_str())) {}

void ShadowTables::create() const {
  std::string sql;
  for (const ShadowTable& table : tables_)
    sql += "CREATE TABLE " + full_name(table.suffix) + table.definition + ";";
  execute(db_, sql);
}

void ShadowTables::rename(const std::string& new_table) const {
  for (const ShadowTable& table : tables_)
    execute(db_, "ALTER TABLE " + full_name(table.suffix) +
                     format_sql(" RENAME TO \"%w_%w\"", new_table.c_str(), table.suffix.c_str()));
}

void ShadowTables::drop() const {
  for (const ShadowTable& table : tables_) execute(db_, "DROP TABLE IF EXISTS " + full_name(table.suffix));
}

/// False if one is a view, which has no columns of its own, or a virtual table: then no statement may name
/// it. False also if one is missing, or SQLite cannot tell.
bool ShadowTables::are_tables() const try {
  std::string sql = "SELECT 1 FROM ";
  for (const ShadowTable& table : tables_) {
    const int known =
        sqlite3_table_column_metadata(db_, name_.schema.c_str(), (name_.table + "_" + table.suffix).c_str(),
                                      nullptr, nullptr, nullptr, nullptr, nullptr, nullptr);
    if (known == SQLITE_NOMEM) throw std::bad_alloc();
    if (known != SQLITE_OK) return false;
    sql += (&table == tables_.data() ? "" : ", ") + full_name(table.suffix);
  }
  Statement(db_, sql).prepare();
  return true;
} catch (const StoreError& error) {
  if (!error.is_of_contents() && error.primary() != SQLITE_AUTH) throw;
  return false;
}

void ShadowTables::require_tables() const {
  if (are_tables()) return;
  Statement without_pages(db_, format_sql("SELECT name, type FROM \"%w\".sqlite_schema WHERE "
                                          "coalesce(rootpage, 0) <= 0",
                                          name_.schema.c_str()));
  Statement::Run run(without_pages);
  while (run.step()) {
    const std::string shadow = run.text(0), type = run.text(1);
    const bool is_view = type == "view";
    if ((!is_view && type != "table") || !is_shadow_table(shadow)) continue;
    throw StoreError(SQLITE_CORRUPT_VTAB,
                     name_.table + ": " + shadow + " is a " + (is_view ? "view" : "virtual table") +
                         ", where foresee keeps a table of its own: DROP " + (is_view ? "VIEW " : "TABLE ") +
                         shadow + ", then DROP TABLE " + name_.table + " or restore what was there");
  }
}

bool ShadowTables::is_shadow_table(const std::string& name) const {
  return std::any_of(tables_.begin(), tables_.end(), [&](const ShadowTable& table) {
    return sqlite3_stricmp(name.c_str(), (name_.table + "_" + table.suffix).c_str()) == 0;
  });
}

Statement ShadowTables::statement(const std::string& sql) const {
  std::string result;
  std::size_t done = 0;
  for (auto open = sql.find('{'); open != std::string::npos; open = sql.find('{', done)) {
    const auto close = sql.find('}', open);
    result.append(sql, done, open - done);
    result.append(prefix_).append(sql, open + 1, close - open - 1).append(1, '"');
    done = close + 1;
  }
  return {db_, result.append(sql, done)};
}

}  // namespace foresee
