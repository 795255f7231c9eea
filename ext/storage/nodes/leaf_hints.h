// Hash table of hints: the probable leaf of an object, and its slot in that leaf.
//
//   hints.reserve(200000);                    // about so many places: two per id
//   hints.learn(leaf.keys, 7);                // the objects of leaf 7
//   const LeafHints::Hint hint = hints.find(42);
//   if (hint.leaf != 0) hint.slot_in(leaf.keys, 42)     // searches from the hinted slot on
//
// The stored map has the exact leaf, but a look-up in a database table takes one or two microseconds. A hint
// costs some nanoseconds and may be wrong, so the caller checks that leaf. The table uses Fibonacci hashing
// (Knuth, The Art of Computer Programming 3, 6.4). While half of the places are free, consecutive ids, the
// common case, do not collide; of ids that collide the last one stays. Cost: 4 bytes per place. They are 24
// bits of the leaf number, so larger numbers have no hints, and the low 8 bits of the slot.
//
// Growth is incremental. The table has partitions, chosen by the hash, which double one after another, a few
// in each reserve(); meanwhile some are twice as large as others (linear hashing, W. Litwin, VLDB 1980, per
// partition). No call adds more than 128 kB.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "base/repeatable_choice.h"

namespace foresee {

class LeafHints {
 public:
  struct Hint {
    std::int64_t leaf = 0;  ///< 0: nothing is known
    std::size_t slot = 0;   ///< modulo `slots`

    /// The index of `id` in the ids of the leaf; their number if it is not there.
    std::size_t slot_in(std::span<const std::int64_t> ids, std::int64_t id) const {
      for (std::size_t i = slot; i < ids.size(); i += slots)
        if (ids[i] == id) return i;
      return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
    }
  };

  /// True before the first reserve(): nothing is learned.
  bool empty() const { return places_ == 0; }
  std::size_t places() const { return places_; }

  /// Grows by one step towards so many places.
  void reserve(std::size_t places) {
    if (empty()) make_partitions();
    const std::size_t wanted = std::min(std::bit_ceil(places), max_places);
    for (std::size_t added = 0;
         places_ < wanted && (added == 0 || added + partitions_[next_].size() <= step);)
      added += double_next_partition();
  }

  /// Requires: reserved.
  void learn(std::int64_t id, std::int64_t leaf, std::size_t slot = 0) {
    if (leaf >= max_leaves) return;
    const Place place = place_of(id);
    partitions_[place.partition][place.at] =
        static_cast<std::uint32_t>(static_cast<std::size_t>(leaf) * slots + slot % slots);
  }
  void learn(std::span<const std::int64_t> ids, std::int64_t leaf) {
    for (std::size_t i = 0; i < ids.size(); ++i) learn(ids[i], leaf, i);
  }

  Hint find(std::int64_t id) const {
    if (empty()) return {};
    const Place place = place_of(id);
    const std::uint32_t hint = partitions_[place.partition][place.at];
    return {hint / slots, hint % slots};
  }

  void clear() noexcept { *this = {}; }

 private:
  static constexpr std::size_t max_places = 1 << 22;
  static constexpr std::uint32_t slots = 1 << 8;
  static constexpr std::size_t line = 16;  ///< hints per cache line
  static constexpr std::int64_t max_leaves = 1 << 24;
  static constexpr int partition_bits = 6;
  static constexpr std::size_t step =
      max_places >> partition_bits >> 1;  ///< the size of the largest partition that doubles

  using Partition = std::vector<std::uint32_t>;  ///< a power of two of cache lines

  struct Place {
    std::size_t partition, at;
  };
  /// The first bits of the hash of the upper digits of the id select a partition, the next bits a cache line.
  /// The last digit selects the place in it, rotated by the hash, for ids that all end in the same digit.
  Place place_of(std::int64_t id) const {
    const std::uint64_t hash = (static_cast<std::uint64_t>(id) / line) * by_golden_ratio;
    const std::size_t partition = hash >> (64 - partition_bits);
    const std::size_t at =
        (hash << partition_bits >> 1) >> (63 - std::countr_zero(partitions_[partition].size() / line));
    const std::uint64_t in_line = (static_cast<std::uint64_t>(id) + hash / (std::uint64_t{1} << 32)) % line;
    return {partition, at * line + static_cast<std::size_t>(in_line)};
  }

  void make_partitions() {
    for (Partition& partition : partitions_) partition.assign(line, 0);
    places_ = partitions_.size() * line;
  }

  /// Doubles a partition, in which each line becomes two. Returns the number of places added.
  std::size_t double_next_partition() {
    Partition& partition = partitions_[next_];
    Partition doubled(2 * partition.size());
    for (std::size_t i = 0; i < doubled.size(); ++i) doubled[i] = partition[i / (2 * line) * line + i % line];
    partition.swap(doubled);
    next_ = (next_ + 1) % partitions_.size();
    places_ += doubled.size();
    return doubled.size();
  }

  std::array<Partition, 1 << partition_bits> partitions_;
  std::size_t places_ = 0;
  std::size_t next_ = 0;  ///< the partition that doubles next; those before it are doubled
};

}  // namespace foresee
