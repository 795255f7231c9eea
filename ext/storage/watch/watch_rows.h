// Every statement that a watch runs on its shadow tables, as plain calls.
//
//   <name>_pair(a, b, t, due, state, told, PRIMARY KEY(a, b)) WITHOUT ROWID    state 0 waits, 1 holds
//   <name>_log(seq INTEGER PRIMARY KEY, op, a, b, t, now)                      what changed
//   <name>_meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID                     watch_state.h
//
// Guarantee: each call sees and writes the database as this connection does now, so transactions, savepoints
// and crashes are SQLite's. Numbers are checked when they are read: SQLITE_CORRUPT_VTAB for what no watch has
// written. Cost: a look-up or a row each; statements are compiled once.
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
  std::optional<double> due;  ///< none: nothing that the clock reaches
  double told;
  bool held;
};

/// What writing a pair does to its row.
enum class PairWrite : std::uint8_t {
  adds,     ///< there is none
  moves,    ///< only times differ, and no index
  changes,  ///< anything else
};

struct StoredChange {
  std::int64_t seq;
  char op;
  std::int64_t a, b;
  double t;  ///< nothing of what is gone
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
  /// All that moves. Rows that say the same already are not written.
  void write_state(const WatchState& state, const WatchState& before);
  void write_asked(std::optional<double> time);
  void write_anew(bool anew);
  /// From now on read_state() says so.
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
  /// Cost: the pages of the tables are let go, no row is looked at.
  void erase_all_pairs();
  std::int64_t count_pairs(bool held);
  /// Whether each index holds the rows, and nothing else.
  bool indexes_agree();

  // --- _log
  void append(const StoredChange& change);
  void trim(std::int64_t up_to);
  /// The position from which on changes can be read; nothing: there are none.
  std::optional<std::int64_t> oldest();
  /// At most `limit` of them, seq in (after, last], rising.
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
