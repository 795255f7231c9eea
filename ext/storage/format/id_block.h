// In which leaves are 64 consecutive ids? One row of <name>_map says it for all of them.
//
//   IdBlock block(IdBlock::base_of(-5));             // ids -64 to -1
//   block.set(-5, 7), block.leaf_of(-5) == 7
//   std::vector<std::byte> bytes = block.encode();   // 4 bytes here
//   if (const char* fault = other.decode(bytes)) …   // bytes of a file may be anything
//
// The bytes: how many a leaf's number takes; which ids there are, as their distances from the base,
// ascending; their leaves, in the same order, little-endian. Some 3 bytes an id in a table of a million
// objects, where a row of its own takes 10 and half a microsecond. Cost: a pass over the ids.
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
  /// The last id that may be in it.
  std::int64_t last() const { return base_ + (ids - 1); }
  /// How many ids there are.
  std::size_t count() const { return count_; }

  /// 0: there is no such object. Requires: base() <= id <= last().
  std::int64_t leaf_of(std::int64_t id) const { return leaves_[place_of(id)]; }
  void set(std::int64_t id, std::int64_t leaf) {
    std::int64_t& old = leaves_[place_of(id)];
    count_ += static_cast<std::size_t>(leaf != 0) - static_cast<std::size_t>(old != 0);
    old = leaf;
  }

  /// Calls each(id, leaf) with those that there are, ascending.
  template <class Each>
  void for_each(Each each) const {
    for (std::int64_t i = 0; i < ids; ++i)
      if (const std::int64_t leaf = leaves_[static_cast<std::size_t>(i)]) each(base_ + i, leaf);
  }

  std::vector<std::byte> encode() const;
  /// What is wrong with the bytes of a block with this base; null: nothing, and the block says what they do.
  const char* decode(std::span<const std::byte> bytes);

 private:
  std::size_t place_of(std::int64_t id) const { return static_cast<std::size_t>(id & (ids - 1)); }

  std::int64_t base_;
  std::size_t count_ = 0;
  std::array<std::int64_t, ids> leaves_{};
};

}  // namespace foresee
