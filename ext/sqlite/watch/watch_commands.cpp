// Commands of a watch: 'advance', 'rebuild' and 'integrity-check'. The first two set a key of _meta that the
// commit evaluates, so savepoints and rollbacks undo them.
#include <algorithm>
#include <cmath>

#include "database/value_text.h"
#include "query/watch/pair_contacts.h"
#include "sqlite/callback.h"
#include "sqlite/watch/watch_table.h"

namespace foresee {
namespace {

double time_of(const WatchTable& table, sqlite3_value* now) {
  if (is_inexact(now))
    throw Error(table.name.table + ": 'advance' needs a time that a double holds exactly, not " + shown(now));
  const int type = sqlite3_value_numeric_type(now);
  const double time = sqlite3_value_double(now);
  if ((type == SQLITE_INTEGER || type == SQLITE_FLOAT) && std::isfinite(time)) return time;
  const std::string advance =
      "INSERT INTO " + table.name.table + "(" + table.name.table + ", now) VALUES('advance', ";
  throw Error(table.name.table + ": 'advance' needs a time, as in " + advance +
              as_unixepoch(now).value_or("1260.0") + "); not " + shown(now));
}

std::vector<ShownPair> joined_pairs(Connection& connection, const OpenTables& tables,
                                    const WatchState& state) {
  JoinQuestion question = question_of_all(sources_of(connection, tables), state, {state.now(), state.horizon},
                                          resources_of(connection));
  question.wants.ends = false;
  Join join(std::move(question), connection.interrupt());
  std::vector<ShownPair> pairs;
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows) pairs.push_back({row.a, row.b, row.contact.t});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::string name_of(const ShownPair& pair) {
  return "pair (" + std::to_string(pair.a) + ", " + std::to_string(pair.b) + ")";
}

}  // namespace

// A watch that is not up to date is read by the join, so only its keys can be wrong.
std::string watch_fault(WatchTable& table) {
  Connection& connection = *table.connection;
  const std::shared_ptr<WatchRows> rows = table.rows();
  const WatchState state = rows->read_state();
  const std::string& name = table.name.table;
  if (!rows->keys_agree())
    return rows->has_key_tables()
               ? name + "_back and " + name + "_due do not hold the keys of " + name + "_pair"
               : "the indexes of " + name + "_pair do not hold its rows";
  const OpenTables tables = watched_tables(connection, table.name.schema, state);
  if (!is_up_to_date(connection, state, tables)) return "";
  std::vector<ShownPair> shown_pairs;
  for (const WatchedPair& pair : rows->pairs())
    if (pair.is_reported()) shown_pairs.push_back({pair.a, pair.b, std::max(pair.t, state.now())});
  std::sort(shown_pairs.begin(), shown_pairs.end());
  const std::vector<ShownPair> joined = joined_pairs(connection, tables, state);
  const auto [stored, expected] =
      std::mismatch(shown_pairs.begin(), shown_pairs.end(), joined.begin(), joined.end());
  if (stored == shown_pairs.end() && expected == joined.end()) return "";
  if (expected == joined.end() || (stored != shown_pairs.end() && *stored < *expected))
    return name_of(*stored) + " is stored, but predictive_join does not return it with this time";
  return name_of(*expected) + " is a row of predictive_join, but is not stored with this time";
}

void run_watch_command(WatchTable& table, sqlite3_value* command, sqlite3_value* now) {
  const KeptInsertRowid kept(table.connection->db());
  const std::string word = sqlite3_value_type(command) == SQLITE_TEXT ? text_of(command) : "";
  const std::string& name = table.name.table;
  if (word == "advance") {
    const double time = time_of(table, now);
    const std::shared_ptr<WatchRows> rows = table.rows();
    rows->read_state();  // throws for a damaged watch
    rows->write_requested_clock(time);
  } else if (word == "rebuild") {
    const std::shared_ptr<WatchRows> rows = table.rows();
    rows->read_state();  // throws for a damaged watch
    rows->write_must_rebuild(true);
  } else if (word == "integrity-check") {
    const std::string fault = watch_fault(table);
    if (!fault.empty()) throw StoreError(SQLITE_CORRUPT_VTAB, name + ": " + fault);
  } else {
    throw Error(name + ": no command " + shown(command) +
                "; known: 'advance', 'rebuild' and 'integrity-check'");
  }
}

}  // namespace foresee
