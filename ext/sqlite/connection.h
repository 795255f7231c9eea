// State that foresee keeps per database connection: the connected moving_objects tables, their decoded scenes,
// and the memory in which joins compute.
//
// One Connection lives in the modules' pAux and dies with the last of them. Tables come and go with every
// schema change (VACUUM, ALTER); a table's decoded scene lives as long as the table is connected and is valid
// for one ContentVersion. The scene used last is always kept, and others as far as the memory limit
// allows; a query keeps those that it reads in any case.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "index/gpcd_grid/work_space.h"
#include "query/scene.h"
#include "sqlite/names/table_lookups.h"
#include "sqlite/watch_upkeep.h"
#include "storage/rows/statement.h"
#include "storage/table/store.h"

namespace foresee {

class TableCursor;

class Connection {
 public:
  static constexpr std::size_t scene_memory_limit = 256 << 20;  ///< bytes

  explicit Connection(sqlite3* db, std::size_t scene_memory = scene_memory_limit)
      : db_(db), interrupt_(db), lookups_(db), scene_memory_(scene_memory) {}

  sqlite3* db() const { return db_; }

  /// sqlite3_interrupt, seen from inside a long computation; also drives the application's progress handler.
  Interrupt& interrupt() { return interrupt_; }

  TableLookups& lookups() { return lookups_; }

  // A table announces itself in xConnect and leaves in xDisconnect; the number finds it again (see
  // open_table.h).
  std::int64_t announce(std::shared_ptr<Store> store, const std::string& schema, const std::string& table);
  void rename(std::int64_t number, const std::string& table);
  void leave(std::int64_t number) noexcept;

  /// Finalizes foresee's own statements that are at rest. Must be called when SQLite disconnects a
  /// table-valued function, as leave() does for a table. sqlite3_close() disconnects all, then refuses while a
  /// statement is left, and a query may outlive the tables that it reads.
  void finalize() noexcept;

  struct OpenTable {
    std::shared_ptr<Store> store;
    std::string schema, table;
    std::int64_t number;
  };
  /// Null if no table has this number. Valid until the table leaves. By name SQLite alone finds a table
  /// (open_table.h): what it has replaced stays connected while an old statement is prepared.
  const OpenTable* find(std::int64_t number) const;

  /// Null until it is registered.
  WatchUpkeep* watches() const { return watches_.get(); }
  void keep_watches(std::unique_ptr<WatchUpkeep> upkeep) { watches_ = std::move(upkeep); }

  /// How many objects the table of this name has, as far as memory knows: nothing is read, nothing connected.
  /// Of several that may be meant the largest, of all where no name is given; where no such table is
  /// connected yet, as many as R*Tree assumes without statistics.
  double likely_objects(const QueriedTable& name) const;

  // Scans that are open, by what they read: SQLite may reconnect a table while a scan of its older instance
  // goes on, and both share one store.
  void scan_opened(const Store* store, TableCursor& cursor) { cursors_[store].push_back(&cursor); }
  void scan_closed(const Store* store, TableCursor& cursor) noexcept;
  std::span<TableCursor* const> cursors(const Store* store) const noexcept;

  /// The table's contents as they are now, and as they stay whatever is written later; with the levels of its
  /// tree if they are wanted. Throws StoreError for damaged rows. Cost: a look-up where this version's scene
  /// is at hand, else all rows are read and decoded.
  std::shared_ptr<const Scene> load_scene(const OpenTable& table, bool with_levels = false);

  /// The same where this version's scene is at hand, and null elsewhere: nothing is decoded.
  std::shared_ptr<const Scene> find_scene(const OpenTable& table, bool with_levels = false);

  /// A scene of the object of this id alone, or of none, as it is now; without its outline or mesh. Cost: a
  /// look-up.
  static std::shared_ptr<Scene> load_object(const OpenTable& table, std::int64_t id);

  /// PRAGMA threads: how many a computation may use beside the caller's; 0 unless the application sets more.
  std::size_t helper_threads() const {
    return static_cast<std::size_t>(std::max(0, sqlite3_limit(db_, SQLITE_LIMIT_WORKER_THREADS, -1)));
  }

  /// Memory for one join, kept from join to join; one that runs beside another gets its own.
  std::shared_ptr<GridSpace> grid_space() {
    return space_.use_count() == 1 ? space_ : std::make_shared<GridSpace>();
  }

 private:
  struct CachedScene {
    ContentVersion version;
    std::shared_ptr<const Scene> scene;
    std::uint64_t used;  ///< the later, the larger
  };

  void drop_scenes_used_long_ago() noexcept;

  sqlite3* db_;
  StatementInterrupt interrupt_;
  TableLookups lookups_;
  std::int64_t last_number_ = 0;
  std::map<std::int64_t, OpenTable> tables_;
  std::map<const Store*, std::vector<TableCursor*>> cursors_;
  std::map<const Store*, CachedScene> scenes_;
  std::size_t scene_memory_;
  std::uint64_t last_use_ = 0;
  std::unique_ptr<WatchUpkeep> watches_;
  std::shared_ptr<GridSpace> space_ = std::make_shared<GridSpace>();
};

}  // namespace foresee
