// The times for which a tree is shaped: the clock of its writes, and a reference time for the objects that
// share a node.
//
//   const ReferenceTimes times(now);
//   times.of({.t_min = 500, .t_max = 500, .until_max = 510})       // 505: the middle of a leg's life
//   times.of({.t_min = 0, .t_max = 0, .until_max = infinity})      // the clock: a ship whose motion has no end
//
// A motion without an end is queried at the current time, which the clock estimates. A motion that exists
// during [t, until] only, such as a leg of a schedule, is queried at any time in between. The clock says
// nothing about it, so its reference time is the middle of its life. A position report that expires some time
// after the clock ("until = t + 900") is queried now. So lives are *current* if they include the clock and have
// more in common than they differ: their reference time is the clock, too.
//
// Only the shape of the tree depends on these times, never a result.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "index/tpr_tree/node.h"

namespace foresee {

// The write clock estimates the current time of a table. Most objects are written with the current time as
// their t, but some are scheduled for later and some arrive late. So the clock is the median t of the last
// writes.
class WriteClock {
 public:
  /// The number of writes that it remembers.
  static constexpr std::size_t memory = 15;

  double now() const { return now_; }
  /// False until the first write.
  bool runs() const { return count_ > 0; }

  /// Called when an object with this t is written. The first write sets the clock.
  void observe(double t) {
    if (count_ == 0) recent_.fill(t);
    recent_[count_++ % recent_.size()] = t;
    if (t == now_ && count_ > 1) return;
    auto sorted = recent_;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    now_ = sorted[sorted.size() / 2];
  }
  /// Called when a whole table was written; `t` is its typical time.
  void set(double t) {
    recent_.fill(t);
    now_ = t;
    count_ = recent_.size();
  }

 private:
  std::array<double, memory> recent_{};
  std::size_t count_ = 0;
  double now_ = 0;
};

/// The middle of the lives of an entry.
inline double middle_of(const Times& times) {
  return 0.5 * times.t_min + 0.5 * times.until_max;
}

/// The lives beneath a node. Each child counts once, so one of another time hardly moves the mean of their middles.
struct Lives {
  Times all;
  double middles = 0;  ///< their sum
  std::size_t children = 0;

  void include(const Times& child) {
    all.include(child);
    middles += middle_of(child);
    ++children;
  }
};

class ReferenceTimes {
 public:
  explicit ReferenceTimes(double clock) : clock_(clock) {}

  /// True if the clock is the reference time: some object has no end, or the lives are current.
  bool is_clock(const Times& times) const {
    const double in_common = times.until_max - times.t_max, late = 0.25 * in_common;
    const bool is_current = (in_common > times.t_max - times.t_min) & (times.t_min - late <= clock_) &
                            (clock_ <= times.until_max + late);
    return !ends(times) | is_current;
  }
  /// Always finite.
  double of(const Times& times) const { return or_clock(times, middle_of(times)); }
  double mean_of(const Lives& lives) const {
    return or_clock(lives.all, lives.middles / static_cast<double>(lives.children));
  }

 private:
  double or_clock(const Times& times, double middle) const {
    return is_clock(times) || !std::isfinite(middle) ? clock_ : middle;
  }

  double clock_;
};

}  // namespace foresee
