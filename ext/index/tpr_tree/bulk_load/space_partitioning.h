// Partitions of objects that do not fit in memory together, by position, velocity and time, for a bulk
// load.
//
//   auto division = divide_space(state, sample, 9, interrupt);     // records of some objects, drawn anywhere
//   parts[division->partition_of(record)].push_back(object);
//
// The concatenated leaves of the partitions are those of the whole. The sample is halved recursively like the
// objects of a leaf order (leaf_order.h), and the cuts are stored. Objects exactly on a cut go to either side
// in turn, so one place with very many objects is divided too. The sizes of partitions vary as the sample
// does, by a few percent. Cost per object: its motion, and one comparison per halving.
#pragma once

#include "base/error.h"
#include "index/tpr_tree/tpr_tree.h"
#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Partitions have about equal numbers of objects. Requires: a sample, and at least one partition. If the
/// clock has not started, the sample sets it.
template <int D>
std::unique_ptr<SpacePartitioning> divide_space(TreeState<D>& state, std::span<const double> sample,
                                                std::size_t parts, Interrupt& interrupt);

}  // namespace foresee
