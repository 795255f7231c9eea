// How is an overfull node cut in two? Along position or velocity, wherever the two halves will be visited
// least.
//
// Orders tried: by centre half-way through the look-ahead and by velocity, on every axis; every cut that
// leaves both halves 40 % or more. Cost: 2·D sorts of one node's elements.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/tpr_tree/visit_cost.h"

namespace foresee {

/// Which elements leave for the new node, by index, ascending. Requires: at least 4 elements.
template <int D>
std::vector<std::uint32_t> choose_split(std::span<const Bounds<D>> elements, const VisitCost<D>& cost);

}  // namespace foresee
