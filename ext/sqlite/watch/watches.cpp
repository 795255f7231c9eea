#include "sqlite/watch/watches.h"

#include "database/sqlite_api.h"
#include "sqlite/callback.h"
#include "sqlite/names/open_table.h"
#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

/// Marks the watch as damaged after an update that failed half way. The rows that it wrote look as if their changes
/// were logged, so a later update would not log them.
void mark_damaged(WatchRows& rows, const char* reason) try {
  rows.write_damaged(reason);
} catch (const StoreError& error) {
  if (!error.is_of_contents()) throw;  // _meta is damaged too, which a reader detects
}

OpenTable find_table(Connection& connection, const std::string& schema, const std::string& name) {
  const TableName table{name, schema};
  if (const auto number = connection.lookups().kept_number(table))
    if (const OpenTable* open = connection.find(*number)) return *open;
  // A damaged file may name a watch, or a view of one: a query of it would recurse into this function.
  require_moving_objects(connection.db(), name, schema);
  return open_table(connection, table);
}

}  // namespace

OpenTables watched_tables(Connection& connection, const std::string& schema,
                          const WatchDeclaration& declaration) {
  OpenTables tables{find_table(connection, schema, declaration.tbl)};
  if (declaration.other) tables.b = find_table(connection, schema, *declaration.other);
  return tables;
}

Watches& watches_of(Connection& connection) {
  return static_cast<Watches&>(*connection.watches());
}

std::shared_ptr<WatchRows> Watches::rows(const QualifiedName& watch) {
  std::shared_ptr<WatchRows>& known = rows_[{watch.schema, watch.table}];
  if (!known) known = std::make_shared<WatchRows>(connection_.db(), watch);
  return known;
}

void Watches::forget(const QualifiedName& watch) noexcept {
  rows_.erase({watch.schema, watch.table});
}

std::optional<WatchState> Watches::known_state(const QualifiedName& watch) try {
  return rows(watch)->read_state();
} catch (const StoreError& error) {
  if (!error.is_of_contents()) throw;
  forget(watch);
  return std::nullopt;
}

void Watches::update(const QualifiedName& watch, PairUpdate::Log log) {
  const std::shared_ptr<WatchRows> rows = this->rows(watch);
  const WatchState before = rows->read_state();
  const OpenTables tables = watched_tables(connection_, watch.schema, before);
  // Again, at no cost, for a table that COMMIT has just synced. Its other table may still have unwritten changes.
  tables.a.store->sync();
  if (tables.b) tables.b->store->sync();
  PairUpdate update(sources_of(connection_, tables), before, *rows, resources_of(connection_));
  try {
    if (const auto after = update.run(log)) rows->write_state(*after, before);
  } catch (const StoreError& error) {
    if (error.is_of_contents() && update.has_written()) mark_damaged(*rows, error.what());
    throw;
  }
}

void Watches::update_if_sound(const QualifiedName& watch) try {
  const KeptInsertRowid kept(connection_.db());
  update(watch, PairUpdate::Log::changes);
} catch (const StoreError& error) {
  if (!error.is_of_contents()) throw;
  forget(watch);
} catch (const Error&) {
  forget(watch);  // one of its tables is missing or damaged; a read of the watch reports that
}

void Watches::update_watches_of(const OpenTable& table) {
  std::vector<std::string> names;
  try {
    names = table.store->watch_names();
  } catch (const StoreError& error) {
    if (!error.is_of_contents()) throw;  // without a name after a rollback, or damaged: no watches
  }
  for (const std::string& name : names) update_if_sound({table.schema, name});
}

template <class Change>
void Watches::change_stamp(const OpenTable& table, Change change) {
  const KeptInsertRowid kept(connection_.db());
  const auto before = table.store->stamp_if_written();
  change(*table.store);
  const auto after = table.store->stamp_if_written();
  for (const std::string& name : std::vector(table.store->watch_names())) {
    const QualifiedName watch{table.schema, name};
    const auto state = known_state(watch);
    if (!state || !before) continue;
    WatchState moved = *state;
    if (same_name(state->tbl, table.table) && state->stamp == before) moved.stamp = after;
    if (state->other && same_name(*state->other, table.table) && state->other_stamp == before)
      moved.other_stamp = after;
    rows(watch)->write_state(moved, *state);
  }
}

void Watches::add_to_tables(const QualifiedName& watch, const WatchDeclaration& declaration) {
  const OpenTables tables = watched_tables(connection_, watch.schema, declaration);
  const auto add = [&](Store& store) { store.add_watch(watch.table); };
  change_stamp(tables.a, add);
  if (tables.b && !tables.are_one()) change_stamp(*tables.b, add);
}

void Watches::remove_from_tables(const QualifiedName& watch, const WatchDeclaration& declaration) {
  const auto remove = [&](const std::string& name) {
    try {
      WatchDeclaration one = declaration;
      one.tbl = name;
      one.other.reset();
      change_stamp(watched_tables(connection_, watch.schema, one).a,
                   [&](Store& store) { store.remove_watch(watch.table); });
    } catch (const StoreError& error) {
      if (!error.is_of_contents()) throw;
    } catch (const Error&) {  // the table is missing, and its list with it
    }
  };
  remove(declaration.tbl);
  if (declaration.other && !same_name(*declaration.other, declaration.tbl)) remove(*declaration.other);
}

void Watches::rename_table(const OpenTable& table, const std::string& old_name) {
  const KeptInsertRowid kept(connection_.db());
  for (const std::string& name : std::vector(table.store->watch_names())) {
    auto state = known_state({table.schema, name});
    if (!state) continue;
    if (same_name(state->tbl, old_name)) state->tbl = table.table;
    if (state->other && same_name(*state->other, old_name)) state->other = table.table;
    rows({table.schema, name})->write_tables(*state);
  }
}

void Watches::require_frame(const OpenTable& table, const Frame& frame) {
  for (const std::string& name : std::vector(table.store->watch_names())) {
    std::string conflict;
    try {
      const auto state = known_state({table.schema, name});
      if (!state || !state->other) continue;
      const OpenTables tables = watched_tables(connection_, table.schema, *state);
      const OpenTable& other = tables.a.store == table.store ? *tables.b : tables.a;
      if (other.store != table.store)
        conflict = frame_conflict(other.table, other.store->frame(), table.table, frame);
    } catch (const StoreError& error) {
      if (!error.is_of_contents()) throw;
    } catch (const Error&) {  // the other table is missing or damaged; a read of the watch reports that
    }
    if (!conflict.empty()) throw Refusal(SQLITE_CONSTRAINT, name + ": " + conflict);
  }
}

void Watches::require_unwatched(const OpenTable& table) {
  try {
    for (const std::string& name : std::vector(table.store->watch_names())) {
      const auto state = known_state({table.schema, name});
      const bool is_watched = state && (same_name(state->tbl, table.table) ||
                                        (state->other && same_name(*state->other, table.table)));
      if (!is_watched) continue;
      const std::string message = table.table + " is watched by " + name + ": DROP TABLE " + name + " first";
      sqlite3_log(SQLITE_LOCKED, "%s", message.c_str());  // SQLite drops the message of xDestroy
      throw StoreError(SQLITE_LOCKED, message);
    }
  } catch (const StoreError& error) {
    if (!error.is_of_contents()) throw;  // a damaged table can be dropped
  }
}

}  // namespace foresee
