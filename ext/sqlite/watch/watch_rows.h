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

#include "query/watch/watch_state.h"
#include "storage/rows/shadow_tables.h"

namespace foresee {

/// True for pair, log and meta.
bool is_watch_suffix(std::string_view suffix);

class WatchRows final : public WatchPairs, public WatchLog {
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
  std::vector<WatchedPair> pairs() override;
  std::vector<WatchedPair> pairs_of_a(std::int64_t id) override;
  std::vector<WatchedPair> pairs_of_b(std::int64_t id) override;
  std::vector<WatchedPair> due_pairs(bool held, double until) override;
  std::optional<WatchedPair> pair(std::int64_t a, std::int64_t b) override;
  void write_pair(const WatchedPair& pair, PairWrite how, bool with_told) override;
  void erase_pair(std::int64_t a, std::int64_t b) override;
  /// Cost: the pages of the tables are released without reading rows.
  void erase_all_pairs() override;
  std::int64_t count_pairs(bool held);
  /// True if each index holds exactly the rows of the table.
  bool indexes_agree();

  // --- _log
  void append(const LoggedChange& change) override;
  void trim(std::int64_t up_to) override;
  /// The position after which changes can be read; nothing if the log is empty.
  std::optional<std::int64_t> oldest();
  /// At most `limit` changes with seq in (after, last], ascending.
  std::vector<LoggedChange> changes(std::int64_t after, std::int64_t last, std::int64_t limit);

 private:
  [[noreturn]] void damaged(const std::string& what) const;
  std::vector<WatchedPair> read_pairs(Statement::Run& run) const;
  bool has_pairs();
  static bool holds(Statement& index, std::span<const WatchedPair> pairs, bool with_due);
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
