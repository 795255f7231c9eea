// One moving_objects table as this connection sees it: SQLite's handle, its storage, and its open cursors.
//
// Writes beneath a scan are safe: before the first change every cursor in mid-scan notes the ids that it has
// yet to visit and reads each object as it is when its turn comes; objects deleted meanwhile are passed over,
// new ones are not visited.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sqlite/connection.h"
#include "sqlite/values.h"
#include "storage/object_store.h"

namespace foresee {

class TableCursor;

struct Table : sqlite3_vtab {
  Table(std::shared_ptr<Connection> connection, std::shared_ptr<ObjectStore> store, const std::string& schema,
        const std::string& name);
  ~Table();
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  const Declaration& declaration() const { return store->declaration(); }

  // Columns as SQL numbers them: id, motion, auxiliary, command.
  static constexpr int id_column = 0;
  static constexpr int first_motion_column = 1;
  int first_auxiliary_column() const { return 1 + static_cast<int>(declaration().columns.size()); }
  int command_column() const {
    return first_auxiliary_column() + static_cast<int>(declaration().auxiliaries.size());
  }

  void rename(const std::string& new_name);

  std::shared_ptr<Connection> connection;
  std::shared_ptr<ObjectStore> store;
  std::string name;
  Values values;
  std::int64_t number;  ///< what Connection::find knows it by
  std::vector<TableCursor*> cursors;
};

inline Table& table_of(sqlite3_vtab* base) {
  return *static_cast<Table*>(base);
}

}  // namespace foresee
