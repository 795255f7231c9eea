// How do many objects get into the tree together? Reading and changing every node concerned once, however
// many of them concern it.
//
//   merge_objects(state, ids, records, interrupt);
//
// Objects that the tree has are reports: each is overwritten where its leaf's entry stays true, as in
// bottom-up updates (Lee et al., "Supporting Frequent Updates in R-Trees: A Bottom-Up Approach", VLDB 2003).
// The others rise, level by level, to the lowest node that contains them, new ones to the root, and sink from
// there to the leaf whose cost of being visited grows least. Then, from the leaves up, nodes that are too
// full or too empty are evened out with a neighbour before they are split (B*-trees, Knuth, The Art of
// Computer Programming 3, 6.2.4), and every entry above what changed is computed once.
//
// Cost, an object: a look at its leaf, and if it leaves that, a choice among the children of one to a few
// nodes; what a leaf's writing costs is shared by all its objects.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Afterwards each object is in the tree once, as its record says. Ids are unique. Requires: the root is an
/// inner node.
template <int D>
void merge_objects(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                   Interrupt& interrupt);

}  // namespace foresee
