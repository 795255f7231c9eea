// Batch insertion and update of many objects: each affected node is read and changed once, however many
// objects affect it.
//
//   merge_objects(state, ids, records, interrupt);
//
// Objects that the tree already has are position reports. Each overwrites its record if its leaf's entry
// remains true, as in bottom-up updates (Lee et al., "Supporting Frequent Updates in R-Trees: A Bottom-Up
// Approach", VLDB 2003). Other objects move up, level by level, to the lowest node that contains them; new
// objects start at the root. From there each moves down to the leaf whose visit cost increases least. Then
// nodes are settled from the leaves up. Overfull and underfull nodes share with a sibling before they are
// split (B*-trees, Knuth, The Art of Computer Programming 3, 6.2.4). Every entry above a changed node is
// recomputed once.
//
// Cost per object: one read of its leaf, and if it leaves that leaf, a choice among the children of one to a
// few nodes. All objects of a leaf share the cost of writing it.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Inserts or updates each object. Ids are unique. Requires: the root is an inner node.
template <int D>
void merge_objects(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                   Interrupt& interrupt);

}  // namespace foresee
