// How does the tree take something in? Down by least cost, up again widening entries; leaves that are too
// full share with a neighbour (rebalance.h), inner nodes are split.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Adds an object beneath `from` (0: the root). `known_leaf` is where the page map has it already, or 0.
template <int D>
void insert_object(TreeState<D>& state, const NewObject<D>& object, NodeNumber from = 0,
                   NodeNumber known_leaf = 0);

/// Makes every entry above a node true for what has just been put into it; no node is too full afterwards.
/// Added: NewObject or Branch.
template <int D, class Added>
void fit_upward(TreeState<D>& state, NodeNumber number, const Added& added);

/// Hangs a subtree into a node of the branch's level. Requires: the root's level is at least that.
template <int D>
void insert_branch(TreeState<D>& state, const Branch<D>& branch);

/// Computes an inner node's entries anew, from the nodes below and at the clock's time.
template <int D>
void renew_entries(TreeState<D>& state, NodeNumber inner);

/// The same if its epoch has become a bad one for the child in `slot`: more than half a horizon away from the
/// clock, and faces moving so fast that much of that child's width stems from it.
template <int D>
bool freshen(TreeState<D>& state, NodeNumber inner, std::size_t slot);

// --- what a change of many objects does by itself

/// A new root with one child, the old one. Its number.
template <int D>
NodeNumber put_root_above(TreeState<D>& state, NodeNumber old_root);

/// Splits an overfull inner node; both halves have entries in the parent afterwards, which may be overfull
/// then. The new half's number.
template <int D>
NodeNumber split_node(TreeState<D>& state, NodeNumber number, NodeNumber parent_number);

/// Gives a node that hangs where `from` says another parent.
template <int D>
void add_children(TreeState<D>& state, const Unread& from, NodeNumber parent);

}  // namespace foresee
