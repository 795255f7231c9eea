// Insertion into a TPR-tree: descent by min cost, then entries are widened on the path up. Overfull leaves
// share with a sibling (rebalance.h); overfull inner nodes are split.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Adds an object beneath `from` (0: the root). `known_leaf` is its leaf in the page map, or 0.
template <int D>
void insert_object(TreeState<D>& state, const NewObject<D>& object, NodeNumber from = 0,
                   NodeNumber known_leaf = 0);

/// Makes every entry above a node contain what was added to it; no node is overfull afterwards. Added is
/// NewObject or Branch.
template <int D, class Added>
void fit_upward(TreeState<D>& state, NodeNumber number, const Added& added);

/// Adds a subtree to a node of the branch's level. Requires: the root's level is at least that.
template <int D>
void insert_branch(TreeState<D>& state, const Branch<D>& branch);

/// Recomputes an inner node's entries from its children, at its epoch_for().
template <int D>
void renew_entries(TreeState<D>& state, NodeNumber inner);

/// Does so only if the node's epoch is stale for the child in `slot`; returns whether it was. An epoch is
/// stale if it is more than half a horizon from its epoch_for(), and much of the child's width comes from
/// that time.
template <int D>
bool renew_if_stale(TreeState<D>& state, NodeNumber inner, std::size_t slot);

// --- steps that merges of many objects call separately

/// Writes a new root whose only child is the old root; returns its number.
template <int D>
NodeNumber put_root_above(TreeState<D>& state, NodeNumber old_root);

/// Splits an overfull inner node and adds both halves to the parent, which may be overfull afterwards.
/// Returns the number of the new half.
template <int D>
NodeNumber split_node(TreeState<D>& state, NodeNumber number, NodeNumber parent_number);

/// Sets the parent of the node that `from` describes.
template <int D>
void add_children(TreeState<D>& state, const Unread& from, NodeNumber parent);

}  // namespace foresee
