// Compact id map for a reload of a whole table, when all ids are known beforehand.
//
//   PackedMap map(sorted_ids);
//   map.place(ids_of_leaf, 7) && map.is_complete()          // for each leaf
//   map.for_each_chunk([&](auto entries) { … });            // all ids ascending, some thousand per call
//
// IdMap (id_map.h) supports rollback and queries at 50 to 100 bytes per id; this class is for ten
// million ids. Objects are read twice, from files that another program may have changed: place() and
// is_complete() report ids that do not match. Cost: 12 bytes per id. A look-up is an interpolation search:
// some nanoseconds for evenly distributed ids, at most twice a binary search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "storage/format/id_block.h"
#include "storage/rows/id_hash_map.h"

namespace foresee {

class PackedMap {
 public:
  /// Requires: ids ascend strictly.
  explicit PackedMap(std::vector<std::int64_t> ids) : ids_(std::move(ids)), leaves_(ids_.size(), nowhere) {}

  /// Sets the leaf of these ids; false if one of them is unknown. Requires: the first call has the smallest
  /// leaf number, and no other is larger by 2^32 - 1 or more.
  [[nodiscard]] bool place(std::span<const std::int64_t> ids, std::int64_t leaf) {
    if (first_leaf_ == 0) first_leaf_ = leaf;
    for (const std::int64_t id : ids) {
      const std::size_t place = place_of(id);
      if (place == ids_.size() || ids_[place] != id) return false;
      leaves_[place] = static_cast<std::uint32_t>(leaf - first_leaf_);
    }
    return true;
  }
  /// True if every id has a leaf.
  bool is_complete() const { return std::find(leaves_.begin(), leaves_.end(), nowhere) == leaves_.end(); }

  std::span<const std::int64_t> ids() const { return ids_; }
  /// Calls each(entries) with consecutive chunks of all ids; no block of the stored map is in two chunks.
  template <class Each>
  void for_each_chunk(Each each) const {
    constexpr std::size_t chunk_size = 1 << 14;
    std::vector<IdHashMap::Entry> chunk;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const bool starts_block = i > 0 && IdBlock::base_of(ids_[i]) != IdBlock::base_of(ids_[i - 1]);
      if (starts_block && chunk.size() >= chunk_size)
        each(std::span<const IdHashMap::Entry>(chunk)), chunk.clear();
      chunk.push_back({ids_[i], first_leaf_ + leaves_[i]});
    }
    if (!chunk.empty()) each(std::span<const IdHashMap::Entry>(chunk));
  }

 private:
  static constexpr std::uint32_t nowhere = 0xffffffff;

  /// The index of an id, or where it would be.
  std::size_t place_of(std::int64_t id) const {
    if (ids_.empty() || id < ids_.front() || id > ids_.back()) return ids_.size();
    const std::size_t last = ids_.size() - 1;
    const double from = number(ids_.front()), range = std::max(number(ids_.back()) - from, 1.0);
    std::size_t low = std::min(last, static_cast<std::size_t>((number(id) - from) / range * number(last)));
    std::size_t high = low;  // until ids_[low] <= id <= ids_[high]
    for (std::size_t step = 1; ids_[low] > id; step *= 2) high = low, low -= std::min(low, step);
    for (std::size_t step = 1; ids_[high] < id; step *= 2) low = high, high += std::min(last - high, step);
    const auto at = [&](std::size_t i) { return ids_.begin() + static_cast<std::ptrdiff_t>(i); };
    return static_cast<std::size_t>(std::lower_bound(at(low), at(high), id) - ids_.begin());
  }
  static double number(auto value) { return static_cast<double>(value); }

  std::int64_t first_leaf_ = 0;  ///< 0: not known yet
  std::vector<std::int64_t> ids_;
  std::vector<std::uint32_t> leaves_;
};

}  // namespace foresee
