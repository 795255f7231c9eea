// Time slabs of a join: parts of the horizon [now, now + h] that are joined one after another. So swept boxes
// stay small and the earliest contacts come first.
//
//   TimeSlabs slabs(question, {.step = 12, .first = 0.5});
//   while (auto slab = slabs.next())
//     while (first_contact(slab->horizon, pair, times))     // of one candidate after the other
//       if (slab->holds(times.t)) report(pair);
//
// A pair belongs to the slab that holds the `t` of its first contact, so it is reported once without a set of
// reported pairs. If it is still in contact in a later slab, it is a candidate again, but its t is earlier.
// As t is the exact time rounded once, and rounding is monotonic, slabs are in the order of t and of dt.
//
// Guarantee: the real times that round to a t held by a slab lie within the slab's horizon, which is widened
// by a unit in the last place where that is needed.
#pragma once

#include <optional>

#include "query/join/question.h"

namespace foresee {

struct TimeSlab {
  double from, before;  ///< of t; infinite in the first and in the last slab
  Horizon horizon;

  bool holds(double t) const { return from <= t && (t < before || is_last()); }
  /// Whether the slab holds every t, as the only slab of a join does.
  bool holds_all() const { return from == -std::numeric_limits<double>::infinity() && is_last(); }
  /// A contact that starts after the largest double has the t infinity; the last slab holds it.
  bool is_last() const { return before == std::numeric_limits<double>::infinity(); }
};

/// In seconds. The first slab has the length `first`, later ones grow up to `step`.
struct SlabLengths {
  double step;
  double first;
  bool instant = false;  ///< before them, one slab for the pairs that touch at `now`
};

class TimeSlabs {
 public:
  /// Slabs that cover the queried times (queried_t, queried_dt).
  TimeSlabs(const JoinQuestion& question, const SlabLengths& lengths);

  /// The next slab in time; empty after the last. Exactly one slab holds each queried t.
  std::optional<TimeSlab> next();

 private:
  /// The slab that holds each t in [start, end); its horizon has every real time that rounds to one.
  TimeSlab slab(double start, double end, bool last) const;

  Horizon horizon_;
  SlabLengths lengths_;
  double start_, end_;  // the smallest and the largest queried t
  double at_;           // the start of the next slab
  bool done_;
};

}  // namespace foresee
