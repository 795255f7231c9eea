// One moving_objects table as this connection sees it: SQLite's handle, its storage, and its open cursors.
//
// Writes during a scan are safe. Before the first change every open cursor notes the ids that it has yet to
// visit, and later reads each object in its current state. Objects deleted meanwhile are skipped, and new ones
// are not visited.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sqlite/connection.h"
#include "sqlite/table/record_values.h"
#include "storage/table/store.h"

namespace foresee {

class TableCursor;

/// The storage of a table, or why it cannot be read: shadow tables are missing or written by a later version.
struct StoreOrFault {
  std::shared_ptr<Store> store;  ///< null: there is a fault
  StoreError fault{SQLITE_OK, ""};
};

struct MovingObjectsTable : sqlite3_vtab {
  MovingObjectsTable(std::shared_ptr<Connection> connection, Declaration declaration, StoreOrFault store,
                     const std::string& schema, const std::string& name);
  ~MovingObjectsTable();
  MovingObjectsTable(const MovingObjectsTable&) = delete;
  MovingObjectsTable& operator=(const MovingObjectsTable&) = delete;

  const Declaration& declaration() const { return declared_; }
  /// Throws the fault if there is one.
  Store& store() {
    if (!store_.store) throw store_.fault;
    return *store_.store;
  }
  bool has_store() const { return store_.store != nullptr; }
  /// Store::likely_objects(); none of a table that cannot be read.
  std::int64_t likely_objects() const noexcept { return has_store() ? store_.store->likely_objects() : 0; }

  void scan_opened(TableCursor& cursor) { connection->scan_opened(store_.store.get(), cursor); }
  void scan_closed(TableCursor& cursor) noexcept { connection->scan_closed(store_.store.get(), cursor); }
  /// Every scan of this table, also those that began before SQLite connected it anew.
  std::span<TableCursor* const> cursors() const noexcept { return connection->cursors(store_.store.get()); }

  /// Drops the shadow tables, as many as there are.
  void drop();

  // Columns as SQL numbers them: id, motion, auxiliary, command.
  static constexpr int id_column = 0;
  static constexpr int first_motion_column = 1;
  int first_auxiliary_column() const { return 1 + static_cast<int>(declaration().columns.size()); }
  int command_column() const {
    return first_auxiliary_column() + static_cast<int>(declaration().auxiliaries.size());
  }

  void rename(const std::string& new_name);

  std::shared_ptr<Connection> connection;
  std::string schema;
  std::string name;
  Values values;
  std::int64_t number;  ///< what Connection::find knows it by

 private:
  Declaration declared_;
  StoreOrFault store_;
};

inline MovingObjectsTable& table_of(sqlite3_vtab* base) {
  return *static_cast<MovingObjectsTable*>(base);
}

}  // namespace foresee
