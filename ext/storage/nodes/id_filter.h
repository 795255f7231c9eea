// Bloom filter of ids: rejects most look-ups of new ids, each of which would read another block of the stored
// map. A table has one from its first load on.
//
//   IdFilter filter;
//   filter.add(42);
//   filter.may_have(42)                        // true; rarely true for an id that was not added
//
// Blocked by cache lines (F. Putze, P. Sanders, J. Singler, "Cache-, hash- and space-efficient Bloom
// filters", J. Experimental Algorithmics 14, 2009): six bits per id, in 16 to 32 bits of memory per id. A full
// filter gets a layer of twice the size (P. Almeida, C. Baquero, N. Preguiça, D. Hutchison, "Scalable Bloom
// filters", Information Processing Letters 101, 2007). The false-positive rate is about 1 in 500 per layer.
// Cost: a cache miss per layer.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foresee {

class IdFilter {
 public:
  /// `ids`: as many as are expected at first.
  explicit IdFilter(std::size_t ids = 0) { add_layer(std::max(ids, min_ids)); }

  void add(std::int64_t id) {
    if (may_have(id)) return;
    if (left_ == 0) add_layer(2 * ids_per_block * layers_.back().size());
    --left_;
    const Bits bits(id, layers_.back().size());
    for (const unsigned bit : bits.at)
      layers_.back()[bits.block].words[bit / 64] |= std::uint64_t{1} << bit % 64;
  }
  /// The same for many, without waiting for memory at each.
  void add(std::span<const std::int64_t> ids) {
    for (const std::int64_t id : ids)
      for (const std::vector<Block>& blocks : layers_)
        __builtin_prefetch(&blocks[Bits(id, blocks.size()).block]);
    for (const std::int64_t id : ids) add(id);
  }
  bool may_have(std::int64_t id) const noexcept {
    return std::any_of(layers_.rbegin(), layers_.rend(), [id](const std::vector<Block>& blocks) {
      const Bits bits(id, blocks.size());
      std::uint64_t all = 1;
      for (const unsigned bit : bits.at) all &= blocks[bits.block].words[bit / 64] >> bit % 64;
      return all != 0;
    });
  }
  std::size_t memory() const {
    std::size_t blocks = 0;
    for (const std::vector<Block>& layer : layers_) blocks += layer.size();
    return blocks * sizeof(Block);
  }

 private:
  static constexpr std::size_t ids_per_block = 32, min_ids = 1 << 13;
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

  void add_layer(std::size_t ids) {
    const std::size_t blocks = ids / ids_per_block + 1;
    layers_.emplace_back(blocks);
    left_ = blocks * ids_per_block;
  }

  std::vector<std::vector<Block>> layers_;  ///< ids are added to the last one
  std::size_t left_ = 0;                    ///< ids that it has room for
};

}  // namespace foresee
