// Stratified sample of numbered items: one from each of equal parts, not at equal distances.
//
//   for (std::size_t part = 0; part < 48; ++part) use(stratified_pick(part, 48, count));
//
// The choice is irregular, so that a pattern in the order of the items does not bias it, and the same on every machine.
// It is Fibonacci hashing: the high bits of the part's number times 2^64 / golden ratio (Knuth, The Art of Computer
// Programming, volume 3, section 6.4).
#pragma once

#include <cstddef>
#include <cstdint>

namespace foresee {

/// A number below `count`, chosen by `part`. Requires: count > 0.
constexpr std::size_t irregular_pick(std::size_t part, std::size_t count) {
  constexpr std::uint64_t by_golden_ratio = 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>((part * by_golden_ratio >> 33) % count);
}

/// The item of part number `part`, of `parts` equal parts of the items 0 to count - 1. Requires: part < parts <= count.
constexpr std::size_t stratified_pick(std::size_t part, std::size_t parts, std::size_t count) {
  const std::size_t begin = part * count / parts, end = (part + 1) * count / parts;
  return begin + irregular_pick(part, end - begin);
}

}  // namespace foresee
