// Interval tree: of many intervals, those that have a number in common with a given one.
//
//   const IntervalTree lives({{0, 5}, {3, 4}, {0, 1e300}});
//   lives.find(2, 3.5, [&](std::size_t number) { use(number); return true; });     // 0, 1 and 2 in some order
//
// Intervals are closed, and may be infinite; an empty one (begin > end) is never found. Cost: a sort; a call takes the
// logarithm of their number for each interval that it finds, however long others are.
// Source: Cormen, Leiserson, Rivest, Stein, "Introduction to Algorithms" (2009), section 14.3; here in an array.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

namespace foresee {

class IntervalTree {
 public:
  struct Interval {
    double begin, end;
  };

  explicit IntervalTree(const std::vector<Interval>& intervals) {
    for (std::size_t i = 0; i < intervals.size(); ++i)
      if (intervals[i].begin <= intervals[i].end) order_.push_back(i);
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t i, std::size_t j) { return intervals[i].begin < intervals[j].begin; });
    leaves_ = std::bit_ceil(std::max<std::size_t>(1, order_.size()));
    last_end_.assign(2 * leaves_, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      starts_.push_back(intervals[order_[i]].begin);
      last_end_[leaves_ + i] = intervals[order_[i]].end;
    }
    for (std::size_t node = leaves_ - 1; node > 0; --node)
      last_end_[node] = std::max(last_end_[2 * node], last_end_[2 * node + 1]);
  }

  /// Calls use(number) for each interval that meets this one, until it returns false. Returns false then.
  template <class Use>
  bool find(double begin, double end, Use use) const {
    const auto count =
        static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), end) - starts_.begin());
    return count == 0 || find_beneath(1, 0, leaves_, begin, count, use);
  }

 private:
  /// Of the first `count` intervals, those from `first` on beneath a node of so many.
  template <class Use>
  bool find_beneath(std::size_t node, std::size_t first, std::size_t width, double begin, std::size_t count,
                    Use& use) const {
    if (first >= count || last_end_[node] < begin) return true;
    if (width == 1) return use(order_[first]);
    return find_beneath(2 * node, first, width / 2, begin, count, use) &&
           find_beneath(2 * node + 1, first + width / 2, width / 2, begin, count, use);
  }

  std::vector<std::size_t> order_;  ///< the intervals by their start
  std::vector<double> starts_;      ///< in this order
  std::size_t leaves_;              ///< a power of two
  std::vector<double> last_end_;  ///< beneath each node; the root is 1, the children of n are 2 n and 2 n + 1
};

}  // namespace foresee
