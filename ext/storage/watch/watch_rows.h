// Every SQL statement that a predictive watch runs on its shadow tables, as plain functions.
//
//   <name>_pair(a, b, t, due, state, told, PRIMARY KEY(a, b)) WITHOUT ROWID    state 0 waits, 1 holds
//   <name>_log(seq INTEGER PRIMARY KEY, op, a, b, t, now)                      what changed
//   <name>_meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID                     watch_state.h
//
// Guarantee: each call sees and writes the database as this connection does now, so transactions, savepoints
// and crash recovery are SQLite's. Numbers are checked when they are read: SQLITE_CORRUPT_VTAB for values
// that no watch writes. Cost: a look-up or a row per call; statements are compiled once.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "storage/rows/shadow_tables.h"
#include "storage/watch/watch_state.h"

namespace foresee {

struct StoredPair {
  std::int64_t a, b;
  double t;
  std::optional<double> due;  ///< nothing: the clock never reaches it
  double told;
  bool held;
};

/// What writing a pair does to its row.
enum class PairWrite : std::uint8_t {
  adds,     ///< a new row
  moves,    ///< only times change, and no index does
  changes,  ///< any other change
};

struct StoredChange {
  std::int64_t seq;
  char op;
  std::int64_t a, b;
  double t;  ///< not stored for a removed pair
  double now;
};

/// True for pair, log and meta.
bool is_watch_suffix(std::string_view suffix);

class WatchRows {
 public:
  static ShadowTables tables(sqlite3* db, const QualifiedName& name);

  WatchRows(sqlite3* db, const QualifiedName& name);

  const QualifiedName& name() const { return name_; }

  // --- _meta
  WatchState read_state();
  void write_declaration(const WatchDeclaration& declaration);
  /// Writes what changes with time. Rows with an equal value are not written.
  void write_state(const WatchState& state, const WatchState& before);
  void write_asked(std::optional<double> time);
  void write_anew(bool anew);
  /// From now on read_state() reports damage.
  void write_damaged();
  void write_tables(const WatchDeclaration& declaration);

  // --- _pair
  std::vector<StoredPair> pairs();
  std::vector<StoredPair> pairs_of_a(std::int64_t id);
  std::vector<StoredPair> pairs_of_b(std::int64_t id);
  std::vector<StoredPair> due_pairs(bool held, double until);
  std::optional<StoredPair> pair(std::int64_t a, std::int64_t b);
  void write_pair(const StoredPair& pair, PairWrite how, bool with_told);
  void erase_pair(std::int64_t a, std::int64_t b);
  /// Cost: the pages of the tables are released without reading rows.
  void erase_all_pairs();
  std::int64_t count_pairs(bool held);
  /// True if each index holds exactly the rows of the table.
  bool indexes_agree();

  // --- _log
  void append(const StoredChange& change);
  void trim(std::int64_t up_to);
  /// The position after which changes can be read; nothing if the log is empty.
  std::optional<std::int64_t> oldest();
  /// At most `limit` changes with seq in (after, last], ascending.
  std::vector<StoredChange> changes(std::int64_t after, std::int64_t last, std::int64_t limit);

 private:
  [[noreturn]] void damaged(const std::string& what) const;
  std::vector<StoredPair> read_pairs(Statement::Run& run) const;
  bool has_pairs();
  static bool holds(Statement& index, std::span<const StoredPair> pairs, bool with_due);
  template <class Value>
  void write_meta(std::string_view key, const std::optional<Value>& value);
  template <class Value>
  void write_changed(std::string_view key, const Value& value, const Value& before);

  QualifiedName name_;
  Statement meta_, write_meta_;
  Statement pairs_, pairs_of_a_, pairs_of_b_, due_pairs_, pair_, any_pair_, count_pairs_, by_b_, by_due_;
  Statement add_pair_, move_pair_, change_pair_, erase_pair_, erase_all_pairs_;
  Statement append_, trim_, oldest_, changes_;
};

}  // namespace foresee
