// Boxes in the order of their lower ends along x: how a stripe is sorted before it is scanned.
//
//   std::span<const Key> sorted = along_x(stripes.entries(7), partition.x, memory, interrupt);
//
// A counting sort into buckets of equal width, about as many as there are keys, then an insertion sort over
// what is nearly in order. All of it stays in the caches, as a stripe is small. Where nearly all keys fall
// into few buckets a full sort does the rest.
#pragma once

#include <cstdint>
#include <span>

#include "base/error.h"
#include "index/gpcd_grid/cell_size.h"
#include "index/gpcd_grid/work_space.h"

namespace foresee::gpcd {

/// Orders boxes by the lower end along x, then by row number; comparing keys is one integer comparison.
using Key = std::uint64_t;

Key key_of(float lower_x, std::uint32_t id);
inline std::uint32_t id_of(Key key) {
  return static_cast<std::uint32_t>(key);
}

/// Sorts keys that are nearly in order; falls back to a full sort where they are not.
void sort_keys(std::span<Key> keys, Interrupt& interrupt);

/// The keys in order, which are in `memory`. Few lie outside `range`.
std::span<const Key> along_x(std::span<const Key> keys, const Range& range, GridSpace::Visit::Lanes& memory,
                             Interrupt& interrupt);

}  // namespace foresee::gpcd
