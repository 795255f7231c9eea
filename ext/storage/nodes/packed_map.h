// In which leaf is each object, where all of them are known beforehand and the whole table is loaded anew?
//
//   PackedMap map(sorted_ids);
//   map.place(ids_of_leaf, 7);                              // leaf by leaf
//   map.for_each_part([&](auto entries) { … });             // all, ascending, some thousand at a time
//
// What map_changes.h keeps can be taken back and asked about, at 50 to 100 bytes an id; this is for ten
// million. Cost: 12 bytes an id, and a binary search for placing it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "storage/format/id_block.h"
#include "storage/rows/id_hash_map.h"

namespace foresee::storage {

class PackedMap {
 public:
  /// Requires: ids ascend, and none comes twice.
  explicit PackedMap(std::vector<std::int64_t> ids) : ids_(std::move(ids)), leaves_(ids_.size()) {}

  /// Requires: the ids are among those that are known; the first leaf comes first, and no other is 2^32
  /// behind it.
  void place(std::span<const std::int64_t> ids, std::int64_t leaf) {
    if (first_leaf_ == 0) first_leaf_ = leaf;
    for (const std::int64_t id : ids) {
      const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
      leaves_[static_cast<std::size_t>(found - ids_.begin())] =
          static_cast<std::uint32_t>(leaf - first_leaf_);
    }
  }

  /// Calls each(entries) until all ids have come; no block of the stored map is in two calls.
  template <class Each>
  void for_each_part(Each each) const {
    constexpr std::size_t many = 1 << 14;
    std::vector<IdHashMap::Entry> part;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const bool begins_block = i > 0 && IdBlock::base_of(ids_[i]) != IdBlock::base_of(ids_[i - 1]);
      if (begins_block && part.size() >= many) each(std::span<const IdHashMap::Entry>(part)), part.clear();
      part.push_back({ids_[i], first_leaf_ + leaves_[i]});
    }
    if (!part.empty()) each(std::span<const IdHashMap::Entry>(part));
  }

 private:
  std::int64_t first_leaf_ = 0;  ///< 0: none yet
  std::vector<std::int64_t> ids_;
  std::vector<std::uint32_t> leaves_;
};

}  // namespace foresee::storage
