#include "index/gpcd_grid/sort_keys.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "base/interrupt_steps.h"

namespace foresee::gpcd {
namespace {

constexpr std::size_t few = 40;  // keys at most, for the sort by counting
constexpr std::size_t keys_per_check = 8192;

/// The bits of x as an integer that increases with x.
std::uint32_t ordered_bits(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return bits ^ (static_cast<std::uint32_t>(-static_cast<std::int32_t>(bits >> 31)) | 0x80000000u);
}

float lower_x(Key key) {
  const auto bits = static_cast<std::uint32_t>(key >> 32);
  const auto flipped = static_cast<std::uint32_t>(static_cast<std::int32_t>(~bits) >> 31);
  return std::bit_cast<float>(bits ^ (flipped | 0x80000000u));
}

/// std::sort that can be interrupted. It is used for unsorted keys only, so the cost of counting steps is
/// small.
void full_sort(std::span<Key> keys, Interrupt& interrupt) {
  Steps steps(interrupt);
  std::sort(keys.begin(), keys.end(), [&](Key a, Key b) {
    steps();
    return a < b;
  });
}

/// Sorts a few distinct keys: the rank of each is the number of smaller keys.
void sort_few(std::span<const Key> keys, Key* out) {
  using Two = std::int64_t __attribute__((vector_size(16)));
  constexpr Key sign = Key{1} << 63;  // vector instructions compare signed numbers
  alignas(16) std::int64_t copy[few + 3];
  for (std::size_t i = 0; i < keys.size(); ++i) copy[i] = static_cast<std::int64_t>(keys[i] ^ sign);
  for (std::size_t i = keys.size(); i % 4 != 0; ++i) copy[i] = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Two all = {copy[i], copy[i]};
    Two smaller = {}, others = {};
    for (std::size_t j = 0; j < keys.size(); j += 4) {
      Two low, high;
      __builtin_memcpy(&low, copy + j, sizeof low);
      __builtin_memcpy(&high, copy + j + 2, sizeof high);
      smaller -= low < all, others -= high < all;
    }
    smaller += others;
    out[smaller[0] + smaller[1]] = keys[i];
  }
}

/// The range of the keys' lower ends, clamped to `range`.
Range range_of(std::span<const Key> keys, const Range& range) {
  Key min_key = keys[0], max_key = keys[0];
  for (Key key : keys) min_key = std::min(min_key, key), max_key = std::max(max_key, key);
  return {std::max(lower_x(min_key), range.from), std::min(lower_x(max_key), range.to)};
}

/// Writes the keys to `out`, bucket by bucket in ascending order along x.
void into_buckets(std::span<const Key> keys, const Range& range, Key* out, std::uint32_t* places,
                  Interrupt& interrupt) {
  const std::size_t size = keys.size();
  const auto [from, to] = range_of(keys, range);
  const auto last = static_cast<float>(size - 1);
  const float largest = std::numeric_limits<float>::max();
  const float per_unit = from < to ? std::min(static_cast<float>(size) / (to - from), largest) : 0;
  const auto bucket = [=, from = from](Key key) {
    const float place = (lower_x(key) - from) * per_unit, positive = place > 0 ? place : 0;  // NaN: 0
    return static_cast<std::size_t>(positive < last ? positive : last);
  };
  std::fill_n(places, size, 0);
  for (std::size_t i = 0; i < size; ++i) {
    if (i % keys_per_check == keys_per_check - 1) interrupt.check();
    ++places[bucket(keys[i])];
  }
  std::uint32_t place = 0;
  for (std::size_t i = 0; i < size; ++i) place += std::exchange(places[i], place);
  for (std::size_t i = 0; i < size; ++i) {
    if (i % keys_per_check == keys_per_check - 1) interrupt.check();
    out[places[bucket(keys[i])]++] = keys[i];
  }
}

}  // namespace

Key key_of(float lower_x, std::uint32_t id) {
  return static_cast<Key>(ordered_bits(lower_x)) << 32 | id;
}

void sort_keys(std::span<Key> keys, Interrupt& interrupt) {
  std::size_t moves_left = 16 * keys.size();
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const Key key = keys[i];
    std::size_t place = i;
    for (; place > 0 && keys[place - 1] > key; --place) keys[place] = keys[place - 1];
    keys[place] = key;
    if (i - place > moves_left) return full_sort(keys, interrupt);
    moves_left -= i - place;
  }
}

std::span<const Key> sorted_along_x(std::span<const Key> keys, const Range& range,
                                    GridSpace::Visit::LaneMemory& memory, Interrupt& interrupt) {
  const std::size_t size = keys.size();
  Key* const sorted = memory.keys.room(size);
  if (size <= few) {
    sort_few(keys, sorted);
  } else {
    into_buckets(keys, range, sorted, memory.buckets.room(size), interrupt);
    sort_keys({sorted, size}, interrupt);
  }
  return {sorted, size};
}

}  // namespace foresee::gpcd
