// How does a tree recover whose objects have moved on? Leaf by leaf they drift apart: each entry stays true,
// none stays tight, and neighbours of before are neighbours no more. Now and then the surroundings of a leaf
// are put in order, in steps so small that a commit which takes one stays small.
//
//   if (++updates % 24 == 0) repack_around(state, leaf, updates / 24);
//
// A leaf that another parent would hold at less cost moves there (the reinsertion of the R*-tree, Beckmann et
// al. 1990, of a leaf in place of objects); it is packed anew with the siblings that it overlaps most, as a
// bulk load would, if that makes them cheaper to visit; and every other time its parent's entries, every
// sixteenth time those of the node above too, are computed anew at the clock's time.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// `turn` counts the calls. Cost: a look at the leaves of one node; of writes at most a few leaves and the
/// nodes above them, and of the page map what some leaves hold.
template <int D>
void repack_around(TreeState<D>& state, NodeNumber leaf, std::size_t turn);

}  // namespace foresee
