// What becomes of nodes that many objects have entered or left at once? Their parent's entries become true,
// the empty ones go, and those that are too full or too empty share with a neighbour or are split.
//
//   even_out(state, parent, changed_children);       // from the leaves up, parent by parent
//   even_out_root(state);                            // at the end
//
// Leaves: a leaf that is too full, or less than a quarter full, is packed anew together with a sibling, in as
// few leaves as hold both with some room: two full ones become three. So is one that is less than half full
// if both fit in one. The sibling is, of the few that it overlaps most, the first with room, or else the
// first. Inner nodes are split in two, or taken up by the sibling that they overlap most.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Requires: nodes beneath `children` are in order; `parent` has them all. The parent may be too full, too
/// empty, or without children afterwards, and its own entry is stale.
template <int D>
void even_out(TreeState<D>& state, NodeNumber parent, std::span<const NodeNumber> children);

/// The same for one leaf that has lost objects, or is too full: it shares with a sibling. False if nothing
/// had to change: then nothing was written. Requires: `parent` has a true entry for it; it may be too full or
/// too empty afterwards.
template <int D>
bool even_out_leaf(TreeState<D>& state, NodeNumber parent, NodeNumber leaf);

/// A root that is too full gets another one above it; one that leads to a single node goes.
template <int D>
void even_out_root(TreeState<D>& state);

}  // namespace foresee
