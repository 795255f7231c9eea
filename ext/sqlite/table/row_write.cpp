#include "sqlite/table/row_write.h"

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "database/value_text.h"
#include "sqlite/callback.h"
#include "sqlite/table/table_cursor.h"
#include "sqlite/table/table_declaration.h"

namespace foresee {

namespace {

/// The arguments of an xUpdate call that inserts or updates a row, by name. SQLite passes the old id, the new rowid,
/// then the columns as declared: id, motion, auxiliary, command, hidden. This only points at them.
struct NewRow {
  NewRow(const MovingObjectsTable& table, sqlite3_value** arguments)
      : rowid(arguments[1]),
        id(arguments[2 + MovingObjectsTable::id_column]),
        motion(arguments + 2 + MovingObjectsTable::first_motion_column),
        auxiliaries(arguments + 2 + table.first_auxiliary_column(), table.declaration().auxiliaries.size()),
        command(arguments[2 + table.command_column()]),
        hidden(arguments + 3 + table.command_column(), hidden_columns(table.declaration()).size()) {}

  sqlite3_value* rowid;
  sqlite3_value* id;
  sqlite3_value** motion;
  std::span<sqlite3_value*> auxiliaries;
  sqlite3_value* command;
  std::span<sqlite3_value*> hidden;  ///< x, y, vx, vy of a table in degrees; on the globe gx, …
};

bool is_null(sqlite3_value* value) {
  return sqlite3_value_type(value) == SQLITE_NULL;
}

/// An object has the id of the new row: throws Refusal unless the statement is OR REPLACE.
void require_replace(const MovingObjectsTable& table) {
  if (sqlite3_vtab_on_conflict(table.connection->db()) == SQLITE_REPLACE) return;
  throw Refusal(SQLITE_CONSTRAINT, "UNIQUE constraint failed: " + table.name + ".id");
}

/// Whether an UPDATE leaves a hidden column alone: it is the stored number, or was when the statement started.
bool is_left_alone(MovingObjectsTable& table, std::int64_t id, std::size_t hidden, sqlite3_value* value) {
  if (sqlite3_value_type(value) != SQLITE_FLOAT) return false;
  const double number = sqlite3_value_double(value);
  const auto record = table.store().read(id);
  if (record && (*record)[table.hidden_place(hidden)] == number) return true;
  const auto before = table.stored_before.find(id);
  return before != table.stored_before.end() && before->second[table.hidden_place(hidden)] == number;
}

/// The hidden columns follow from lat, lon, speed, course: refuses another value.
void require_unwritten(MovingObjectsTable& table, const NewRow& row, std::optional<std::int64_t> updated) {
  for (std::size_t i = 0; i < row.hidden.size(); ++i) {
    sqlite3_value* value = row.hidden[i];
    if (sqlite3_value_nochange(value) || (!updated && is_null(value))) continue;
    if (updated && is_left_alone(table, *updated, i, value)) continue;
    throw Refusal(SQLITE_CONSTRAINT, table.name + "." + std::string(hidden_columns(table.declaration())[i]) +
                                         " follows from lat, lon, speed, course; write these");
  }
}

/// Whether an UPDATE passes columns that follow from others as they were when it started.
bool passes_columns_at_start(const MovingObjectsTable& table, const NewRow& row) {
  if (!row.hidden.empty() && !sqlite3_value_nochange(row.hidden[0])) return true;
  const Declaration& declaration = table.declaration();
  if (!declaration.layout.has_plan) return false;
  const int x = record_offsets(declaration.layout).x;
  for (std::size_t i = 0; i < declaration.columns.size(); ++i)
    if (declaration.columns[i].place == x) return !sqlite3_value_nochange(row.motion[i]);
  return false;
}

/// Before an UPDATE of a table in degrees or with plans: keeps the record of the row for
/// MovingObjectsTable::stored_before. Of other tables nothing is kept.
void keep_record(MovingObjectsTable& table, const NewRow& row, std::int64_t id) {
  if (!passes_columns_at_start(table, row)) return;
  if (auto record = table.store().read(id)) table.stored_before.try_emplace(id, std::move(*record));
}

/// The record of stored_before; empty: it is not kept.
std::span<const double> record_at_start(const MovingObjectsTable& table, std::int64_t id) {
  const auto kept = table.stored_before.find(id);
  return kept == table.stored_before.end() ? std::span<const double>() : kept->second;
}

/// The first position of a table may choose an origin that is not that of a table it is watched with.
void require_frame_of_watches(MovingObjectsTable& table, const std::optional<LatLon>& origin) {
  if (!origin) return;
  Frame frame = table.declaration().frame;
  frame.origin = origin;
  if (WatchUpkeep* watches = table.connection->watches()) watches->require_frame(table.opened(), frame);
}

std::int64_t insert_row(MovingObjectsTable& table, const NewRow& row) {
  if (!is_null(row.command)) {
    run_command(table, row.command);
    return sqlite3_last_insert_rowid(table.connection->db());  // which SQLite sets to this
  }
  // `INSERT INTO ships(rowid, ...)` sets the id by its alias.
  std::optional<std::int64_t> id = table.reader.id(row.id);
  if (!id) id = table.reader.id(row.rowid);
  const bool assigned = !id;
  require_unwritten(table, row, {});
  if (assigned) id = table.store().find_next_id();
  const NewRecord made = table.reader.read(*id, row.motion, table.store());
  if (!assigned && table.store().contains(*id)) {
    require_replace(table);
    table.store().update(*id, *id, made.record, row.auxiliaries, made.plan);
  } else {
    require_frame_of_watches(table, made.origin);
    table.store().insert(*id, made.record, row.auxiliaries, made.origin, made.plan);
  }
  return *id;
}

/// SQLite computes the values of an UPDATE from the objects at its start, and passes none for columns that it leaves
/// alone: these are read now. If another object has the id meanwhile (OR REPLACE), they would be that one's.
void require_not_replaced(const MovingObjectsTable& table, std::int64_t id) {
  if (table.moved_to.empty() || !table.moved_to.contains(id)) return;
  throw Refusal(SQLITE_CONSTRAINT, table.name + ": row " + std::to_string(id) +
                                       " was replaced by an earlier row of this UPDATE; write DELETE first, "
                                       "or ids that no row has");
}

void update_row(MovingObjectsTable& table, std::int64_t old_id, const NewRow& row) {
  if (!is_null(row.command))
    throw Error(table.name + "." + table.name + " takes commands by INSERT only; write INSERT INTO " +
                table.name + "(" + table.name + ") VALUES('rebuild')");
  // Either of `SET id = ...` and `SET rowid = ...` changes the id.
  std::optional<std::int64_t> id = table.reader.id(row.id, old_id);
  if (id == old_id) id = table.reader.id(row.rowid, old_id);
  if (!id)
    throw Refusal(SQLITE_MISMATCH, table.name + ".id of row " + std::to_string(old_id) +
                                       " would become NULL: every object has an id; write an INTEGER");
  require_not_replaced(table, old_id);
  require_unwritten(table, row, old_id);
  const UpdatedRow updated{old_id, record_at_start(table, old_id), !sqlite3_value_nochange(row.command)};
  const NewRecord made = table.reader.read(*id, row.motion, table.store(), updated);
  if (*id != old_id && table.store().contains(*id)) require_replace(table);
  keep_record(table, row, old_id);
  table.store().update(old_id, *id, made.record, row.auxiliaries, made.plan);
  if (*id != old_id) table.moved_to.insert(*id);
}

}  // namespace

void write_row(MovingObjectsTable& table, int count, sqlite3_value** arguments, sqlite3_int64* rowid) {
  for (TableCursor* cursor : table.cursors()) cursor->keep_ids();
  if (count == 1) {
    table.store().erase(sqlite3_value_int64(arguments[0]));
  } else if (is_null(arguments[0])) {
    *rowid = insert_row(table, NewRow(table, arguments));
  } else {
    update_row(table, sqlite3_value_int64(arguments[0]), NewRow(table, arguments));
  }
}

void require_integrity(MovingObjectsTable& table) {
  constexpr std::size_t limit = 5;
  const std::vector<std::string> findings = table.store().integrity_check(table.connection->interrupt());
  if (findings.empty()) return;
  const std::string name = table.name + ": ";  // each finding starts with it
  std::string text;
  for (std::size_t i = 0; i < findings.size() && i < limit; ++i)
    text += (i == 0 ? "" : "; ") + findings[i].substr(findings[i].starts_with(name) ? name.size() : 0);
  if (findings.size() > limit) text += "; and " + std::to_string(findings.size() - limit) + " more";
  throw StoreError(SQLITE_CORRUPT_VTAB, name + text);
}

void run_command(MovingObjectsTable& table, sqlite3_value* command) {
  const std::string word = sqlite3_value_type(command) == SQLITE_TEXT ? text_of(command) : "";
  if (word == "rebuild") {
    table.store().rebuild(table.connection->interrupt());
  } else if (word == "optimize") {
    table.store().optimize(table.connection->interrupt());
  } else if (word == "integrity-check") {
    require_integrity(table);
  } else {
    throw Error(table.name + ": no command " + shown(command) +
                "; known: 'rebuild', 'optimize' and 'integrity-check'");
  }
}

}  // namespace foresee
