// Split of an overfull node along an axis of position or velocity, so that the visit cost of both halves is
// minimal.
//
// The elements are sorted by their centres at half the look-ahead and by velocity, on every axis. Every cut
// that leaves at least 40 % on both sides is evaluated. Cost: 2·D sorts of one node's elements.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/tpr_tree/visit_cost.h"

namespace foresee {

/// The elements that move to the new node, by index, ascending. Requires: at least 4 elements.
template <int D>
std::vector<std::uint32_t> choose_split(std::span<const Bounds<D>> elements, const VisitCost<D>& cost);

}  // namespace foresee
