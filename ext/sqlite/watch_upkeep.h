// Who keeps the watches of a table up to date? Tables know that there are such, and no more of them: the room
// sqlite/watch/ does the work behind this.
#pragma once

#include <cstdint>
#include <string>

namespace foresee {

class Connection;

class WatchUpkeep {
 public:
  virtual ~WatchUpkeep() = default;

  /// Before COMMIT, once the table's changes are in its rows: every watch of it takes them over.
  virtual void settle_table(Connection& connection, std::int64_t table) = 0;
  /// A watched table has another name: its watches go by that.
  virtual void rename_table(Connection& connection, std::int64_t table, const std::string& old_name) = 0;
  /// Throws where a watch needs the table, which is to be dropped.
  virtual void require_unwatched(Connection& connection, std::int64_t table) = 0;
  /// Lets go of all statements.
  virtual void finalize() noexcept = 0;
};

}  // namespace foresee
