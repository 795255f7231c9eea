// Rebalancing of TPR-tree nodes that have gained or lost many objects. Overfull and underfull nodes share
// with a sibling or are split, empty nodes are removed, and the parent's entries are recomputed.
//
//   even_out(state, parent, changed_children);       // from the leaves up, parent by parent
//   even_out_root(state);                            // at the end
//
// A leaf that is overfull, or less than a quarter full, is repacked together with a sibling. Both go into as
// few leaves as hold them with some free slots: two full leaves become three. A leaf that is less than half
// full is repacked too, if one leaf holds both. The sibling is one of the few that the leaf overlaps most:
// the first that has enough free slots, otherwise the first. If half of the leaves of a parent have become less
// than half full, and they are more than two, they are packed together. Inner nodes are split in two, or merged
// into the sibling that they overlap most.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Requires: the nodes beneath `children` are balanced; `parent` has all `children`. Afterwards the parent
/// may be overfull, underfull or without children, and its own entry is stale.
template <int D>
void even_out(TreeState<D>& state, NodeNumber parent, std::span<const NodeNumber> children);

/// even_out() for one leaf that has lost objects, or is overfull: it shares with a sibling. Returns false, and
/// writes nothing, if no change is necessary. Requires: `parent` has a true entry for the leaf; afterwards
/// the parent may be overfull or underfull.
template <int D>
bool even_out_leaf(TreeState<D>& state, NodeNumber parent, NodeNumber leaf);

/// Splits an overfull root below a new one; removes roots with a single child.
template <int D>
void even_out_root(TreeState<D>& state);

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

/// `turn` counts the calls. Cost: reads the leaves of one node. Writes at most a few leaves and their
/// ancestors, and page map rows for the objects of some leaves.
template <int D>
void repack_around(TreeState<D>& state, NodeNumber leaf, std::size_t turn);

/// Packs all leaves of a parent into as few as hold their objects, if that reduces their visit cost. Else it
/// returns false, and writes nothing. For the parent, requires and leaves what even_out() does. Leaves may be
/// overfull or empty. Cost: reads each leaf; if it packs, writes each, and page map rows for the objects that move.
template <int D>
bool pack_all_leaves(TreeState<D>& state, NodeNumber parent);

// Packs all objects beneath a node, once they have dispersed. Those that live long without a report drift apart, and no
// report packs them again.
//
//   repack_dispersed(state, 40, draw);                    // after 40 objects were written or erased
//
// Examined are the root, or nodes of a level whose nodes have at most some 50,000 objects: level 2 if they have 4 kB.
// That is due once a process has changed a quarter as many objects as one packing takes. If a query would visit two and
// a half times the leaves of a packed tree, all beneath the worst of these nodes is packed as by a bulk load. Where no
// node is so small, as in pages of 64 kB, nothing is packed.

/// `draw` chooses nodes, and when a process examines them first. Requires: no reference to a node is in use. A damaged
/// node is left alone. Cost: mostly the root; else some 4000 entries are read; if it packs, some 30 ms without a poll
/// for an interrupt.
template <int D>
void repack_dispersed(TreeState<D>& state, std::size_t changes, std::uint64_t draw);
/// The whole tree was packed: repack_dispersed() starts again, and compares with what it is now.
template <int D>
void note_all_packed(TreeState<D>& state);

}  // namespace foresee
