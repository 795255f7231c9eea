// Sort keys of boxes, and the bucket sort that orders a stripe by the lower ends along x before it is
// scanned.
//
//   std::span<const Key> sorted = sorted_along_x(stripes.entries(7), partition.x, memory, interrupt);
//
// A counting sort into buckets of equal width, about as many as there are keys, is followed by an insertion
// sort of the nearly sorted result. A stripe is small, so all of it stays in the caches. If nearly all keys
// fall into few buckets, a full sort replaces the insertion sort.
#pragma once

#include <cstdint>
#include <span>

#include "base/error.h"
#include "index/gpcd_grid/cell_size.h"
#include "index/gpcd_grid/work_space.h"

namespace foresee::gpcd {

/// Orders boxes by the lower end along x, then by row number, with one integer comparison.
using Key = std::uint64_t;

Key key_of(float lower_x, std::uint32_t id);
inline std::uint32_t id_of(Key key) {
  return static_cast<std::uint32_t>(key);
}

/// Insertion sort for nearly sorted keys; falls back to a full sort if they are not.
void sort_keys(std::span<Key> keys, Interrupt& interrupt);

/// The sorted keys, stored in `memory`. Fast if few keys are outside `range`.
std::span<const Key> sorted_along_x(std::span<const Key> keys, const Range& range,
                                    GridSpace::Visit::LaneMemory& memory, Interrupt& interrupt);

}  // namespace foresee::gpcd
