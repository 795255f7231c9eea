// The tree is the table: a TPR-style R-tree over pages, its leaves the objects themselves (Saltenis et al.,
// "Indexing the Positions of Continuously Moving Objects", SIGMOD 2000).
//
//   MemoryPages pages({.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true});
//   auto tree = make_tpr_tree(pages, 60);
//   tree->insert(42, record);                          // record_offsets(layout).size doubles
//   auto walk = …;                                     // see window_walk.h, nearest_walk.h, tree_join.h
//
// Guarantee: every object is in exactly one leaf, and the bounds of every entry above it contain its motion,
// whatever the numbers. The tree is tuned for questions that look up to `horizon` seconds ahead of the times
// that are being written; others are answered too. Bounds follow the clock: a node whose epoch lies far
// behind (or ahead) has its entries computed anew when something beneath it is written.
// Where updates have left loose leaves, those beneath two neighbours are packed anew now and then (repack.h).
//
// Cost: insert and erase touch one path of nodes; an update that leaves its leaf's entry true and is not the
// newest object touches the leaf alone (unless it is one of the few that find loose leaves around); a bulk
// load is O(n log n) and fills the leaves.
//
// The tree keeps nothing about its nodes in memory, so pages may be changed behind it by a rollback. An
// exception that leaves a call leaves the pages half changed: the caller rolls them back.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "index/pages.h"

namespace foresee {

/// What check_tree() found: sentences about what is wrong, and how much there is.
struct TreeReport {
  std::vector<std::string> problems;
  std::size_t objects = 0, nodes = 0;
};

/// Which part of the space of positions and velocities is an object in? See space_partitioning.h.
class SpacePartitioning {
 public:
  virtual ~SpacePartitioning() = default;
  virtual std::size_t partition_of(const double* record) = 0;
};

/// Objects that memory cannot hold together, by the parts of a division.
class ObjectPartitions {
 public:
  virtual ~ObjectPartitions() = default;
  /// How many objects each part has, one or more in all of them together.
  virtual std::span<const std::size_t> counts() const = 0;
  /// Fills `ids` and `records` with a part's objects. Each part is read once.
  virtual void read(std::size_t partition, std::vector<std::int64_t>& ids, std::vector<double>& records) = 0;
};

class TprTree {
 public:
  virtual ~TprTree() = default;

  /// Requires: no object has this id; the record is valid as docs/sql_reference.md#values says.
  virtual void insert(std::int64_t id, std::span<const double> record) = 0;
  /// False if there is no such object.
  virtual bool update(std::int64_t id, std::span<const double> record) = 0;
  virtual bool erase(std::int64_t id) = 0;

  /// Replaces everything by these objects, neighbours in space and velocity together, in full leaves with
  /// consecutive numbers. Ids are unique.
  virtual void bulk_load(std::span<const std::int64_t> ids, std::span<const double> records,
                         Interrupt& interrupt) = 0;
  /// Each object is in the tree afterwards as its record says, whether or not it was before: as many insert()
  /// and update(), where there are many at far less cost each (merge.h). Ids are unique.
  virtual void merge(std::span<const std::int64_t> ids, std::span<const double> records,
                     Interrupt& interrupt) = 0;
  /// bulk_load() of objects among which are all that the tree has, those that were written last at the end.
  virtual void reload(std::span<const std::int64_t> ids, std::span<const double> records,
                      Interrupt& interrupt) = 0;
  /// Parts for bulk_load_partitions(), chosen by the records of some objects, drawn anywhere. `newest`: records
  /// that were written last, if the tree goes on as with reload(); without any its clock starts again.
  virtual std::unique_ptr<SpacePartitioning> divide(std::span<const double> sample, std::size_t partitions,
                                                    std::span<const double> newest, Interrupt& interrupt) = 0;
  /// As bulk_load(), holding no more than a part in memory. Frees what the tree leads to, but tells the pages
  /// of no object that goes. Requires: divide() was called for these parts.
  virtual void bulk_load_partitions(ObjectPartitions& partitions, Interrupt& interrupt) = 0;
  /// bulk_load() with the objects that the tree has.
  virtual void rebuild(Interrupt& interrupt) = 0;
};

/// `pages` must outlive the tree. Requires: horizon finite and >= 0.
std::unique_ptr<TprTree> make_tpr_tree(Pages& pages, double horizon);

/// The greatest t stored, read off the root; 0 without objects or without t.
double read_newest_t(NodeSource& source);

/// How many objects there are, estimated from one way down.
double estimate_objects(NodeSource& source);

/// Every object's id and record, leaf by leaf, appended.
void collect_objects(NodeSource& source, std::vector<std::int64_t>& ids, std::vector<double>& records,
                     Interrupt& interrupt);

/// Proves the invariants: levels, parents, counts, every id once and where find_leaf() says, times, bounds.
TreeReport check_tree(Pages& pages, Interrupt& interrupt);

}  // namespace foresee
