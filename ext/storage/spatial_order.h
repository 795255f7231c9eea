// In which order do neighbours in space come together?
//
//   for (std::uint32_t row : spatial_order(layout, records.data(), count)) …
//
// Morton order of the ranks of the positions at the objects' reference times: ranks, not coordinates, so that
// neither clusters nor outliers spoil it. Deterministic: equal places keep their order. O(n log n).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/layout.h"

namespace foresee {

/// Row numbers; requires: records of record_offsets(layout).size doubles, finite positions, count < 2^32.
std::vector<std::uint32_t> spatial_order(const Layout& layout, const double* records, std::size_t count);

}  // namespace foresee
