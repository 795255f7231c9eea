// Which watches are there, and who keeps them? The upkeep of all watches of a connection.
//
//   Watches& watches = watches_of(connection);
//   watches.rows(connection, {"main", "alerts"})->read_state();
//   watches.settle(connection, {"main", "alerts"});      // in xSync of a watch or of its tables
//
// A table knows the names of its watches (Store::watches), a watch those of its tables. A watch that is
// damaged or gone is passed over when its table commits, and is no reason to refuse anything; its own reader
// is told.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "sqlite/connection.h"
#include "sqlite/watch_upkeep.h"
#include "storage/watch/watch_rows.h"

namespace foresee {

class Watches final : public WatchUpkeep {
 public:
  /// The statements of a watch, compiled once. Throws StoreError where its tables are no tables.
  std::shared_ptr<WatchRows> rows(Connection& connection, const QualifiedName& watch);
  void forget(const QualifiedName& watch) noexcept;

  /// Changes become rows of the watch, or it stays as it is.
  void settle(Connection& connection, const QualifiedName& watch);
  /// The tables of a watch learn of it, or forget it. Other watches of theirs go on as before.
  void add_to_tables(Connection& connection, const QualifiedName& watch, const WatchDeclaration& declaration);
  void remove_from_tables(Connection& connection, const QualifiedName& watch,
                          const WatchDeclaration& declaration);

  void settle_table(Connection& connection, std::int64_t table) override;
  void rename_table(Connection& connection, std::int64_t table, const std::string& old_name) override;
  void require_unwatched(Connection& connection, std::int64_t table) override;
  void finalize() noexcept override { rows_.clear(); }

 private:
  /// What it says of itself; nothing where it is damaged or gone.
  std::optional<WatchState> known_state(Connection& connection, const QualifiedName& watch);
  /// `change` writes a stamp of the table: watches that were about its contents still are.
  template <class Change>
  void change_stamp(Connection& connection, const Connection::OpenTable& table, Change change);

  std::map<std::pair<std::string, std::string>, std::shared_ptr<WatchRows>> rows_;
};

/// Those of a connection. Requires: they are registered.
Watches& watches_of(Connection& connection);

/// Puts last_insert_rowid back: what a watch writes is no row of the user's.
class KeptInsertRowid {
 public:
  explicit KeptInsertRowid(sqlite3* db) : db_(db), rowid_(sqlite3_last_insert_rowid(db)) {}
  ~KeptInsertRowid() { sqlite3_set_last_insert_rowid(db_, rowid_); }
  KeptInsertRowid(const KeptInsertRowid&) = delete;
  KeptInsertRowid& operator=(const KeptInsertRowid&) = delete;

 private:
  sqlite3* db_;
  sqlite3_int64 rowid_;
};

}  // namespace foresee
