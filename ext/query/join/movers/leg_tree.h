// Candidates of a join of legs by a tree: a TPR-tree is built over the legs of each side, and the trees are joined.
//
//   auto candidates = make_leg_tree<2>(question, {now, h}, margin, interrupt);
//
// The stored trees have whole chunks of plans, and bound them over all times. The legs of one slab make a tree with
// tight bounds, as that of a table that holds nothing else. Guarantee and order: those of tree_join.h, with row numbers
// of the scenes. Cost: about a microsecond per leg.
#pragma once

#include "index/candidates.h"
#include "query/join/question.h"

namespace foresee {

template <int D>
std::unique_ptr<Candidates> make_leg_tree(const JoinQuestion& question, const Horizon& horizon,
                                          const Vec<D>& margin, Interrupt& interrupt);

}  // namespace foresee
