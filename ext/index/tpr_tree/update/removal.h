// Removal from a TPR-tree: entries above the object are tightened, and underfull nodes are dissolved. A leaf
// that is less than half full shares with a sibling if possible (rebalance.h). The contents of dissolved
// nodes are inserted again.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// False if the tree does not have the object.
template <int D>
bool erase_object(TreeState<D>& state, std::int64_t id);

/// Removes the object in `slot` from a leaf and restores the invariants. True if the leaf still exists.
template <int D>
bool take_out(TreeState<D>& state, NodeNumber leaf, std::size_t slot);

/// Replaces a root with one child by that child; removes an empty root.
template <int D>
void lower_root(TreeState<D>& state);

/// Makes the entries above a node as tight as the nodes beneath them allow.
template <int D>
void tighten_upward(TreeState<D>& state, NodeNumber number);

/// True if the object in this slot reaches an end of the leaf's entry in space, velocity or time, but `other` does not.
/// Max t does not count.
template <int D>
bool is_outermost(TreeState<D>& state, NodeNumber leaf, std::size_t slot, const NewObject<D>& other);

/// Recomputes max t in the entries above a node in which a t has changed.
template <int D>
void refresh_newest(TreeState<D>& state, NodeNumber number);

}  // namespace foresee
