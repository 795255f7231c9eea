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

#include "base/repeatable_choice.h"

namespace foresee {

class IdFilter {
 public:
  /// `ids`: as many as are expected at first.
  explicit IdFilter(std::size_t ids = 0) { add_layer(std::max(ids, min_ids)); }

  void add(std::int64_t id) { add(Hash(id)); }
  /// Adds many ids, without waiting for memory at each. An empty filter becomes one layer for all of them.
  void add(std::span<const std::int64_t> ids) {
    if (is_empty() && left_ < ids.size()) *this = IdFilter(ids.size());
    constexpr std::size_t at_once = 64;  // what is prefetched stays in the processor's caches
    for (; !ids.empty(); ids = ids.subspan(std::min(at_once, ids.size()))) {
      std::array<Hash, at_once> hashes;
      const std::size_t count = std::min(at_once, ids.size());
      for (std::size_t i = 0; i < count; ++i) {
        hashes[i] = Hash(ids[i]);
        for (const std::vector<Block>& blocks : layers_)
          __builtin_prefetch(&blocks[hashes[i].block(blocks.size())]);
      }
      for (std::size_t i = 0; i < count; ++i) add(hashes[i]);
    }
  }
  bool may_have(std::int64_t id) const noexcept {
    const Hash hash(id);
    return std::any_of(layers_.rbegin(), layers_.rend(),
                       [&](const std::vector<Block>& blocks) { return has(blocks, hash); });
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

  /// The upper half of the hash selects the block; the lower half, mixed again, selects six bits in it.
  struct Hash {
    Hash() = default;
    explicit Hash(std::int64_t id) {
      const std::uint64_t hash = hash_of(static_cast<std::uint64_t>(id));
      upper = hash >> 32;
      bits = (hash & 0xffffffff) * by_golden_ratio;
    }
    std::size_t block(std::size_t blocks) const { return upper * blocks >> 32; }
    /// The place of bit `i` in the block, 0 to 511.
    unsigned bit(unsigned i) const { return static_cast<unsigned>(bits << 9 * i >> 55); }

    std::uint64_t upper, bits;
  };
  static constexpr unsigned bits_per_id = 6;

  static bool has(const std::vector<Block>& blocks, const Hash& hash) noexcept {
    const Block& block = blocks[hash.block(blocks.size())];
    std::uint64_t all = 1;
    for (unsigned i = 0; i < bits_per_id; ++i) all &= block.words[hash.bit(i) / 64] >> hash.bit(i) % 64;
    return all != 0;
  }

  void add(const Hash& hash) {
    for (std::size_t older = 0; older + 1 < layers_.size(); ++older)
      if (has(layers_[older], hash)) return;
    if (left_ == 0) {
      if (has(layers_.back(), hash)) return;
      add_layer(2 * ids_per_block * layers_.back().size());
    }
    std::vector<Block>& blocks = layers_.back();
    Block& block = blocks[hash.block(blocks.size())];
    std::uint64_t added = 0;
    for (unsigned i = 0; i < bits_per_id; ++i) {
      std::uint64_t& word = block.words[hash.bit(i) / 64];
      const std::uint64_t bit = std::uint64_t{1} << hash.bit(i) % 64;
      added |= ~word & bit;
      word |= bit;
    }
    left_ -= added != 0;
  }

  bool is_empty() const { return layers_.size() == 1 && left_ == layers_[0].size() * ids_per_block; }
  void add_layer(std::size_t ids) {
    const std::size_t blocks = ids / ids_per_block + 1;
    layers_.emplace_back(blocks);
    left_ = blocks * ids_per_block;
  }

  std::vector<std::vector<Block>> layers_;  ///< ids are added to the last one
  std::size_t left_ = 0;                    ///< ids that it has room for
};

}  // namespace foresee
