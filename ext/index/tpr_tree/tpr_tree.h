// TPR-tree over pages: an R-tree with time-parameterized bounds, whose leaves store the table's objects
// themselves (Saltenis et al., "Indexing the Positions of Continuously Moving Objects", SIGMOD 2000).
//
//   MemoryPages pages({.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true});
//   auto tree = make_tpr_tree(pages, 60);
//   tree->insert(42, record);                          // record_offsets(layout).size doubles
//   auto walk = …;                                     // see window_walk.h, nearest_walk.h, tree_join.h
//
// Guarantee: every object is in exactly one leaf, and the bounds of every entry above it contain its motion,
// whatever the numbers. The tree is tuned for queries up to `horizon` seconds ahead of the times being
// written; other queries are answered too. Objects that exist for a limited time are separated in time as they
// are in place, and are tuned for queries during their lives (reference_times.h). Bounds follow the clock, or
// the middle of the lives beneath. If a node's epoch is far from it, its entries are recomputed when an object
// beneath it is written. If updates have left loose leaves, the
// leaves beneath two neighbours are repacked from time to time (update/rebalance.h).
//
// Cost: insert and erase touch one path of nodes. An update writes only the leaf if the leaf's entry stays
// valid and the object is not the newest; a few updates also repack loose leaves. A bulk load is O(n log n)
// and fills the leaves.
//
// The tree keeps no state about its nodes in memory, so a rollback may change the pages behind it. An
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

/// The result of check_tree(): a sentence per problem, and the size of the tree.
struct TreeReport {
  std::vector<std::string> problems;
  std::size_t objects = 0, nodes = 0;
};

/// Assigns objects to partitions of the space of positions and velocities. See bulk_load/bulk_load.h.
class SpacePartitioning {
 public:
  virtual ~SpacePartitioning() = default;
  virtual std::size_t partition_of(const double* record) = 0;
};

/// Objects, by partition, that do not fit in memory together.
class ObjectPartitions {
 public:
  virtual ~ObjectPartitions() = default;
  /// The number of objects in each partition; at least one in total.
  virtual std::span<const std::size_t> counts() const = 0;
  /// Fills `ids` and `records` with the objects of a partition. Each partition is read once.
  virtual void read(std::size_t partition, std::vector<std::int64_t>& ids, std::vector<double>& records) = 0;
};

class TprTree {
 public:
  virtual ~TprTree() = default;

  /// Requires: no object has this id; the record is valid by docs/reference/moving_objects.md#values.
  virtual void insert(std::int64_t id, std::span<const double> record) = 0;
  /// Returns false if the tree does not have the object.
  virtual bool update(std::int64_t id, std::span<const double> record) = 0;
  virtual bool erase(std::int64_t id) = 0;
  /// Puts a new object in the place of another one, if the leaf's entry contains the new one. Else returns false, and
  /// no object has changed. Requires: no object has `new_id`. Cost: that of an update which writes only the leaf.
  virtual bool replace(std::int64_t id, std::int64_t new_id, std::span<const double> record) = 0;

  /// Replaces all objects by these, in full leaves with consecutive numbers; neighbours in space and velocity
  /// share leaves. Ids are unique.
  virtual void bulk_load(std::span<const std::int64_t> ids, std::span<const double> records,
                         Interrupt& interrupt) = 0;
  /// Inserts or updates each object, whether or not the tree has it. Many objects together cost far less per
  /// object than insert() and update() (merge.h). Ids are unique.
  virtual void merge(std::span<const std::int64_t> ids, std::span<const double> records,
                     Interrupt& interrupt) = 0;
  /// True if these objects arrive node by node, and merge() would change few nodes per object (merge.h).
  virtual bool arrive_in_place(std::span<const std::int64_t> ids, std::span<const double> records,
                               Interrupt& interrupt) = 0;
  /// Erases these objects. Many together cost far less per object than erase(). At most `max_leaves` leaves are changed
  /// before pages may write them. Requires: the tree has all objects; ids ascend.
  virtual void erase_all(std::span<const std::int64_t> ids, std::size_t max_leaves, Interrupt& interrupt) = 0;
  /// After so many objects were written or erased: may pack those that have dispersed (update/rebalance.h).
  virtual void repack_dispersed(std::size_t changes, std::uint64_t draw) = 0;
  /// merge() of objects that the tree does not have. Where they are many, they become packed nodes beside those
  /// that are there, and parts of the tree are packed again from time to time (update/merge.h).
  virtual void merge_new(std::span<const std::int64_t> ids, std::span<const double> records,
                         Interrupt& interrupt) = 0;
  /// True if merge_new() would pack so many objects.
  virtual bool packs_new(std::size_t objects) = 0;
  /// Adds objects that the tree does not have, packed separately: a run, subtrees beside those that are there.
  /// It costs as much as a bulk load of these objects, whatever the tree holds; but queries visit its leaves
  /// besides the others. Ids are unique. Requires: takes_run().
  virtual void add_run(std::span<const std::int64_t> ids, std::span<const double> records,
                       Interrupt& interrupt) = 0;
  /// False if a run of so many objects would be far lower or higher than the tree.
  virtual bool takes_run(std::size_t objects) = 0;
  /// bulk_load() of a superset of the tree's objects. The last objects are those that were written last.
  virtual void reload(std::span<const std::int64_t> ids, std::span<const double> records,
                      Interrupt& interrupt) = 0;
  /// Chooses partitions for bulk_load_partitions() from a sample of records, drawn anywhere. `newest` are the
  /// records written last, if the tree's clock continues as with reload(). If it is empty, the clock starts
  /// again.
  virtual std::unique_ptr<SpacePartitioning> divide(std::span<const double> sample, std::size_t partitions,
                                                    std::span<const double> newest, Interrupt& interrupt) = 0;
  /// Like bulk_load(), with at most one partition in memory. Frees all nodes of the tree, but does not report
  /// removed objects to the pages. Requires: divide() was called for these partitions.
  virtual void bulk_load_partitions(ObjectPartitions& partitions, Interrupt& interrupt) = 0;
  /// bulk_load() of the tree's own objects, at its clock.
  virtual void rebuild(Interrupt& interrupt) = 0;
};

/// `pages` must outlive the tree. Requires: horizon finite and >= 0.
std::unique_ptr<TprTree> make_tpr_tree(Pages& pages, double horizon);

/// The max t stored, read from the root; 0 without objects or without t.
double read_newest_t(NodeSource& source);

/// The kinds of all objects, or-ed, read from the root; bits of objects that the tree no longer has may be set too.
Kinds kinds_of_all(NodeSource& source);

/// The leaves that may have an object of a kind.
struct WantedLeaves {
  std::vector<NodeNumber> numbers;  ///< ascending
  std::size_t others = 0;           ///< the number of the other leaves
};
/// Those that `wanted` accepts by the entries above them. Cost: the inner nodes.
WantedLeaves find_leaves(NodeSource& source, const KindTest& wanted, Interrupt& interrupt);

/// An estimate of the number of objects, to be compared with `compared`. It comes from one random path of the tree; if
/// that gives at most a thousand times `compared`, from the mean of 32 paths (D. E. Knuth, "Estimating the efficiency
/// of backtrack programs", Mathematics of Computation 29, 1975). The same tree gives the same estimate.
double estimate_objects(NodeSource& source, double compared);

/// Appends the id and record of every object, leaf by leaf.
void collect_objects(NodeSource& source, std::vector<std::int64_t>& ids, std::vector<double>& records,
                     Interrupt& interrupt);

/// Checks the invariants: levels, parents, counts, times, bounds, and that every id exists once, in the leaf
/// that find_leaf() returns.
TreeReport check_tree(Pages& pages, Interrupt& interrupt);

}  // namespace foresee
