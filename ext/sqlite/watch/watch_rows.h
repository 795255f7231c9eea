// Every SQL statement that a predictive watch runs on its shadow tables, as plain functions.
//
//   <name>_pair(a, b, t, due, state, told, PRIMARY KEY(a, b)) WITHOUT ROWID    state 0 waits, 1 reported
//   <name>_back, <name>_due                                                    keys of pairs: pair_keys.h
//   <name>_log(seq INTEGER PRIMARY KEY, op, a, b, t, now)                      what changed
//   <name>_meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID                     watch_state.h
//
// Guarantee: each call sees and writes the database as this connection does now, so transactions, savepoints
// and crash recovery are SQLite's; keys of pairs wait for write_keys(). Numbers are checked when they are read:
// SQLITE_CORRUPT_VTAB for values that no watch writes. Cost: a look-up or a row per call; statements are compiled
// once.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "database/shadow_tables.h"
#include "query/watch/watch_state.h"
#include "sqlite/watch/pair_keys.h"

namespace foresee {

/// True for pair, back, due, log and meta.
bool is_watch_suffix(std::string_view suffix);

class WatchRows final : public WatchStorage {
 public:
  /// `has_key_tables`: false for a watch of an older version, whose pairs have indexes.
  static ShadowTables tables(sqlite3* db, const QualifiedName& name, bool has_key_tables = true);

  WatchRows(sqlite3* db, const QualifiedName& name);

  const QualifiedName& name() const { return name_; }
  /// As the last read_state() found.
  bool has_key_tables() const { return has_key_tables_.value_or(true); }

  // --- _meta
  /// Also prepares the statements of pairs, and forgets keys that a failed update has left.
  WatchState read_state();
  void write_declaration(const WatchDeclaration& declaration);
  /// Writes what changes with time. Rows with an equal value are not written.
  void write_state(const WatchState& state, const WatchState& before);
  void write_requested_clock(std::optional<double> time);
  void write_must_rebuild(bool must_rebuild);
  /// From now on read_state() reports damage, with the reason why the watch could not be updated.
  void write_damaged(std::string_view reason);
  void write_tables(const WatchDeclaration& declaration);

  // --- _pair and its keys; requires: read_state() was called
  std::vector<WatchedPair> pairs() override;
  std::vector<WatchedPair> stored_pairs_of(std::span<const std::int64_t> a,
                                           std::span<const std::int64_t> b) override;
  std::vector<WatchedPair> due_pairs(PairState state, double until) override;
  std::optional<WatchedPair> pair(std::int64_t a, std::int64_t b) override;
  void write_pair(const WatchedPair* before, const WatchedPair& pair, bool with_reported_t) override;
  void erase_pair(const WatchedPair& pair) override;
  /// Cost: the pages of the tables are released without reading rows.
  void erase_all_pairs() override;
  void write_keys() override;
  std::int64_t count_pairs(PairState state);
  /// True if each key table, or index, holds exactly the keys of the rows.
  bool keys_agree() { return keys_.agree(pairs()); }

  // --- _log
  void append(const LoggedChange& change) override;
  void trim(std::int64_t up_to) override;
  /// The position after which changes can be read; nothing if the log is empty.
  std::optional<std::int64_t> readable_after();
  /// At most `limit` changes with seq in (after, last], ascending.
  std::vector<LoggedChange> changes(std::int64_t after, std::int64_t last, std::int64_t limit);

 private:
  struct PairStatements {
    Statement all, of_a, one, any, count;
    Statement add, move, change, erase, erase_all;
  };
  struct LogStatements {
    Statement append, trim, oldest, after;
  };

  [[noreturn]] void damaged(const std::string& what) const;
  void use_pairs(bool with_key_tables);
  void read_pairs(Statement::Run& run, std::vector<WatchedPair>& pairs) const;
  std::vector<WatchedPair> pairs_with(std::vector<PairIds> keys);
  bool has_pairs();
  template <class Value>
  void write_meta(std::string_view key, const std::optional<Value>& value);
  template <class Value>
  void write_changed(std::string_view key, const Value& value, const Value& before);

  sqlite3* db_;
  QualifiedName name_;
  std::optional<bool> has_key_tables_;  ///< nothing: not known yet
  PairKeys keys_;
  Statement meta_, write_meta_;
  PairStatements pairs_;
  LogStatements log_;
};

}  // namespace foresee
