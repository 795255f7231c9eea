// What time is it in this table? Objects are mostly written with the current time as their t, but some are
// scheduled for later and some come late, so the clock is the median t of the last writes.
//
// Only the tree's shape depends on it, never an answer.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace foresee {

class WriteClock {
 public:
  /// How many writes it knows of.
  static constexpr std::size_t memory = 15;

  double now() const { return now_; }
  /// False until something has been written.
  bool runs() const { return count_ > 0; }

  /// An object with this t is being written. A fresh clock believes its first write.
  void saw(double t) {
    if (count_ == 0) recent_.fill(t);
    recent_[count_++ % recent_.size()] = t;
    if (t == now_ && count_ > 1) return;
    auto sorted = recent_;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    now_ = sorted[sorted.size() / 2];
  }
  /// A whole table was written, with `t` as its typical time.
  void set(double t) { recent_.fill(t), now_ = t, count_ = recent_.size(); }

 private:
  std::array<double, memory> recent_{};
  std::size_t count_ = 0;
  double now_ = 0;
};

}  // namespace foresee
