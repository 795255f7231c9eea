// One moving_objects table in this connection: SQLite's handle (sqlite3_vtab), its storage, its open cursors.
//
// Writes during a scan are safe. Before the first change every open cursor stores the ids that it has yet to
// visit, and later reads each object in its current state. It skips objects deleted meanwhile and does not
// visit new ones.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "sqlite/connection.h"
#include "sqlite/table/record_values.h"
#include "storage/table/store.h"

namespace foresee {

class TableCursor;

/// The storage of a table, or the error if it cannot be read: shadow tables are missing, or a later version
/// has written them.
struct StoreOrFault {
  std::shared_ptr<Store> store;  ///< null: see `fault`
  StoreError fault{SQLITE_OK, ""};
};

struct MovingObjectsTable : sqlite3_vtab {
  MovingObjectsTable(std::shared_ptr<Connection> connection, Declaration declaration, StoreOrFault store,
                     const std::string& schema, const std::string& name);
  ~MovingObjectsTable();
  MovingObjectsTable(const MovingObjectsTable&) = delete;
  MovingObjectsTable& operator=(const MovingObjectsTable&) = delete;

  const Declaration& declaration() const { return declared_; }
  /// Throws the fault if the storage cannot be read.
  Store& store() {
    if (!store_.store) throw store_.fault;
    return *store_.store;
  }
  bool has_store() const { return store_.store != nullptr; }
  /// For watches: a copy, since SQLite may connect the table again while they read it. Requires: has_store().
  OpenTable opened() const { return {store_.store, schema, name, number}; }
  /// Store::likely_objects(); 0 for a table that cannot be read.
  std::int64_t likely_objects() const noexcept { return has_store() ? store_.store->likely_objects() : 0; }

  void scan_opened(TableCursor& cursor) { connection->scan_opened(store_.store.get(), cursor); }
  void scan_closed(TableCursor& cursor) noexcept { connection->scan_closed(store_.store.get(), cursor); }
  /// Every open scan of this table, also those from before SQLite connected it again.
  std::span<TableCursor* const> cursors() const noexcept { return connection->cursors(store_.store.get()); }

  /// Drops the shadow tables that exist.
  void drop();

  // Column numbers in SQL, in the order id, motion, auxiliary, command.
  static constexpr int id_column = 0;
  static constexpr int first_motion_column = 1;
  int first_auxiliary_column() const { return 1 + static_cast<int>(declaration().columns.size()); }
  int command_column() const {
    return first_auxiliary_column() + static_cast<int>(declaration().auxiliaries.size());
  }

  /// In a table in degrees x, y, vx, vy follow the command column (hidden_columns()): their places in a record.
  std::size_t hidden_place(std::size_t hidden) const {
    const Offsets at = record_offsets(declaration().layout);
    const std::size_t axes = declaration().frame.axes_of_place(), part = hidden / axes;
    return static_cast<std::size_t>(part == 0 ? at.x : part == 1 ? at.v : at.a) + hidden % axes;
  }

  /// A scan starts: forgets what an UPDATE has kept until now, and gives the memory back.
  void start_statement() {
    if (!stored_before.empty()) stored_before = {};
    if (!moved_to.empty()) moved_to = {};
  }

  void rename(const std::string& new_name);

  std::shared_ptr<Connection> connection;
  std::string schema;
  std::string name;
  RowReader reader;
  std::int64_t number;  ///< the key of Connection::find

  /// Records before this statement changed them, of a table in degrees or with plans. UPDATE FROM passes every column
  /// as it was at its start, also to the second update of a row that several rows of FROM match.
  std::unordered_map<std::int64_t, std::vector<double>> stored_before;

  /// The ids that this UPDATE has given to other objects than at its start.
  std::unordered_set<std::int64_t> moved_to;

 private:
  Declaration declared_;
  StoreOrFault store_;
};

inline MovingObjectsTable& table_of(sqlite3_vtab* base) {
  return *static_cast<MovingObjectsTable*>(base);
}

}  // namespace foresee
