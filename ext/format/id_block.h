// Block of an id map: the leaf numbers of 64 consecutive ids, which are one row of <name>_map.
//
//   IdBlock block(IdBlock::base_of(-5));             // ids -64 to -1
//   block.set(-5, 7), block.leaf_of(-5) == 7
//   std::vector<std::byte> bytes = block.encode();   // 4 bytes here
//   if (const char* fault = other.decode(bytes)) …   // checks bytes of a file, which may be damaged
//
// The bytes: the width of a leaf number; the ids that exist, as offsets from the base, ascending; their leaf
// numbers in the same order, little-endian. In a table of a million objects that is about 3 bytes per id; a
// row per id takes 10 bytes and half a microsecond. Cost: one pass over the ids.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foresee {

class IdBlock {
 public:
  static constexpr std::int64_t ids = 64;

  static std::int64_t base_of(std::int64_t id) { return id & -ids; }

  explicit IdBlock(std::int64_t base) : base_(base) {}

  std::int64_t base() const { return base_; }
  /// The largest id of this block.
  std::int64_t last() const { return base_ + (ids - 1); }
  /// The number of ids that have a leaf.
  std::size_t count() const { return count_; }

  /// 0: no such object. Requires: base() <= id <= last().
  std::int64_t leaf_of(std::int64_t id) const { return leaves_[slot_of(id)]; }
  void set(std::int64_t id, std::int64_t leaf) {
    std::int64_t& old = leaves_[slot_of(id)];
    count_ += static_cast<std::size_t>(leaf != 0) - static_cast<std::size_t>(old != 0);
    old = leaf;
  }

  /// Calls each(id, leaf) for every id that has a leaf, ascending.
  template <class Each>
  void for_each(Each each) const {
    for (std::int64_t i = 0; i < ids; ++i)
      if (const std::int64_t leaf = leaves_[static_cast<std::size_t>(i)]) each(base_ + i, leaf);
  }

  std::vector<std::byte> encode() const;
  /// Reads a block with this base. Returns what is wrong with the bytes; null: nothing.
  const char* decode(std::span<const std::byte> bytes);

 private:
  std::size_t slot_of(std::int64_t id) const { return static_cast<std::size_t>(id & (ids - 1)); }

  std::int64_t base_;
  std::size_t count_ = 0;
  std::array<std::int64_t, ids> leaves_{};
};

}  // namespace foresee
