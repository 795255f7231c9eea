#include "storage/spatial_order.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace foresee {
namespace {

// The bits of `value`, `gap` places apart.
std::uint64_t spread(std::uint64_t value, int gap) {
  std::uint64_t result = 0;
  for (int bit = 0; value >> bit != 0; ++bit) result |= (value >> bit & 1) << bit * gap;
  return result;
}

}  // namespace

std::vector<std::uint32_t> spatial_order(const Layout& layout, const double* records, std::size_t count) {
  const Offsets at = record_offsets(layout);
  std::vector<std::uint64_t> key(count, 0);
  std::vector<std::uint32_t> order(count);
  const int bits = std::bit_width(count);
  const int drop = std::max(0, bits - 64 / layout.axes);  // so that all axes fit one key
  for (int axis = 0; axis < layout.axes; ++axis) {
    const auto coordinate = [&](std::uint32_t row) {
      return records[row * static_cast<std::size_t>(at.size) + static_cast<std::size_t>(at.x + axis)];
    };
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return coordinate(a) < coordinate(b); });
    for (std::size_t rank = 0; rank < count; ++rank)
      key[order[rank]] |= spread(rank >> drop, layout.axes) << axis;
  }
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  return order;
}

}  // namespace foresee
