// In which leaf is this object, probably, and where in it?
//
//   hints.reserve(200000);                    // so many places, roughly: two an id
//   hints.learn(leaf.keys, 7);                // the objects of leaf 7
//   const LeafHints::Hint hint = hints.find(42);
//   if (hint.leaf != 0) hint.slot_in(leaf.keys, 42)     // looks there first
//
// The stored map answers this for certain, by a look into a table of the database: a microsecond or two. A
// hint costs some nanoseconds and need not be true, so whoever asks looks into that leaf. Fibonacci hashing
// (Knuth, The Art of Computer Programming 3, 6.4): while half of the places are free, ids that count up, as
// most do, share none; of others that do, the last one stays. Cost: 4 bytes a place: 24 bits of the leaf's
// number, so that leaves with larger ones have no hints, and the last 8 of the slot.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "base/rooms.h"

namespace foresee::storage {

class LeafHints {
 public:
  struct Hint {
    std::int64_t leaf = 0;  ///< 0: nothing is known
    std::size_t slot = 0;   ///< the remainder by `slots`

    /// Where `id` is among the ids of the leaf; their number if it is not there.
    std::size_t slot_in(std::span<const std::int64_t> ids, std::int64_t id) const {
      for (std::size_t i = slot; i < ids.size(); i += slots)
        if (ids[i] == id) return i;
      return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
    }
  };

  /// Nobody has asked yet: there is nothing to learn for.
  bool empty() const { return hints_.empty(); }

  void reserve(std::size_t places) {
    if (hints_.empty()) hints_.assign(least_places, 0);
    while (hints_.size() < places && hints_.size() < most_places) grow();
  }

  /// Requires: reserved.
  void learn(std::int64_t id, std::int64_t leaf, std::size_t slot = 0) {
    if (leaf < leaves)
      hints_[place_of(id)] =
          static_cast<std::uint32_t>(static_cast<std::size_t>(leaf) * slots + slot % slots);
  }
  void learn(std::span<const std::int64_t> ids, std::int64_t leaf) {
    for (std::size_t i = 0; i < ids.size(); ++i) learn(ids[i], leaf, i);
  }

  Hint find(std::int64_t id) const {
    if (hints_.empty()) return {};
    const std::uint32_t hint = hints_[place_of(id)];
    return {hint / slots, hint % slots};
  }

  void clear() noexcept { hints_ = {}; }

 private:
  static constexpr std::size_t least_places = 1 << 10, most_places = 1 << 22;
  static constexpr std::uint32_t slots = 1 << 8;
  static constexpr std::size_t line = 16;  ///< hints that the processor fetches together
  static constexpr std::int64_t leaves = 1 << 24;

  /// A line by the hash of the id's upper digits; in it a place by the last digit, which the hash turns
  /// round, for ids that all end in the same one.
  std::size_t place_of(std::int64_t id) const {
    const std::uint64_t hash = (static_cast<std::uint64_t>(id) / line) * 0x9e3779b97f4a7c15;
    const std::size_t at = hash >> (64 - std::countr_zero(hints_.size() / line));
    return at * line + (static_cast<std::uint64_t>(id) + hash / (std::uint64_t{1} << 32)) % line;
  }

  /// An id's line becomes either of two.
  void grow() {
    std::vector<std::uint32_t> doubled(2 * hints_.size());
    for (std::size_t i = 0; i < doubled.size(); ++i) doubled[i] = hints_[i / (2 * line) * line + i % line];
    hints_ = std::move(doubled);
  }

  std::vector<std::uint32_t> hints_;  ///< none, or a power of two
};

}  // namespace foresee::storage
