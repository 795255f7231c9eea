// Has this pair of pieces been tested before? A set of pairs with a number each: open addressing, emptied
// without being touched.
#pragma once

#include <cstdint>
#include <vector>

namespace foresee {

/// Numbers of two pieces, one of each object.
struct PiecePair {
  std::uint32_t a, b;

  friend auto operator<=>(const PiecePair&, const PiecePair&) = default;
};

class TestedPairs {
 public:
  void clear() { ++round_, count_ = 0; }
  std::uint32_t size() const { return count_; }

  /// The number of a pair, and whether it is new: numbers count from 0.
  struct Place {
    std::uint32_t number;
    bool is_new;
  };
  Place add(const PiecePair& pair) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slot_of(pair);
    const bool is_new = slot.round != round_;
    if (is_new) slot = {pair, count_++, round_};
    return {slot.number, is_new};
  }

 private:
  struct Slot {
    PiecePair pair = {};
    std::uint32_t number = 0;
    std::uint64_t round = 0;  ///< what is of another round is free
  };

  Slot& slot_of(const PiecePair& pair) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = ((std::uint64_t{pair.a} << 32 | pair.b) * 0x9e3779b97f4a7c15U >> 32) & mask;
    while (slots_[i].round == round_ && slots_[i].pair != pair) i = (i + 1) & mask;
    return slots_[i];
  }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.round == round_) slot_of(slot.pair) = slot;
  }

  std::vector<Slot> slots_;
  std::uint64_t round_ = 1;
  std::uint32_t count_ = 0;
};

}  // namespace foresee
