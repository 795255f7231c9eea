// The times at which two unions of pieces may touch, and the pairs of pieces that may touch then.
//
//   for (double from = intervals.first_possible(-inf); from < inf; from = intervals.first_possible(until)) {
//     until = intervals.possible_until(from);
//     intervals.possible_pairs({from, until}, visit);               // they touch at no time outside of these
//   }
#pragma once

#include "contact/certified/pair_context.h"
#include "contact/certified/pair_tests.h"
#include "numbers/dyadic.h"

namespace foresee {

/// `Traits`: what the pieces are (pair_context.h).
template <class Traits>
class PairIntervals {
 public:
  /// Both must outlive this.
  PairIntervals(const PairContext<Traits>& context, typename Traits::Space& space)
      : context_(context), containment_(context), tests_(context, space) {}

  PairIntervals(const PairIntervals&) = delete;
  PairIntervals& operator=(const PairIntervals&) = delete;

  const PairContext<Traits>& context() const { return context_; }

  /// A lower bound on the start of the first contact that starts later than `after`; infinite if no contact
  /// can.
  double first_possible(double after) {
    double first = unbounded;
    for_each_interval(
        Order::earlier_first,
        [&](const Interval<double>& near) { return near.end > after && near.begin < first; },
        [&](const PieceInterval& interval, const Interval<double>& near) {
          const auto [begin, end] = possible(interval, near);
          if (begin <= end && begin > after) first = std::min(first, begin);
        });
    return first;
  }
  /// An upper bound on the end of a contact that there may be at `from`.
  double possible_until(double from) {
    double until = from, passed_by = from;
    while (passed_by <= until) {
      passed_by = unbounded;
      const auto starts_by_then = [&](double begin) {
        if (begin > until) passed_by = std::min(passed_by, begin);
        return begin <= until;
      };
      for_each_interval(
          Order::earlier_first,
          [&](const Interval<double>& near) { return near.end >= from && starts_by_then(near.begin); },
          [&](const PieceInterval& interval, const Interval<double>& near) {
            const auto [begin, end] = possible(interval, near);
            if (begin <= end && end >= from && starts_by_then(begin)) until = std::max(until, end);
          });
    }
    return until;
  }
  /// Calls `take` with each pair of pieces that may touch within the period, until it returns false.
  /// `take` may shorten the period.
  template <class Take>
  void possible_pairs(const Interval<double>& period, Take&& take) {
    bool more = true;
    context_.walk.visit(
        Order::earlier_first,
        [&](const Interval<double>& near) {
          return more && near.begin <= period.end && near.end >= period.begin;
        },
        [&](std::size_t a, std::size_t b, const Interval<double>& near) {
          const auto intervals = tests_.of(a, b);
          if (std::any_of(intervals.begin(), intervals.end(), [&](const PieceInterval& interval) {
                const auto [begin, end] = possible(interval, near);
                return begin <= end && begin <= period.end && end >= period.begin;
              }))
            more = take(PiecePair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
        });
  }
  /// Whether one object is inside the other when the queried time starts. If the surfaces touch then, the
  /// result is arbitrary.
  bool is_inside_at_start() {
    const Interval<double>& near = context_.walk.near();
    return containment_.may_be() && near.begin <= context_.queried.begin.high && near.begin <= near.end &&
           containment_.at_start();
  }
  bool is_grown() const { return is_of_size(context_.sizes.radius); }  ///< the contact distance is not 0

  /// Whether one object is inside the other. Requires: the surfaces do not touch then.
  bool is_inside_at(const Dyadic& time) { return containment_.at(time); }

 protected:
  /// The times at which they may touch; no time if the end is before the start.
  static Interval<double> possible(const PieceInterval& interval, const Interval<double>& near) {
    return {std::max(interval.begin.low, near.begin), std::min(interval.end.high, near.end)};
  }

  /// Calls `use` with the intervals of each pair of pieces that the walk visits.
  template <class Wanted, class Use>
  void for_each_interval(Order order, Wanted&& wanted, Use&& use) {
    context_.walk.visit(order, wanted, [&](std::size_t a, std::size_t b, const Interval<double>& near) {
      for (const PieceInterval& interval : tests_.of(a, b)) use(interval, near);
    });
  }

  const PairContext<Traits>& context_;
  typename Traits::Containment containment_;
  typename Traits::Tests tests_;
};

}  // namespace foresee
