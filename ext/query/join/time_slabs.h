// When is each part of a join's horizon looked at? Time slabs: [now, now + h] cut into parts that are asked
// one after another, so that swept boxes stay small and the earliest contacts come first.
//
//   TimeSlabs slabs(question, {.step = 12, .first = 0.5});
//   while (auto slab = slabs.next())
//     while (first_contact(slab->horizon, pair, times))     // of one candidate after the other
//       if (slab->holds(times.t)) report(pair);
//
// A pair belongs to the slab that holds the `t` of its first contact, so it is reported once and no set
// remembers it: where it is still in contact in a later slab it is a candidate again, but its t is earlier.
// As t is the exact moment rounded once, and rounding keeps order, slabs are in the order of t and of dt.
//
// Guarantee: the moments that round to a t held by a slab lie within the slab's horizon, which is widened by
// a unit in the last place where that is needed.
#pragma once

#include <optional>

#include "query/join/question.h"

namespace foresee {

struct TimeSlab {
  double from, before;  ///< of t; infinite at the ends of the question
  Horizon horizon;

  bool holds(double t) const { return from <= t && (t < before || is_last()); }
  /// Also what begins after the last double has a t: infinity.
  bool is_last() const { return before == std::numeric_limits<double>::infinity(); }
};

/// In seconds. Slabs begin with the length `first` and grow to `step`.
struct SlabLengths {
  double step;
  double first;
  bool instant = false;  ///< before them one slab of what touches at `now` already
};

class TimeSlabs {
 public:
  /// Slabs for those moments that the question asks about (queried_t, queried_dt).
  TimeSlabs(const JoinQuestion& question, const SlabLengths& lengths);

  /// The next one, later than all before; nothing behind the last. Each t that is asked for is held by
  /// exactly one.
  std::optional<TimeSlab> next();

 private:
  /// What holds the t from `begin` to before `end`, and in its horizon every moment that rounds to one.
  TimeSlab slab(double begin, double end, bool last) const;

  Horizon horizon_;
  SlabLengths lengths_;
  double begin_, end_;  // the least and the greatest t that are asked for
  double at_;           // where the next slab begins
  bool done_;
};

}  // namespace foresee
