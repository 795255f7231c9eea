// Interface through which a table keeps its watches up to date. Tables know no more of watches than this, since
// sqlite/watch/ includes them. Watches (sqlite/watch/watches.h) is the only implementation: watches_of() relies on it.
#pragma once

#include <string>

namespace foresee {

struct Frame;
struct OpenTable;

class WatchUpkeep {
 public:
  virtual ~WatchUpkeep() = default;

  /// Applies the table's changes to each of its watches. Called before COMMIT, when its rows hold the
  /// changes.
  virtual void update_watches_of(const OpenTable& table) = 0;
  /// Makes the watches of a renamed table use its new name.
  virtual void rename_table(const OpenTable& table, const std::string& old_name) = 0;
  /// Throws StoreError (SQLITE_LOCKED) if a watch needs the table, which is about to be dropped.
  virtual void require_unwatched(const OpenTable& table) = 0;
  /// Throws Refusal if another table of a watch has another frame than `frame`, which the table has from now on.
  virtual void require_frame(const OpenTable& table, const Frame& frame) = 0;
  /// Releases all statements.
  virtual void finalize() noexcept = 0;
};

}  // namespace foresee
