// What are the objects like of which only some fit into memory? Some are drawn, each with the same chance, so
// that they stand for all, however many come and in whatever order.
//
//   RecordSample sample(6);
//   sample.add(record);                     // of each object
//   sample.records()                        // at most 16384, of more at least some thousand
//
// Every 2^k-th would not do: rows often come in rounds, of a grid or of a fleet, and such a sample has seen
// one column of the grid, one ship of the fleet. The same objects give the same sample.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace foresee {

class RecordSample {
 public:
  explicit RecordSample(std::size_t record_size) : record_size_(record_size) {}

  void add(const double* record) {
    const std::uint64_t lot = lot_of(seen_++);
    if (!is_drawn(lot)) return;
    while (lots_.size() == limit) draw_half();
    if (!is_drawn(lot)) return;
    records_.insert(records_.end(), record, record + record_size_);
    lots_.push_back(lot);
  }

  std::span<const double> records() const { return records_; }

 private:
  static constexpr std::size_t limit = 1 << 14;

  /// The finalizer of SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators",
  /// OOPSLA 2014): neighbours get bits that have nothing to do with one another.
  static std::uint64_t lot_of(std::uint64_t number) {
    std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  bool is_drawn(std::uint64_t lot) const { return (lot & undrawn_) == 0; }

  void draw_half() {
    undrawn_ = 2 * undrawn_ + 1;
    std::size_t kept = 0;
    const auto at = [&](std::size_t i) {
      return records_.begin() + static_cast<std::ptrdiff_t>(i * record_size_);
    };
    for (std::size_t i = 0; i < lots_.size(); ++i) {
      if (!is_drawn(lots_[i])) continue;
      if (kept != i) std::copy_n(at(i), record_size_, at(kept)), lots_[kept] = lots_[i];
      ++kept;
    }
    lots_.resize(kept), records_.resize(kept * record_size_);
  }

  std::size_t record_size_;
  std::uint64_t seen_ = 0, undrawn_ = 0;  ///< undrawn_: bits of a lot that must be zero
  std::vector<std::uint64_t> lots_;       ///< of those that are kept
  std::vector<double> records_;
};

}  // namespace foresee
