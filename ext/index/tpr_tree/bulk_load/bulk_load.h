// How is a whole tree written at once? Level by level from the leaves up, each node once, from the objects in
// leaf order; of objects that memory cannot hold together, part by part (space_partitioning.h).
#pragma once

#include "base/error.h"
#include "index/tpr_tree/tpr_tree.h"
#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Frees every node of the tree.
void free_all(Pages& pages, Interrupt& interrupt);

/// A clock that does not run yet is set by objects, a sample or all.
template <int D>
void start_clock(TreeState<D>& state, std::span<const double> records);

/// Starts the clock. Requires: the tree is empty.
template <int D>
void bulk_load_tree(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                    Interrupt& interrupt);
/// Requires: the tree is empty, the clock runs, and there are objects. Only leaves at the border of two parts
/// share a node that would not, had they been ordered together.
template <int D>
void bulk_load_tree(TreeState<D>& state, ObjectPartitions& partitions, Interrupt& interrupt);

}  // namespace foresee
