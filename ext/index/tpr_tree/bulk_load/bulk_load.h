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

}  // namespace foresee
