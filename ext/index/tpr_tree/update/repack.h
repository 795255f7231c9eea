// Incremental repacking of a TPR-tree whose objects have drifted apart: a few leaves are reorganized per
// call, so that a commit that includes a call remains small.
//
//   if (++updates % 24 == 0) repack_around(state, leaf, updates / 24);
//
// As objects move, entries remain true but not tight, and the objects of a leaf are no longer neighbours. A
// leaf that another parent would hold at less cost moves there. This is the reinsertion of the R*-tree
// (Beckmann et al. 1990), of a leaf instead of objects. A leaf is repacked with the siblings that it overlaps
// most, as a bulk load would, if that reduces their visit cost. Every other call also recomputes the entries
// of the leaf's parent at its new epoch. Every sixteenth call recomputes those of the node above it, too.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// `turn` counts the calls. Cost: reads the leaves of one node. Writes at most a few leaves and their
/// ancestors, and page map rows for the objects of some leaves.
template <int D>
void repack_around(TreeState<D>& state, NodeNumber leaf, std::size_t turn);

}  // namespace foresee
