// Bloom filter of ids: rejects most look-ups of new ids, each of which would read another block of the stored
// map. It is used after a large load.
//
//   IdFilter filter(10'000'000);
//   filter.add(42);
//   filter.may_have(42)                        // true; rarely true for an id that was not added
//
// Blocked by cache lines (F. Putze, P. Sanders, J. Singler, "Cache-, hash- and space-efficient Bloom
// filters", J. Experimental Algorithmics 14, 2009): six bits per id, in 16 bits of memory per id. The
// false-positive rate is about 1 in 500, and higher if more ids are added than announced. Cost: one cache
// miss.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace foresee {

class IdFilter {
 public:
  explicit IdFilter(std::size_t ids) : blocks_(ids / ids_per_block + 1) {}

  void add(std::int64_t id) noexcept {
    const Bits bits(id, blocks_.size());
    for (const unsigned bit : bits.at) blocks_[bits.block].words[bit / 64] |= std::uint64_t{1} << bit % 64;
  }
  bool may_have(std::int64_t id) const noexcept {
    const Bits bits(id, blocks_.size());
    std::uint64_t all = 1;
    for (const unsigned bit : bits.at) all &= blocks_[bits.block].words[bit / 64] >> bit % 64;
    return all != 0;
  }
  std::size_t memory() const { return blocks_.size() * sizeof(Block); }

 private:
  static constexpr std::size_t ids_per_block = 32;
  struct alignas(64) Block {
    std::array<std::uint64_t, 8> words{};
  };

  /// Hash: MurmurHash3's finalizer. The upper half selects the block; the lower half, mixed again, selects
  /// six bits in it.
  struct Bits {
    Bits(std::int64_t id, std::size_t blocks) {
      auto hash = static_cast<std::uint64_t>(id);
      hash = (hash ^ hash >> 33) * 0xff51afd7ed558ccd;
      hash = (hash ^ hash >> 33) * 0xc4ceb9fe1a85ec53;
      hash ^= hash >> 33;
      block = (hash >> 32) * blocks >> 32;
      hash = (hash & 0xffffffff) * 0x9e3779b97f4a7c15;
      for (unsigned& bit : at) bit = static_cast<unsigned>(hash >> 55), hash <<= 9;
    }
    std::size_t block;
    std::array<unsigned, 6> at;  ///< 0 to 511
  };

  std::vector<Block> blocks_;
};

}  // namespace foresee
