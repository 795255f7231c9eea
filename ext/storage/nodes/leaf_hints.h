// In which leaf is this object, probably?
//
//   hints.reserve(100000);                    // so many ids, roughly
//   hints.learn(leaf.keys, 7);                // the objects of leaf 7
//   hints.find(42)                            // 7, or another leaf, or 0: nothing is known
//
// The stored map answers this for certain, by a look into a table of the database: a microsecond or two. A
// hint costs some nanoseconds and need not be true, so whoever asks looks into that leaf. One leaf's number
// an id, by Fibonacci hashing (Knuth, The Art of Computer Programming 3, 6.4): ids that count up, as most do,
// share no place; of others that do, the last one stays. Cost: 4 bytes an id.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/rooms.h"

namespace foresee::storage {

class LeafHints {
 public:
  /// Nobody has asked yet: there is nothing to learn for.
  bool empty() const { return leaves_.empty(); }

  void reserve(std::size_t ids) {
    if (leaves_.empty()) leaves_.assign(least_places, 0);
    while (leaves_.size() < ids && leaves_.size() < most_places) grow();
  }

  void learn(std::int64_t id, std::int64_t leaf) {
    if (leaf <= std::numeric_limits<std::uint32_t>::max())
      leaves_[place_of(id)] = static_cast<std::uint32_t>(leaf);
  }
  void learn(std::span<const std::int64_t> ids, std::int64_t leaf) {
    for (const std::int64_t id : ids) learn(id, leaf);
  }

  std::int64_t find(std::int64_t id) const { return leaves_.empty() ? 0 : leaves_[place_of(id)]; }

  void clear() noexcept { leaves_ = {}; }

 private:
  static constexpr std::size_t least_places = 1 << 10, most_places = 1 << 22;

  std::size_t place_of(std::int64_t id) const {
    return static_cast<std::uint64_t>(id) * 0x9e3779b97f4a7c15 >> (64 - std::countr_zero(leaves_.size()));
  }

  /// An id's place becomes either of two.
  void grow() {
    std::vector<std::uint32_t> doubled(2 * leaves_.size());
    for (std::size_t i = 0; i < doubled.size(); ++i) doubled[i] = leaves_[i / 2];
    leaves_ = std::move(doubled);
  }

  std::vector<std::uint32_t> leaves_;  ///< none, or a power of two
};

}  // namespace foresee::storage
