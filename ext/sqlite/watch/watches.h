// Maintenance of all watches of a connection: updates them at COMMIT and follows renames of their tables.
//
//   Watches& watches = watches_of(connection);
//   watches.rows({"main", "alerts"})->read_state();
//   watches.update_if_sound({"main", "alerts"});         // in xSync of a watch or of its tables
//
// A table stores the names of its watches (Store::watch_names), a watch those of its tables. When a table
// commits, a damaged or missing watch is skipped without an error. A statement that reads the watch gets the
// error.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "query/watch/pair_update.h"
#include "sqlite/stored_table.h"
#include "sqlite/watch/watch_rows.h"
#include "sqlite/watch_upkeep.h"

namespace foresee {

class Watches final : public WatchUpkeep {
 public:
  /// `connection` owns this.
  explicit Watches(Connection& connection) : connection_(connection) {}

  /// The prepared statements of a watch, from a cache. Throws StoreError if a shadow table is not a table.
  std::shared_ptr<WatchRows> rows(const QualifiedName& watch);
  void forget(const QualifiedName& watch) noexcept;

  /// Brings the rows of the watch up to date with its tables. `log`: `nothing` for a new watch, which no reader knows
  /// yet. Throws StoreError or Error if the watch or a table cannot be read.
  void update(const QualifiedName& watch, PairUpdate::Log log);
  /// update() that logs changes. Does nothing for a damaged or missing watch.
  void update_if_sound(const QualifiedName& watch);
  /// Adds the watch to the lists of its tables, or removes it. Their other watches stay up to date.
  void add_to_tables(const QualifiedName& watch, const WatchDeclaration& declaration);
  void remove_from_tables(const QualifiedName& watch, const WatchDeclaration& declaration);

  void update_watches_of(const OpenTable& table) override;
  void rename_table(const OpenTable& table, const std::string& old_name) override;
  void require_unwatched(const OpenTable& table) override;
  void require_frame(const OpenTable& table, const Frame& frame) override;
  void finalize() noexcept override { rows_.clear(); }

 private:
  /// The stored state of the watch; nothing if it is damaged or missing.
  std::optional<WatchState> known_state(const QualifiedName& watch);
  /// Runs `change`, which writes a new stamp of the table. Watches that were up to date stay so.
  template <class Change>
  void change_stamp(const OpenTable& table, Change change);

  Connection& connection_;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<WatchRows>> rows_;
};

/// The watched tables, by the declared names in the schema of the watch. Throws Error if one does not exist.
OpenTables watched_tables(Connection& connection, const std::string& schema,
                          const WatchDeclaration& declaration);

/// The watches of a connection. Requires: register_predictive_watch has run.
Watches& watches_of(Connection& connection);

}  // namespace foresee
