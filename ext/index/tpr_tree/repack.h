// How does a tree recover whose objects have moved on? Leaf by leaf they drift apart: each leaf stays true,
// none stays tight, and what leaves them leaves them half empty. Now and then the leaves beneath two nodes
// that overlap are packed anew, as a bulk load would, which also draws a new border between the two.
#pragma once

#include "index/tpr_tree/state.h"

namespace foresee::index {

/// Packs the leaves beneath the parent of `leaf` and the sibling closest to it anew if that makes them far
/// cheaper to visit. Cost: a look at both, and if they look loose that of packing their leaves: worth asking
/// for once in some hundred updates.
template <int D>
void repack_around(TreeState<D>& state, NodeNumber leaf);

}  // namespace foresee::index
