// Where do objects go that memory cannot hold together? Into parts, neighbours in space and velocity into
// one, so that the leaves of one part after another are those of the whole.
//
//   auto division = divide_space(state, sample, 9, interrupt);     // records of some objects, drawn anywhere
//   parts[division->partition_of(record)].push_back(object);
//
// The sample is halved again and again like the objects of a leaf order (leaf_order.h), and the cuts are
// remembered. Objects that lie on a cut go to either side in turn, so that a place with very many is shared.
// Parts differ in size as the sample does: by some hundredths. Cost, an object: its motion, and a comparison
// for each halving.
#pragma once

#include "base/error.h"
#include "index/tpr_tree/tpr_tree.h"
#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Parts have about as many objects as one another. Requires: a sample, and one part or more. Where the clock
/// does not run the sample sets it.
template <int D>
std::unique_ptr<SpacePartitioning> divide_space(TreeState<D>& state, std::span<const double> sample,
                                                std::size_t parts, Interrupt& interrupt);

}  // namespace foresee
