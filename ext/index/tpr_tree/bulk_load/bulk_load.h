// Bulk load of a TPR-tree, level by level from the leaves up. Each node is written once, from the objects in
// leaf order. If the objects do not fit in memory, they are loaded one partition at a time
// (space_partitioning.h).
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
/// Packs the objects into subtrees of these levels: branches, to be added by insert_branch(). Requires: the clock
/// runs.
template <int D>
std::vector<Branch<D>> pack_run(TreeState<D>& state, std::span<const std::int64_t> ids,
                                std::span<const double> records, std::vector<std::size_t> levels,
                                Interrupt& interrupt);

}  // namespace foresee
