// Split of an overfull node along an axis of position or velocity, or in time, so that the visit cost of both
// halves is minimal.
//
// The elements are sorted by their centres at half the look-ahead and by velocity, on every axis. If some
// have an end, they are sorted by their reference times, too. Every cut that leaves at least 40 % on both
// sides is evaluated. Cost: 2·D sorts of one node's elements, or one more.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/tpr_tree/visit_cost.h"

namespace foresee {

/// The elements that move to the new node, by index, ascending. Requires: at least 4 elements.
template <int D>
std::vector<std::uint32_t> choose_split(std::span<const Entry<D>> elements, const VisitCost<D>& cost);

}  // namespace foresee
