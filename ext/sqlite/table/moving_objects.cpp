// The virtual table moving_objects: SQLite's callbacks. Each one delegates its work to another file:
//
//   CREATE  table_declaration.h      plan  table_plan.h      scan  table_cursor.h
//   write  row_write.h, record_values.h
//   transactions, savepoints, rename and drop: Store, whose methods have the names of the callbacks
#include "sqlite/callback.h"
#include "sqlite/modules.h"
#include "sqlite/table/moving_objects_table.h"
#include "sqlite/table/row_write.h"
#include "sqlite/table/table_cursor.h"
#include "sqlite/table/table_declaration.h"
#include "sqlite/table/table_plan.h"
#include "storage/rows/shadow_schema.h"

namespace foresee {
namespace {

using OpenStore = StoreOrFault (*)(sqlite3* db, const std::string& schema, const std::string& table,
                                   const Declaration& declaration);

StoreOrFault create_store(sqlite3* db, const std::string& schema, const std::string& table,
                          const Declaration& declaration) {
  return {.store = Store::create(db, schema, table, declaration)};
}

/// Connects a table even if its bytes cannot be read; otherwise DROP TABLE would fail.
StoreOrFault open_store(sqlite3* db, const std::string& schema, const std::string& table,
                        const Declaration& declaration) try {
  return {.store = Store::open(db, schema, table, declaration)};
} catch (const StoreError& error) {
  if (!error.is_of_contents()) throw;  // busy, out of memory: temporary
  return {.store = nullptr, .fault = error};
}

/// If this version cannot parse the declaration, a later version may have created the table: then the error
/// names the stored features that are unknown.
Declaration declaration_of(OpenStore open, sqlite3* db, const std::string& schema, const std::string& name,
                           const std::vector<std::string_view>& arguments) try {
  return parse_declaration(name, arguments);
} catch (const Error&) {
  if (open == open_store) refuse_unknown_features(db, {schema, name});
  throw;
}

using Holder = std::shared_ptr<Connection>;  // what pAux points to

int connect(OpenStore open, sqlite3* db, void* aux, int argc, const char* const* argv, sqlite3_vtab** table,
            char** message) noexcept {
  return guarded(message, [&] {
    const std::string schema = argv[1];
    const std::string name = argv[2];
    const Declaration declaration = declaration_of(open, db, schema, name, {argv + 3, argv + argc});
    sqlite3_vtab_config(db, SQLITE_VTAB_CONSTRAINT_SUPPORT, 1);
    sqlite3_vtab_config(db, SQLITE_VTAB_INNOCUOUS);
    const int rc = sqlite3_declare_vtab(db, declared_schema(declaration, name).c_str());
    if (rc != SQLITE_OK) throw StoreError(rc, name + ": " + sqlite3_errmsg(db));
    *table = new MovingObjectsTable(*static_cast<Holder*>(aux), declaration,
                                    open(db, schema, name, declaration), schema, name);
    return SQLITE_OK;
  });
}

int table_create(sqlite3* db, void* aux, int argc, const char* const* argv, sqlite3_vtab** table,
                 char** message) noexcept {
  return connect(create_store, db, aux, argc, argv, table, message);
}

int table_connect(sqlite3* db, void* aux, int argc, const char* const* argv, sqlite3_vtab** table,
                  char** message) noexcept {
  return connect(open_store, db, aux, argc, argv, table, message);
}

int table_disconnect(sqlite3_vtab* base) noexcept {
  delete &table_of(base);
  return SQLITE_OK;
}

int table_destroy(sqlite3_vtab* base) noexcept {
  const int rc = guarded(&base->zErrMsg, [&] {
    MovingObjectsTable& table = table_of(base);
    if (WatchUpkeep* watches = table.connection->watches(); watches && table.has_store())
      watches->require_unwatched(table.opened());
    table.drop();
  });
  return rc == SQLITE_OK ? table_disconnect(base) : rc;
}

int table_best_index(sqlite3_vtab* base, sqlite3_index_info* info) noexcept {
  return guarded(&base->zErrMsg, [&] { return plan_table(table_of(base), info); });
}

int cursor_open(sqlite3_vtab* base, sqlite3_vtab_cursor** cursor) noexcept {
  return guarded(&base->zErrMsg, [&] { *cursor = new TableCursor(table_of(base)); });
}

int cursor_close(sqlite3_vtab_cursor* base) noexcept {
  delete &cursor_of(base);
  return SQLITE_OK;
}

int cursor_filter(sqlite3_vtab_cursor* base, int plan, const char*, int, sqlite3_value** arguments) noexcept {
  return guarded(&base->pVtab->zErrMsg, [&] { cursor_of(base).filter(TablePlan::of(plan), arguments); });
}

int cursor_next(sqlite3_vtab_cursor* base) noexcept {
  return guarded(&base->pVtab->zErrMsg, [&] { cursor_of(base).next(); });
}

int cursor_eof(sqlite3_vtab_cursor* base) noexcept {
  return cursor_of(base).at_end() ? 1 : 0;
}

int cursor_column(sqlite3_vtab_cursor* base, sqlite3_context* context, int column) noexcept {
  return guarded(&base->pVtab->zErrMsg, [&] { cursor_of(base).column(context, column); });
}

int cursor_rowid(sqlite3_vtab_cursor* base, sqlite3_int64* rowid) noexcept {
  *rowid = cursor_of(base).rowid();
  return SQLITE_OK;
}

int table_update(sqlite3_vtab* base, int count, sqlite3_value** arguments, sqlite3_int64* rowid) noexcept {
  return guarded(&base->zErrMsg, [&] { write_row(table_of(base), count, arguments, rowid); });
}

/// A callback that calls one method of the store; does nothing if the store cannot be read.
template <void (Store::*step)()>
int store_step(sqlite3_vtab* base) noexcept {
  MovingObjectsTable& table = table_of(base);
  if (!table.has_store()) return SQLITE_OK;
  return guarded(&base->zErrMsg, [&] { (table.store().*step)(); });
}

template <void (Store::*step)(int)>
int store_step(sqlite3_vtab* base, int level) noexcept {
  MovingObjectsTable& table = table_of(base);
  if (!table.has_store()) return SQLITE_OK;
  return guarded(&base->zErrMsg, [&] { (table.store().*step)(level); });
}

/// Writes the changed objects as rows, then updates the watches of the table.
int table_sync(sqlite3_vtab* base) noexcept {
  MovingObjectsTable& table = table_of(base);
  if (!table.has_store() || table.store().is_gone()) return SQLITE_OK;
  return guarded(&base->zErrMsg, [&] {
    table.store().sync();
    if (WatchUpkeep* watches = table.connection->watches()) watches->update_watches_of(table.opened());
  });
}

void abort_scans(MovingObjectsTable& table) noexcept {
  for (TableCursor* cursor : table.cursors()) cursor->abort();
}

int table_rollback(sqlite3_vtab* base) noexcept {
  abort_scans(table_of(base));
  return store_step<&Store::rollback>(base);
}

int table_rollback_to(sqlite3_vtab* base, int level) noexcept {
  MovingObjectsTable& table = table_of(base);
  // A statement that fails on another table rolls back to its start, which changes nothing here.
  if (table.has_store() && table.store().rollback_to(level)) abort_scans(table);
  return SQLITE_OK;
}

int table_rename(sqlite3_vtab* base, const char* new_name) noexcept {
  return guarded(&base->zErrMsg, [&] {
    MovingObjectsTable& table = table_of(base);
    for (TableCursor* cursor : table.cursors()) cursor->keep_ids();
    const std::string old_name = table.name;
    table.rename(new_name);
    if (WatchUpkeep* watches = table.connection->watches()) watches->rename_table(table.opened(), old_name);
  });
}

int is_shadow_name(const char* suffix) noexcept {
  return is_shadow_suffix(suffix) ? 1 : 0;
}

/// PRAGMA integrity_check, from SQLite 3.44 on: findings are returned as text, not as a result code.
int table_integrity(sqlite3_vtab* base, const char*, const char*, int, char** finding) noexcept {
  const int rc = guarded(finding, [&] { require_integrity(table_of(base)); });
  const bool is_missing = rc == SQLITE_ERROR;  // a shadow table, which SQLite's message alone names
  if (is_missing && *finding) *finding = sqlite3_mprintf("%s: %z", table_of(base).name.c_str(), *finding);
  const bool is_finding = is_missing || (rc & 0xff) == SQLITE_CORRUPT;
  return is_finding && *finding != nullptr ? SQLITE_OK : rc;
}

/// sqlite3_module as SQLite 3.44 declares it; older versions read only the members of iVersion 3.
struct ModuleWithIntegrity {
  sqlite3_module module;
  int (*xIntegrity)(sqlite3_vtab*, const char*, const char*, int, char**);
};

constexpr ModuleWithIntegrity moving_objects_module = {{
                                                           .iVersion = 4,
                                                           .xCreate = table_create,
                                                           .xConnect = table_connect,
                                                           .xBestIndex = table_best_index,
                                                           .xDisconnect = table_disconnect,
                                                           .xDestroy = table_destroy,
                                                           .xOpen = cursor_open,
                                                           .xClose = cursor_close,
                                                           .xFilter = cursor_filter,
                                                           .xNext = cursor_next,
                                                           .xEof = cursor_eof,
                                                           .xColumn = cursor_column,
                                                           .xRowid = cursor_rowid,
                                                           .xUpdate = table_update,
                                                           .xBegin = store_step<&Store::begin>,
                                                           .xSync = table_sync,
                                                           .xCommit = store_step<&Store::commit>,
                                                           .xRollback = table_rollback,
                                                           .xFindFunction = nullptr,
                                                           .xRename = table_rename,
                                                           .xSavepoint = store_step<&Store::savepoint>,
                                                           .xRelease = store_step<&Store::release>,
                                                           .xRollbackTo = table_rollback_to,
                                                           .xShadowName = is_shadow_name,
#if SQLITE_VERSION_NUMBER >= 3044000
                                                           .xIntegrity = table_integrity,
#endif
                                                       },
                                                       table_integrity};

}  // namespace

int register_moving_objects(sqlite3* db, const std::shared_ptr<Connection>& connection) {
  // SQLite destroys the holder also when it fails.
  return sqlite3_create_module_v2(db, "moving_objects", &moving_objects_module.module, new Holder(connection),
                                  [](void* aux) { delete static_cast<Holder*>(aux); });
}

}  // namespace foresee
