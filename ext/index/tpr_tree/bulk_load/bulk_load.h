// Bulk load of a TPR-tree, level by level from the leaves up. Each node is written once, from the objects in
// leaf order. If the objects do not fit in memory, they are loaded one partition at a time
// (divide_space()).
#pragma once

#include "base/error.h"
#include "index/tpr_tree/tpr_tree.h"
#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Frees every node of the tree.
void free_all(Pages& pages, Interrupt& interrupt);

/// Sets a clock that has not started to the typical t of the records, which may be a sample.
template <int D>
void start_clock(TreeState<D>& state, std::span<const double> records);
/// Sets a clock that has not started to a t of the tree: the median of the newest t beneath each child of the root.
/// Call it before changes that write no t. Cost: the root.
template <int D>
void start_clock(TreeState<D>& state);

/// Starts the clock. Requires: the tree is empty.
template <int D>
void bulk_load_tree(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                    Interrupt& interrupt);
/// Requires: the tree is empty, the clock runs, and there are objects. Only leaves at the border of two
/// partitions may share a node that they would not share if all objects were ordered together.
template <int D>
void bulk_load_tree(TreeState<D>& state, ObjectPartitions& partitions, Interrupt& interrupt);

/// The number of nodes per level of subtrees that hold these objects alone, for a root of this level. The top
/// nodes are one level below the root, or there is one that is as high as the root. Empty if there are too few
/// objects for such a height, or too many.
template <int D>
std::vector<std::size_t> run_levels(const TreeState<D>& state, std::size_t objects, int root_level);
/// Packs the objects into subtrees of these levels: branches, to be added by insert_branch(). The first leaves
/// replace those of `old_leaves`; all other nodes have new numbers, a parent a larger one than its children.
/// Requires: the clock runs.
template <int D>
std::vector<Branch<D>> pack_run(TreeState<D>& state, std::span<const std::int64_t> ids,
                                std::span<const double> records, std::vector<std::size_t> levels,
                                Interrupt& interrupt, std::span<const NodeNumber> old_leaves = {});

// Partitions of objects that do not fit in memory together, by position, velocity and time, for a bulk
// load.
//
//   auto division = divide_space(state, sample, 9, interrupt);     // records of some objects, drawn anywhere
//   parts[division->partition_of(record)].push_back(object);
//
// The concatenated leaves of the partitions are those of the whole. The sample is halved recursively like the
// objects of a leaf order (leaf_order.h), and the cuts are stored. Objects exactly on a cut go to either side
// in turn, so one place with very many objects is divided too. The sizes of partitions vary as the sample
// does, by a few percent. Cost per object: its motion, and one comparison per halving.

/// Partitions have about equal numbers of objects. Requires: a sample, and at least one partition. If the
/// clock has not started, the sample sets it.
template <int D>
std::unique_ptr<SpacePartitioning> divide_space(TreeState<D>& state, std::span<const double> sample,
                                                std::size_t parts, Interrupt& interrupt);

}  // namespace foresee
