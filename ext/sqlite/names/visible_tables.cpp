#include "sqlite/names/visible_tables.h"

#include "database/statement.h"
#include "sqlite/host_sqlite.h"
#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

void add_tables(sqlite3* db, const std::string& schema, std::vector<VisibleTable>& tables) {
  Statement select(
      db, "SELECT name, sql FROM " + quoted_name(schema) + ".sqlite_master WHERE type IN ('table', 'view')");
  Statement::Run run(select);
  while (run.step()) {
    const std::string sql = run.text(1);
    tables.push_back({schema, run.text(0), uses_moving_objects(sql), uses_module(sql, "predictive_watch")});
  }
}

}  // namespace

bool uses_module(const std::string& sql, std::string_view module) {
  SqlTokens tokens(sql);
  const auto next_is = [&](std::string_view name) {
    const auto token = tokens.next();
    return token && same_name(token->text, name);
  };
  if (!next_is("create") || !next_is("virtual") || !next_is("table")) return false;
  tokens.next();  // the table's name
  return next_is("using") && next_is(module);
}

std::vector<VisibleTable> visible_tables(sqlite3* db) {
  std::vector<VisibleTable> tables;
  for (const std::string& schema : schema_names(db)) add_tables(db, schema, tables);
  return tables;
}

std::vector<VisibleTable> visible_tables(sqlite3* db, const std::string& schema) {
  std::vector<VisibleTable> tables;
  for (const std::string& known : schema_names(db))
    if (same_name(known, schema)) add_tables(db, known, tables);
  return tables;
}

}  // namespace foresee
