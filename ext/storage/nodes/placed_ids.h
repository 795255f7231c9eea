// Compact list of ids with their new leaves, for loads and merges of millions of objects.
//
//   PlacedIds placed;
//   placed.add(ids_of_leaf, 7);                              // each id once
//   placed.for_each_chunk([&](auto entries) { … });          // all ids ascending, some thousand per call
//
// IdMap (id_map.h) supports rollback and queries at 50 to 100 bytes per id; this class is for ten million ids.
// Ids are sorted in blocks, which the processor's caches hold, by their digits (LSD radix sort; Knuth, The Art of
// Computer Programming 3, 5.2.5). The blocks are merged when they are read. Cost: 12 bytes per id, and one more block.
// The list grows without copies, which would take as much again.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "base/repeatable_choice.h"
#include "database/id_hash_map.h"
#include "format/id_block.h"

namespace foresee {

/// Fingerprint of a set of ids, whatever their order. Different sets have equal ones by accident only.
class IdSum {
 public:
  void add(std::int64_t id) {
    ++count_;
    sum_ += hash_of(static_cast<std::uint64_t>(id));
  }
  std::size_t count() const { return count_; }
  bool operator==(const IdSum&) const = default;

 private:
  std::size_t count_ = 0;
  std::uint64_t sum_ = 0;
};

class PlacedIds {
 public:
  /// Larger leaf numbers do not fit.
  static constexpr std::int64_t max_leaf = std::numeric_limits<std::uint32_t>::max();

  /// Requires: none of the ids is in the list; 0 < leaf <= max_leaf.
  void add(std::span<const std::int64_t> ids, std::int64_t leaf) {
    for (const std::int64_t id : ids) {
      if (blocks_.empty() || blocks_.back().size() == block_size) add_block();
      blocks_.back().push_back({static_cast<std::uint32_t>(id), static_cast<std::int32_t>(id >> 32),
                                static_cast<std::uint32_t>(leaf)});
      sum_.add(id);
    }
  }
  const IdSum& sum() const { return sum_; }

  /// Calls each(entries) with consecutive chunks of all ids; no block of the stored map is in two chunks. Call it
  /// once, after the last add().
  template <class Each>
  void for_each_chunk(Each each) {
    constexpr std::size_t chunk_size = 1 << 14;
    if (!blocks_.empty()) sort(blocks_.back());
    std::vector<Rest> rests(blocks_.begin(), blocks_.end());
    std::make_heap(rests.begin(), rests.end(), is_after);
    std::vector<IdHashMap::Entry> chunk;
    while (!rests.empty()) {
      std::pop_heap(rests.begin(), rests.end(), is_after);
      Rest& first = rests.back();
      const std::int64_t id = first.front().id();
      const bool starts_block = !chunk.empty() && IdBlock::base_of(id) != IdBlock::base_of(chunk.back().id);
      if (starts_block && chunk.size() >= chunk_size) {
        each(std::span<const IdHashMap::Entry>(chunk));
        chunk.clear();
      }
      chunk.push_back({id, first.front().leaf});
      first = first.subspan(1);
      if (first.empty())
        rests.pop_back();
      else
        std::push_heap(rests.begin(), rests.end(), is_after);
    }
    if (!chunk.empty()) each(std::span<const IdHashMap::Entry>(chunk));
  }

 private:
  static constexpr std::size_t block_size = 1 << 16;

  /// Without alignment to 8 bytes, which would take 16 bytes.
  struct Placed {
    std::uint32_t id_low;
    std::int32_t id_high;
    std::uint32_t leaf;

    std::int64_t id() const { return std::int64_t{id_high} * (std::int64_t{1} << 32) + id_low; }
  };
  using Block = std::vector<Placed>;
  using Rest = std::span<const Placed>;  ///< of a sorted block

  void add_block() {
    if (!blocks_.empty()) sort(blocks_.back());
    blocks_.emplace_back().reserve(block_size);
  }
  /// Only by the digits that differ: ids of a table are mostly close together.
  void sort(Block& block) {
    constexpr unsigned digit_bits = 11, digits = 1 << digit_bits;
    const auto [min, max] = std::minmax_element(block.begin(), block.end(), is_before);
    const auto base = static_cast<std::uint64_t>(min->id());
    const std::uint64_t range = static_cast<std::uint64_t>(max->id()) - base;
    sorted_.reserve(block_size);
    sorted_.resize(block.size());
    for (unsigned shift = 0; shift < 64 && range >> shift != 0; shift += digit_bits) {
      const auto digit = [=](const Placed& placed) {
        return (static_cast<std::uint64_t>(placed.id()) - base) >> shift & (digits - 1);
      };
      std::array<std::uint32_t, digits> places{};
      for (const Placed& placed : block) ++places[digit(placed)];
      std::exclusive_scan(places.begin(), places.end(), places.begin(), std::uint32_t{0});
      for (const Placed& placed : block) sorted_[places[digit(placed)]++] = placed;
      block.swap(sorted_);
    }
  }
  static bool is_before(const Placed& a, const Placed& b) { return a.id() < b.id(); }
  static bool is_after(const Rest& a, const Rest& b) { return a.front().id() > b.front().id(); }

  std::vector<Block> blocks_;  ///< all but the last are sorted
  Block sorted_;               ///< temporary
  IdSum sum_;
};

}  // namespace foresee
