// In which leaf is each object, where all of them are known beforehand and the whole table is loaded anew?
//
//   PackedMap map(sorted_ids);
//   map.place(ids_of_leaf, 7) && map.is_complete()          // leaf by leaf
//   map.for_each_part([&](auto entries) { … });             // all, ascending, some thousand at a time
//
// What map_changes.h keeps can be taken back and asked about, at 50 to 100 bytes an id; this is for ten
// million. Objects are read twice, from files that somebody may have written into: what does not match is
// told, and nothing is written elsewhere. Cost: 12 bytes an id, and for placing it a search from where it is
// if ids are spread evenly: some nanoseconds where they are, at most twice a binary search.
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
  /// Requires: ids ascend, and none comes twice.
  explicit PackedMap(std::vector<std::int64_t> ids) : ids_(std::move(ids)), leaves_(ids_.size(), nowhere) {}

  /// False if an id is not among those that are known. Requires: the first leaf comes first, and no other is
  /// 2^32 - 1 behind it.
  [[nodiscard]] bool place(std::span<const std::int64_t> ids, std::int64_t leaf) {
    if (first_leaf_ == 0) first_leaf_ = leaf;
    for (const std::int64_t id : ids) {
      const std::size_t place = place_of(id);
      if (place == ids_.size() || ids_[place] != id) return false;
      leaves_[place] = static_cast<std::uint32_t>(leaf - first_leaf_);
    }
    return true;
  }
  /// Every id has its leaf.
  bool is_complete() const { return std::find(leaves_.begin(), leaves_.end(), nowhere) == leaves_.end(); }

  std::span<const std::int64_t> ids() const { return ids_; }
  /// Calls each(entries) until all ids have come; no block of the stored map is in two calls.
  template <class Each>
  void for_each_part(Each each) const {
    constexpr std::size_t many = 1 << 14;
    std::vector<IdHashMap::Entry> part;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const bool starts_block = i > 0 && IdBlock::base_of(ids_[i]) != IdBlock::base_of(ids_[i - 1]);
      if (starts_block && part.size() >= many) each(std::span<const IdHashMap::Entry>(part)), part.clear();
      part.push_back({ids_[i], first_leaf_ + leaves_[i]});
    }
    if (!part.empty()) each(std::span<const IdHashMap::Entry>(part));
  }

 private:
  static constexpr std::uint32_t nowhere = 0xffffffff;

  /// Where an id is, or would be.
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

  std::int64_t first_leaf_ = 0;  ///< 0: none yet
  std::vector<std::int64_t> ids_;
  std::vector<std::uint32_t> leaves_;
};

}  // namespace foresee
