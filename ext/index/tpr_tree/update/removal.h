// How does the tree let something go? Entries above are tightened; a leaf that is half empty shares with a
// neighbour if it can (rebalance.h); nodes that become too empty are dissolved and what they held is inserted
// again.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Takes the object in `slot` out of a leaf and puts the tree in order. True if the leaf is still there.
template <int D>
bool take_out(TreeState<D>& state, NodeNumber leaf, std::size_t slot);

/// A root with one child makes room for it; one with nothing goes.
template <int D>
void lower_root(TreeState<D>& state);

/// Makes the entries above a node as tight as the nodes beneath them allow.
template <int D>
void tighten_upward(TreeState<D>& state, NodeNumber number);

/// Brings greatest t above a node up to date after one of its t has changed.
template <int D>
void refresh_newest(TreeState<D>& state, NodeNumber number);

/// The greatest t in a node. Requires: not empty.
template <int D>
double newest_in(const Node& node, const LeafReader<D>& reader);

}  // namespace foresee
