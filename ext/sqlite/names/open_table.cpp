#include "sqlite/names/open_table.h"

#include <cstring>
#include <vector>

#include "database/value_text.h"
#include "sqlite/names/visible_tables.h"
#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

bool in_schema(const VisibleTable& table, const std::optional<std::string>& schema) {
  return !schema || same_name(table.schema, *schema);
}

/// Whether SQLite resolves its unqualified name to another table.
bool is_hidden(const VisibleTable& table, const std::vector<VisibleTable>& tables) {
  for (const VisibleTable& other : tables)
    if (same_name(other.name, table.name)) return &other != &table;
  return false;
}

constexpr int max_listed = 12;

/// " (moving_objects tables here: 'crates', 'ships' with schema = 'main')": each as a query must write it. The first
/// ones, if there are many.
std::string list_tables(const std::vector<VisibleTable>& tables, bool with_schemas) {
  std::string list;
  int listed = 0;
  for (const VisibleTable& table : tables) {
    if (!table.holds_moving_objects || ++listed > max_listed) continue;
    list += (list.empty() ? "" : ", ") + quoted(table.name);
    if (with_schemas || is_hidden(table, tables)) list += " with schema = " + quoted(table.schema);
  }
  return list.empty()
             ? " (no moving_objects table here; make one with CREATE VIRTUAL TABLE ships USING "
               "moving_objects(id, x, y, vx, vy))"
             : " (moving_objects tables here: " + list +
                   (listed > max_listed ? " and " + std::to_string(listed - max_listed) + " more)" : ")");
}

/// The only moving_objects table, for a query without a table name. Throws Error unless there is exactly one.
TableName only_table(sqlite3* db, const std::optional<std::string>& schema) {
  const std::vector<VisibleTable> tables = visible_tables(db);
  const VisibleTable* only = nullptr;
  for (const VisibleTable& table : tables) {
    if (!table.holds_moving_objects || !in_schema(table, schema)) continue;
    if (only)
      throw Error("tbl is missing; write the name of one table" + list_tables(tables, schema.has_value()));
    only = &table;
  }
  if (!only) throw Error("there is no table to query" + list_tables(tables, schema.has_value()));
  return {only->name, only->schema};
}

/// The hint to write the schema of a name like 'main.ships' separately; "" if that table does not exist
/// either.
std::string separate_schema_hint(const std::vector<VisibleTable>& tables, const std::string& name) {
  for (const VisibleTable& table : tables)
    if (table.holds_moving_objects && same_name(table.schema + "." + table.name, name))
      return "; write the schema separately: " + quoted(table.name) +
             " with schema = " + quoted(table.schema);
  return "";
}

/// Whether SQL text, which ends at a NUL, can hold this name.
bool fits_in_sql(const TableName& name) {
  const std::string text = *name.table + name.schema.value_or("");
  return std::strlen(text.c_str()) == text.size();
}

/// The table that SQLite finds under this name; nothing if it is not a moving_objects table. Throws
/// StoreError if SQLite finds no table.
std::optional<OpenTable> find_open(Connection& connection, const TableName& name) {
  TableLookups& lookups = connection.lookups();
  const auto find = [&]() -> const OpenTable* {
    const auto number = lookups.number_of(name);
    return number ? connection.find(*number) : nullptr;
  };
  const OpenTable* open = find();
  if (!open) {  // SQLite may have reconnected the table since
    lookups.forget(name);
    open = find();
  }
  if (!open || !same_name(open->table, *name.table)) return std::nullopt;
  const OpenTable found = *open;
  // A look-up that found an attached database's table is not kept: a table created in main later would
  // precede it, and the witness would not detect that.
  if (name.schema || same_name(found.schema, "main") || same_name(found.schema, "temp"))
    lookups.keep(name, found.number, found.schema);
  return found;
}

}  // namespace

void require_one_frame(const OpenTable& a, const OpenTable& b) {
  const std::string conflict = frame_conflict(a.table, a.store->frame(), b.table, b.store->frame());
  if (!conflict.empty()) throw Error(conflict);
}

void require_upright(const OpenTable& table, const std::optional<double>& within_z) {
  if (within_z && table.store->declaration().frame.on_globe())
    throw Error("within_z is for tables whose z points up, and " + table.table +
                " is on the globe; leave it out: within covers every direction");
}

std::string quoted(const std::string& name) {
  return std::string("'") + without_nul(name) + "'";
}

void require_moving_objects(sqlite3* db, const std::string& table, const std::optional<std::string>& schema) {
  if (schema)
    for (const VisibleTable& seen : visible_tables(db, *schema))
      if (same_name(seen.name, table) && seen.holds_moving_objects) return;
  const std::string name = quoted(table) + (schema ? " in schema " + quoted(*schema) : "");
  const std::vector<VisibleTable> tables = visible_tables(db);
  for (const VisibleTable& seen : tables) {
    if (!same_name(seen.name, table) || !in_schema(seen, schema)) continue;
    if (seen.holds_moving_objects) return;
    throw Error(name + " is not a moving_objects table" +
                (seen.is_watch ? " but a watch: its pairs are SELECT * FROM " + seen.name : "") +
                list_tables(tables, schema.has_value()));
  }
  throw Error("no such table: " + name + (schema ? "" : separate_schema_hint(tables, table)) +
              list_tables(tables, schema.has_value()));
}

OpenTable open_table(Connection& connection, const TableName& given) {
  const TableName name = given.table ? given : only_table(connection.db(), given.schema);
  try {
    if (fits_in_sql(name))
      if (auto open = find_open(connection, name)) return *open;
  } catch (const StoreError& error) {
    if (error.primary() == SQLITE_ERROR) require_moving_objects(connection.db(), *name.table, name.schema);
    throw;
  }
  require_moving_objects(connection.db(), *name.table, name.schema);
  throw Error(*name.table + " does not answer as a moving_objects table does");
}

}  // namespace foresee
