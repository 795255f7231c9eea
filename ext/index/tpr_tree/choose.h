// Into which child does an object go? The one whose cost of being visited grows least.
#pragma once

#include "index/tpr_tree/cost.h"
#include "index/tpr_tree/node.h"

namespace foresee::index {

/// The slot of the best child for something with `added` as its bounds at the node's epoch; ties go to the
/// cheaper child. Requires: an inner node that is not empty.
template <int D>
std::size_t choose_child(const Node& inner, const Bounds<D>& added, const VisitCost<D>& cost);

}  // namespace foresee::index
