#include "sqlite/names/open_table.h"

#include <cstring>
#include <vector>

#include "sqlite/names/visible_tables.h"
#include "sqlite/sql_tokens.h"
#include "storage/rows/value_text.h"

namespace foresee {
namespace {

bool in_schema(const VisibleTable& table, const std::optional<std::string>& schema) {
  return !schema || same_name(table.schema, *schema);
}

/// Whether its name by itself means another table.
bool is_hidden(const VisibleTable& table, const std::vector<VisibleTable>& tables) {
  for (const VisibleTable& other : tables)
    if (same_name(other.name, table.name)) return &other != &table;
  return false;
}

/// " (moving_objects tables here: 'crates', 'ships' with schema = 'main')": as one has to write it.
std::string list_of(const std::vector<VisibleTable>& tables, bool with_schemas) {
  std::string list;
  for (const VisibleTable& table : tables) {
    if (!table.holds_moving_objects) continue;
    list += (list.empty() ? "" : ", ") + quoted(table.name);
    if (with_schemas || is_hidden(table, tables)) list += " with schema = " + quoted(table.schema);
  }
  return list.empty()
             ? " (there is no moving_objects table here; make one with CREATE VIRTUAL TABLE ships USING "
               "moving_objects(id, x, y, vx, vy))"
             : " (moving_objects tables here: " + list + ")";
}

/// The one table that is meant when nobody names one.
QueriedTable only_table(sqlite3* db, const std::optional<std::string>& schema) {
  const std::vector<VisibleTable> tables = visible_tables(db);
  const VisibleTable* only = nullptr;
  for (const VisibleTable& table : tables) {
    if (!table.holds_moving_objects || !in_schema(table, schema)) continue;
    if (only)
      throw Error("tbl is missing, and there is more than one table to query" +
                  list_of(tables, schema.has_value()));
    only = &table;
  }
  if (!only) throw Error("there is no table to query" + list_of(tables, schema.has_value()));
  return {only->name, only->schema};
}

/// What to write instead of 'main.ships'; "" if there is no such table either.
std::string with_schema_apart(const std::vector<VisibleTable>& tables, const std::string& name) {
  for (const VisibleTable& table : tables)
    if (table.holds_moving_objects && same_name(table.schema + "." + table.name, name))
      return "; give the schema by itself: " + quoted(table.name) + " with schema = " + quoted(table.schema);
  return "";
}

/// SQL's text ends at a NUL: no name has one.
bool can_be_named(const QueriedTable& name) {
  const std::string text = *name.table + name.schema.value_or("");
  return std::strlen(text.c_str()) == text.size();
}

/// The table that SQLite finds under this name, or nothing if it is none of ours. Throws StoreError where
/// SQLite finds none.
std::optional<Connection::OpenTable> find_open(Connection& connection, const QueriedTable& name) {
  TableLookups& lookups = connection.lookups();
  const auto find = [&]() -> const Connection::OpenTable* {
    const auto number = lookups.number_of(name);
    return number ? connection.find(*number) : nullptr;
  };
  const Connection::OpenTable* open = find();
  if (!open) {  // or SQLite has connected it anew since
    lookups.forget(name);
    open = find();
  }
  if (!open || !same_name(open->table, *name.table)) return std::nullopt;
  const Connection::OpenTable found = *open;
  // A table that is made in main would come before one that is attached from then on; nothing that is kept
  // would notice.
  if (name.schema || same_name(found.schema, "main") || same_name(found.schema, "temp"))
    lookups.keep(name, found.number, found.schema);
  return found;
}

}  // namespace

std::string quoted(const std::string& name) {
  return std::string("'") + without_nul(name) + "'";
}

void require_moving_objects(sqlite3* db, const std::string& table, const std::optional<std::string>& schema) {
  const std::string name = quoted(table) + (schema ? " in schema " + quoted(*schema) : "");
  const std::vector<VisibleTable> tables = visible_tables(db);
  for (const VisibleTable& seen : tables) {
    if (!same_name(seen.name, table) || !in_schema(seen, schema)) continue;
    if (seen.holds_moving_objects) return;
    throw Error(name + " is not a moving_objects table" +
                (seen.is_watch ? " but a watch: its pairs are SELECT * FROM " + seen.name : "") +
                list_of(tables, schema.has_value()));
  }
  throw Error("no such table: " + name + (schema ? "" : with_schema_apart(tables, table)) +
              list_of(tables, schema.has_value()));
}

Connection::OpenTable open_table(Connection& connection, const QueriedTable& queried) {
  const QueriedTable name = queried.table ? queried : only_table(connection.db(), queried.schema);
  try {
    if (can_be_named(name))
      if (auto open = find_open(connection, name)) return *open;
  } catch (const StoreError& error) {
    if ((error.code & 0xff) == SQLITE_ERROR)
      require_moving_objects(connection.db(), *name.table, name.schema);
    throw;
  }
  require_moving_objects(connection.db(), *name.table, name.schema);
  throw Error(*name.table + " does not answer as a moving_objects table does");
}

}  // namespace foresee
