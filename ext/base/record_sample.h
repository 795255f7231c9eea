// Random sample of records: represents all objects of a table that does not fit into memory, whatever their
// number and order.
//
//   RecordSample sample(6);
//   sample.add(record);                     // for each object
//   sample.records()                        // at most 16384; some thousand at least, if there are so many
//
// Each record has the same chance. A sample of every 2^k-th record would be biased: rows often repeat
// periodically, as columns of a grid or ships of a fleet. The sample is deterministic: the same objects give
// the same sample.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/repeatable_choice.h"

namespace foresee {

class RecordSample {
 public:
  explicit RecordSample(std::size_t record_size) : record_size_(record_size) {}

  void add(const double* record) {
    const std::uint64_t draw = draw_of(seen_++);
    if (!is_drawn(draw)) return;
    while (draws_.size() == limit) drop_half();
    if (!is_drawn(draw)) return;
    records_.insert(records_.end(), record, record + record_size_);
    draws_.push_back(draw);
  }

  std::span<const double> records() const { return records_; }

 private:
  static constexpr std::size_t limit = 1 << 14;

  /// The finalizer of SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators",
  /// OOPSLA 2014): the bits of consecutive numbers are independent.
  static std::uint64_t draw_of(std::uint64_t number) {
    std::uint64_t z = (number + 1) * by_golden_ratio;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  bool is_drawn(std::uint64_t draw) const { return (draw & undrawn_) == 0; }

  void drop_half() {
    undrawn_ = 2 * undrawn_ + 1;
    std::size_t kept = 0;
    const auto at = [&](std::size_t i) {
      return records_.begin() + static_cast<std::ptrdiff_t>(i * record_size_);
    };
    for (std::size_t i = 0; i < draws_.size(); ++i) {
      if (!is_drawn(draws_[i])) continue;
      if (kept != i) {
        std::copy_n(at(i), record_size_, at(kept));
        draws_[kept] = draws_[i];
      }
      ++kept;
    }
    draws_.resize(kept);
    records_.resize(kept * record_size_);
  }

  std::size_t record_size_;
  std::uint64_t seen_ = 0, undrawn_ = 0;  ///< undrawn_: bits of a draw that must be zero
  std::vector<std::uint64_t> draws_;      ///< of the kept records
  std::vector<double> records_;
};

}  // namespace foresee
