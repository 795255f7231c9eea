// A table of moving objects as a query reads it: all objects, some by id, the tree, the changes since a stamp.
//
//   MemoryTable ships("ships", layout);                       // or a table of a database (sqlite/stored_table.h)
//   std::shared_ptr<const Scene> all = ships.all();
//   const ChangedObjects changed = ships.changes_since(stamp);
//
// Scenes and trees are snapshots: they keep their contents while the table changes. Cost: as each says.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "index/gpcd_grid/work_space.h"
#include "index/pages.h"
#include "query/scene.h"

namespace foresee {

/// The objects of one table that a transaction has changed.
struct ChangedObjects {
  bool are_known = true;          ///< false: any object may have changed
  std::vector<std::int64_t> ids;  ///< in rising order
  std::vector<double> instants;   ///< their current reference times

  bool holds(std::int64_t id) const { return std::binary_search(ids.begin(), ids.end(), id); }
};

class TableSource {
 public:
  virtual ~TableSource() = default;

  virtual const std::string& name() const = 0;
  virtual const Layout& layout() const = 0;

  /// An estimate of the number of objects, without reading.
  virtual double likely_objects() const = 0;
  /// The largest reference time stored; 0 without objects or without t. Cost: one node.
  virtual double newest_t() = 0;
  /// All objects, or at least those that are needed; plans as their legs. Cost: all are decoded, unless is_loaded().
  virtual std::shared_ptr<const Scene> all(const SceneNeeds& needs = {}) = 0;
  virtual bool is_loaded() = 0;
  /// Those of these ids that exist at some time of `times`, plans as their legs of that time, and perhaps others.
  /// Requires: ids in rising order. Cost: a look-up per id, and per plan the chunks of `times`.
  virtual std::shared_ptr<const Scene> objects(std::span<const std::int64_t> ids,
                                               const LegTimes& times = {}) = 0;
  /// Must not outlive the statement that takes it.
  virtual std::shared_ptr<NodeSource> tree() = 0;
  /// The plans; null for a layout without. Must be read to the end before anything is written. Requires: tree() was
  /// called in this statement.
  virtual std::shared_ptr<ChunkSource> chunks() { return nullptr; }

  /// Equal stamps: equal contents.
  virtual std::optional<std::int64_t> stamp() = 0;
  /// The objects that were written since this stamp, which perhaps differ; in order of ids.
  virtual ChangedObjects changes_since(const std::optional<std::int64_t>& stamp) = 0;
};

/// A scene without objects, for checks that need no more than names and layouts.
inline std::shared_ptr<const Scene> empty_scene(const TableSource& table) {
  auto scene = std::make_shared<Scene>();
  scene->name = table.name();
  scene->layout = table.layout();
  return scene;
}

/// The trees of a table, to be searched.
inline SearchTarget trees_of(TableSource& table) {
  return {table.name(), nullptr, table.tree(), table.chunks()};
}

/// The tables of a join. If `b` is the same table as `a`, each pair occurs in both orders.
struct JoinedTables {
  std::shared_ptr<TableSource> a = nullptr;  ///< must be set
  std::shared_ptr<TableSource> b = nullptr;  ///< null: pairs within a, each once

  bool are_one() const { return a == b; }
  bool is_within_one() const { return !b || are_one(); }
  /// Side b, which is a for pairs within one table.
  TableSource& side_b() const { return b ? *b : *a; }
  /// The newest t stored in either table.
  double newest_t() const { return is_within_one() ? a->newest_t() : std::max(a->newest_t(), b->newest_t()); }
};

/// What joins may use beside their objects.
struct JoinResources {
  Interrupt& interrupt;
  std::shared_ptr<GridSpace> space = nullptr;  ///< as in JoinQuestion
  std::size_t helpers = 0;
};

}  // namespace foresee
