// State that foresee keeps per database connection: the connected moving_objects tables, their decoded
// scenes, and the memory in which joins compute.
//
// The modules' pAux owns one Connection, which is destroyed with the last module. A schema change (VACUUM,
// ALTER) disconnects and reconnects tables. A decoded scene is cached while its table is connected and is
// valid for one ContentVersion. The most recently used scene is always kept, others as far as the memory
// limit allows. A running query keeps the scenes that it reads in any case.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "database/statement.h"
#include "index/gpcd_grid/work_space.h"
#include "query/scene.h"
#include "sqlite/names/table_lookups.h"
#include "sqlite/watch_upkeep.h"
#include "storage/table/store.h"

namespace foresee {

class TableCursor;

/// A connected moving_objects table.
struct OpenTable {
  std::shared_ptr<Store> store;
  std::string schema, table;
  std::int64_t number;  ///< the key of Connection::find()
};

class Connection {
 public:
  static constexpr std::size_t scene_memory_limit = 256 << 20;  ///< bytes

  explicit Connection(sqlite3* db, std::size_t scene_memory = scene_memory_limit)
      : db_(db), interrupt_(db), lookups_(db), scene_memory_(scene_memory) {}

  sqlite3* db() const { return db_; }

  /// sqlite3_interrupt, seen from inside a long computation; also drives the application's progress handler.
  Interrupt& interrupt() { return interrupt_; }

  TableLookups& lookups() { return lookups_; }

  // xConnect calls announce(), xDisconnect calls leave(). The number identifies the table (see open_table.h).
  std::int64_t announce(std::shared_ptr<Store> store, const std::string& schema, const std::string& table);
  void rename(std::int64_t number, const std::string& table);
  void leave(std::int64_t number) noexcept;

  /// Finalizes foresee's own statements that are not running. Must be called when SQLite disconnects a
  /// table-valued function, as leave() does for a table. sqlite3_close() disconnects all tables and then
  /// fails if a statement is left; a query may outlive the tables that it reads.
  void finalize() noexcept;

  /// Null if no table has this number. Valid until leave(). Only SQLite resolves a name (open_table.h): a
  /// table that it has replaced stays connected while an old statement is prepared.
  const OpenTable* find(std::int64_t number) const;

  /// Null until predictive_watch is registered.
  WatchUpkeep* watches() const { return watches_.get(); }
  void keep_watches(std::unique_ptr<WatchUpkeep> upkeep) { watches_ = std::move(upkeep); }

  /// The schema of a connected table with this name that is in another schema than this one; "" if none is
  /// connected. From memory: reads nothing.
  std::string other_schema(const std::string& table, const std::string& schema) const;

  /// Estimated number of objects of the table with this name, from memory: reads nothing, connects nothing.
  /// The largest of the connected tables that match; without a name all match. Where none is connected yet,
  /// the number that R*Tree assumes without statistics.
  double likely_objects(const TableName& name) const;

  // Open scans by the store that they read: SQLite may reconnect a table during a scan of its older instance,
  // and both share one store.
  void scan_opened(const Store* store, TableCursor& cursor) { cursors_[store].push_back(&cursor); }
  void scan_closed(const Store* store, TableCursor& cursor) noexcept;
  std::span<TableCursor* const> cursors(const Store* store) const noexcept;

  /// A snapshot of the table's current contents, with all that is needed. Throws StoreError for damaged rows. Cost: a
  /// look-up if such a scene of this version is cached. Else the needed rows and plans are read and decoded, and the
  /// new scene replaces the cached one.
  std::shared_ptr<const Scene> load_scene(const OpenTable& table, SceneNeeds needs = {});

  /// Whether load_scene() would find all objects in its cache.
  bool is_loaded(const OpenTable& table) const;

  /// A scene of the one object with this id, with its legs of these times, empty if it does not exist; without its
  /// outline or mesh. Cost: a look-up, and decoding some chunks of the plan.
  static std::shared_ptr<Scene> load_object(const OpenTable& table, std::int64_t id,
                                            const LegTimes& times = {});

  /// The one object with this id, as above; without an id all, as load_scene() gives them.
  std::shared_ptr<const Scene> load_queried(const OpenTable& table, const std::optional<std::int64_t>& id,
                                            const LegTimes& times) {
    return id ? load_object(table, *id, times) : load_scene(table, {.times = times});
  }

  /// PRAGMA threads: the number of helper threads that a computation may use; 0 by default.
  std::size_t helper_threads() const {
    return static_cast<std::size_t>(std::max(0, sqlite3_limit(db_, SQLITE_LIMIT_WORKER_THREADS, -1)));
  }

  /// Memory for one join, reused by the next. A join that runs during another gets its own.
  std::shared_ptr<GridSpace> grid_space() {
    return space_.use_count() == 1 ? space_ : std::make_shared<GridSpace>();
  }

 private:
  struct CachedScene {
    ContentVersion version;
    std::shared_ptr<const Scene> scene;
    std::uint64_t used;  ///< a counter: larger is later
    /// The scene lacks objects that may meet none of these; nothing: it has all.
    std::optional<Kinds> partner_kinds;

    bool has(const SceneNeeds& needs) const {
      return (!needs.with_levels || scene->levels) && scene->legs_during.cover(needs.times) &&
             (!partner_kinds || partner_kinds == needs.partner_kinds);
    }
  };

  void evict_scenes() noexcept;

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

/// Adds an object that the store holds under this record: its row, or the rows of its legs during scene.legs_during.
/// Requires: FloatEnvironment.
void add_object(TableReader& store, std::int64_t id, std::span<const double> record,
                StatementReadState& statement_state, Scene& scene);

}  // namespace foresee
