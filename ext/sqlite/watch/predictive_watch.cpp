// The virtual table predictive_watch: SQLite's callbacks. Each one delegates its work to another file:
//
//   CREATE  declare_watch.h     read  WatchCursor     commands  watch_commands.cpp     COMMIT  pair_update.h
#include <algorithm>
#include <utility>

#include "database/value_text.h"
#include "query/watch/pair_contacts.h"
#include "sqlite/callback.h"
#include "sqlite/functions/table_functions.h"
#include "sqlite/host_sqlite.h"
#include "sqlite/modules.h"
#include "sqlite/names/open_table.h"
#include "sqlite/watch/declare_watch.h"
#include "sqlite/watch/watch_table.h"

namespace foresee {
namespace {

using Holder = std::shared_ptr<Connection>;  // what pAux points to

WatchTable& table_of(sqlite3_vtab* base) {
  return *static_cast<WatchTable*>(base);
}
WatchCursor& cursor_of(sqlite3_vtab_cursor* base) {
  return *static_cast<WatchCursor*>(base);
}

std::unique_ptr<WatchTable> declare(sqlite3* db, void* aux, const char* const* argv) {
  sqlite3_vtab_config(db, SQLITE_VTAB_CONSTRAINT_SUPPORT, 1);
  sqlite3_vtab_config(db, SQLITE_VTAB_INNOCUOUS);
  const int rc = sqlite3_declare_vtab(db, declared_watch(argv[2]).c_str());
  if (rc != SQLITE_OK) throw StoreError(rc, std::string(argv[2]) + ": " + sqlite3_errmsg(db));
  return std::make_unique<WatchTable>(*static_cast<Holder*>(aux), QualifiedName{argv[1], argv[2]});
}

/// Validates the join query of the watch: throws for shapes without a distance, for different axes and frames.
void require_valid_query(Connection& connection, const QualifiedName& name,
                         const WatchDeclaration& declaration) try {
  require_tables(connection, name, declaration);
  const OpenTables tables = watched_tables(connection, name.schema, declaration);
  if (tables.b) require_one_frame(tables.a, *tables.b);
  require_upright(tables.a, declaration.within_z);
  const JoinQuestion question =
      question_of(sources_of(connection, tables), declaration, {0, declaration.horizon});
  require_valid(question);
  contact_of(question);
} catch (const StoreError&) {
  throw;
} catch (const Error& error) {
  throw Error(name.table + ": " + error.what());
}

int watch_create(sqlite3* db, void* aux, int argc, const char* const* argv, sqlite3_vtab** table,
                 char** message) noexcept {
  return guarded(message, [&] {
    const KeptInsertRowid kept(db);
    const WatchDeclaration declaration = parse_watch(argv[2], {argv + 3, argv + argc});
    std::unique_ptr<WatchTable> watch = declare(db, aux, argv);
    Connection& connection = *watch->connection;
    require_valid_query(connection, watch->name, declaration);
    WatchRows::tables(db, watch->name).create();
    watch->watches().forget(watch->name);
    watch->rows()->write_declaration(declaration);
    watch->watches().add_to_tables(watch->name, declaration);
    watch->watches().update(watch->name, PairUpdate::Log::nothing);
    *table = watch.release();
    return SQLITE_OK;
  });
}

int watch_connect(sqlite3* db, void* aux, int, const char* const* argv, sqlite3_vtab** table,
                  char** message) noexcept {
  return guarded(message, [&] {
    *table = declare(db, aux, argv).release();
    return SQLITE_OK;
  });
}

int watch_disconnect(sqlite3_vtab* base) noexcept {
  delete &table_of(base);
  return SQLITE_OK;
}

int watch_destroy(sqlite3_vtab* base) noexcept {
  const int rc = guarded(&base->zErrMsg, [&] {
    WatchTable& table = table_of(base);
    Connection& connection = *table.connection;
    try {
      table.watches().remove_from_tables(table.name, table.rows()->read_state());
    } catch (const StoreError& error) {  // damaged or missing: it can still be dropped
      if (!error.is_of_contents()) throw;
    }
    table.watches().forget(table.name);
    WatchRows::tables(connection.db(), table.name).drop();
  });
  return rc == SQLITE_OK ? watch_disconnect(base) : rc;
}

/// The first usable equality with a column; -1: none.
int find_equality(const sqlite3_index_info& info, int column) {
  for (int i = 0; i < info.nConstraint; ++i) {
    const auto& constraint = info.aConstraint[i];
    if (constraint.usable && constraint.iColumn == column && constraint.op == SQLITE_INDEX_CONSTRAINT_EQ)
      return i;
  }
  return -1;
}

/// The unit is that of a look-up by id in a watched table (table_plan.cpp). Each read of a watch first compares its
/// state with the tables; so to read all pairs once costs less than to read those of each of a hundred objects.
void estimate(sqlite3_index_info& info, bool of_one, double pairs) {
  constexpr double start = 100, pair = 2, objects = 1000;
  const double rows = of_one ? std::max(1.0, pairs / objects) : pairs;
  info.estimatedRows = static_cast<sqlite3_int64>(rows);
  info.estimatedCost = start + pair * rows;
}

int watch_best_index(sqlite3_vtab* base, sqlite3_index_info* info) noexcept {
  int plan = 0, arguments = 0;
  const int a = find_equality(*info, watch_a), b = find_equality(*info, watch_b);
  const bool has_both = a >= 0 && b >= 0, leaves_a = has_both && is_spare_list(*info, a, b),
             leaves_b = has_both && is_spare_list(*info, b, a);
  if (a >= 0 && !leaves_a) {
    info->aConstraintUsage[a].argvIndex = ++arguments;
    plan |= WatchPlan::by_a;
  }
  if (b >= 0 && !leaves_b) {
    info->aConstraintUsage[b].argvIndex = ++arguments;
    plan |= WatchPlan::by_b;
  }
  const auto reads = [&](int first, int last) {
    const auto columns = (std::uint64_t{2} << last) - (std::uint64_t{1} << first);
    return (info->colUsed & columns) != 0;
  };
  if (reads(watch_t_end, watch_dt_end)) plan |= WatchPlan::times;
  if (reads(watch_t_cpa, watch_d_cpa)) plan |= WatchPlan::approach;
  info->idxNum = plan;
  estimate(*info, arguments > 0, table_of(base).likely_pairs);
  return SQLITE_OK;
}

int cursor_open(sqlite3_vtab* base, sqlite3_vtab_cursor** cursor) noexcept {
  return guarded(&base->zErrMsg, [&] { *cursor = new WatchCursor(table_of(base)); });
}

int cursor_close(sqlite3_vtab_cursor* base) noexcept {
  delete &cursor_of(base);
  return SQLITE_OK;
}

int cursor_filter(sqlite3_vtab_cursor* base, int plan, const char*, int, sqlite3_value** arguments) noexcept {
  return guarded(&base->pVtab->zErrMsg, [&] { cursor_of(base).filter(plan, arguments); });
}

int cursor_next(sqlite3_vtab_cursor* base) noexcept {
  return guarded(&base->pVtab->zErrMsg, [&] { cursor_of(base).next(); });
}

int cursor_eof(sqlite3_vtab_cursor* base) noexcept {
  return cursor_of(base).at_end() ? 1 : 0;
}

int cursor_column(sqlite3_vtab_cursor* base, sqlite3_context* context, int column) noexcept {
  cursor_of(base).column(context, column);
  return SQLITE_OK;
}

int cursor_rowid(sqlite3_vtab_cursor*, sqlite3_int64* rowid) noexcept {
  *rowid = 0;  // WITHOUT ROWID: SQLite never calls this
  return SQLITE_OK;
}

/// Throws Error for a row that is not a command. `new_clock`: the value for `now`.
[[noreturn]] void refuse_row(WatchTable& table, bool inserts, sqlite3_value* command,
                             sqlite3_value* new_clock) {
  const std::string &name = table.name.table, insert = "INSERT INTO " + name + "(" + name;
  const WatchState state = table.rows()->read_state();
  if (!inserts && sqlite3_value_type(command) != SQLITE_NULL)
    throw Error(name + "." + name + " takes commands by INSERT only; write " + insert +
                ") VALUES('rebuild')");
  const bool is_clock =
      sqlite3_value_type(new_clock) == SQLITE_NULL || sqlite3_value_double(new_clock) == state.now();
  if (!is_clock)
    throw Error(name + ": the clock moves by a command; write " + insert + ", now) VALUES('advance', " +
                shown(new_clock) + ")");
  throw Error(name + " is kept by foresee: change " + state.tbl + " instead");
}

int watch_update(sqlite3_vtab* base, int count, sqlite3_value** arguments, sqlite3_int64* rowid) noexcept {
  return guarded(&base->zErrMsg, [&] {
    WatchTable& table = table_of(base);
    if (count == 1)
      throw Error(table.name.table + " is kept by foresee: change " + table.rows()->read_state().tbl +
                  " instead");
    const bool inserts = sqlite3_value_type(arguments[0]) == SQLITE_NULL;
    sqlite3_value *const command = arguments[2 + watch_command], *const now = arguments[2 + watch_now];
    if (!inserts || sqlite3_value_type(command) == SQLITE_NULL) refuse_row(table, inserts, command, now);
    run_watch_command(table, command, now);
    *rowid = sqlite3_last_insert_rowid(table.connection->db());  // which SQLite sets to this
  });
}

int watch_begin(sqlite3_vtab*) noexcept {
  return SQLITE_OK;
}

int watch_sync(sqlite3_vtab* base) noexcept {
  return guarded(&base->zErrMsg, [&] {
    WatchTable& table = table_of(base);
    table.watches().update_if_sound(table.name);
    for (const std::string& name : table.old_names)
      table.watches().update_if_sound({table.name.schema, name});
  });
}

int watch_rename(sqlite3_vtab* base, const char* new_name) noexcept {
  return guarded(&base->zErrMsg, [&] {
    WatchTable& table = table_of(base);
    Connection& connection = *table.connection;
    const WatchState state = table.rows()->read_state();
    const bool has_key_tables = table.rows()->has_key_tables();
    const bool was_up_to_date =
        is_up_to_date(connection, state, watched_tables(connection, table.name.schema, state));
    parse_watch(new_name, {"ships", "horizon = 0"});  // throws for a name that a watch cannot have
    table.watches().remove_from_tables(table.name, state);
    table.watches().forget(table.name);
    WatchRows::tables(connection.db(), table.name, has_key_tables).rename(new_name);
    table.old_names.push_back(std::exchange(table.name.table, new_name));
    table.watches().add_to_tables(table.name, state);
    if (!was_up_to_date) return;
    WatchState moved = state;
    const OpenTables tables = watched_tables(connection, table.name.schema, state);
    moved.stamp = tables.a.store->stamp_if_written();
    if (tables.b) moved.other_stamp = tables.b->store->stamp_if_written();
    table.rows()->write_state(moved, state);
  });
}

int is_shadow_name(const char* suffix) noexcept {
  return is_watch_suffix(suffix) ? 1 : 0;
}

constexpr sqlite3_module watch_module = {
    .iVersion = 3,
    .xCreate = watch_create,
    .xConnect = watch_connect,
    .xBestIndex = watch_best_index,
    .xDisconnect = watch_disconnect,
    .xDestroy = watch_destroy,
    .xOpen = cursor_open,
    .xClose = cursor_close,
    .xFilter = cursor_filter,
    .xNext = cursor_next,
    .xEof = cursor_eof,
    .xColumn = cursor_column,
    .xRowid = cursor_rowid,
    .xUpdate = watch_update,
    .xBegin = watch_begin,
    .xSync = watch_sync,
    .xCommit = nullptr,
    .xRollback = nullptr,
    .xFindFunction = nullptr,
    .xRename = watch_rename,
    .xSavepoint = nullptr,
    .xRelease = nullptr,
    .xRollbackTo = nullptr,
    .xShadowName = is_shadow_name,
#if SQLITE_VERSION_NUMBER >= 3044000
    .xIntegrity = nullptr,
#endif
};

}  // namespace

int register_predictive_watch(sqlite3* db, const std::shared_ptr<Connection>& connection) {
  connection->keep_watches(std::make_unique<Watches>(*connection));
  int rc = sqlite3_create_module_v2(db, "predictive_watch", &watch_module, new Holder(connection),
                                    [](void* aux) { delete static_cast<Holder*>(aux); });
  for (const TableFunction* function : {&predictive_changes(), &predictive_watches()})
    if (rc == SQLITE_OK) rc = register_table_function(db, *function, connection);
  return rc;
}

}  // namespace foresee
