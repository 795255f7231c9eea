// Choices that are irregular, but the same on every machine: hashes, and a stratified sample of numbered items.
//
//   const bool is_chosen = fraction_of(hash_of(7)) < 0.25;            // of numbers 0, 1, 2, ... about every fourth
//   for (std::size_t part = 0; part < 48; ++part) use(stratified_pick(part, 48, count));
//
// So no pattern in the data biases them. The sample has one item from each of equal parts, at irregular distances. That
// is Fibonacci hashing: the high bits of the part's number times 2^64 / golden ratio (Knuth, The Art of Computer
// Programming, volume 3, section 6.4).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foresee {

/// The finalizer of MurmurHash3: every bit of the number changes about half of the result's.
constexpr std::uint64_t hash_of(std::uint64_t number) {
  number = (number ^ number >> 33) * 0xff51afd7ed558ccd;
  number = (number ^ number >> 33) * 0xc4ceb9fe1a85ec53;
  return number ^ number >> 33;
}

/// Depends on every value, bit by bit.
inline std::uint64_t hash_of(std::span<const double> values) {
  std::uint64_t hash = 0;
  for (const double value : values) hash = hash_of(hash ^ std::bit_cast<std::uint64_t>(value));
  return hash;
}

/// From 0 to less than 1: below p for about a share p of all hashes.
constexpr double fraction_of(std::uint64_t hash) {
  return static_cast<double>(hash >> 32) * 0x1p-32;
}

inline constexpr std::uint64_t by_golden_ratio = 0x9e3779b97f4a7c15;

/// From 0 to less than 1; those of consecutive numbers are spread evenly.
constexpr double spread_fraction(std::uint64_t number) {
  return fraction_of(number * by_golden_ratio);
}

/// A number below `count`, chosen by `part`. Requires: count > 0.
constexpr std::size_t irregular_pick(std::size_t part, std::size_t count) {
  return static_cast<std::size_t>((part * by_golden_ratio >> 33) % count);
}

/// The item of part number `part`, of `parts` equal parts of the items 0 to count - 1. Requires: part < parts <= count.
constexpr std::size_t stratified_pick(std::size_t part, std::size_t parts, std::size_t count) {
  const std::size_t begin = part * count / parts, end = (part + 1) * count / parts;
  return begin + irregular_pick(part, end - begin);
}

}  // namespace foresee
