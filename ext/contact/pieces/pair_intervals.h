// When may two objects touch that are unions of pieces, and which pieces are it then? Trees of boxes and
// tests of pieces, for one pair.
//
//   for (double from = intervals.first_possible(-inf); from < inf; from = intervals.first_possible(until)) {
//     until = intervals.possible_until(from);
//     intervals.possible_pairs({from, until}, ask);               // at no other moments may they touch
//   }
#pragma once

#include "contact/pieces/pair_context.h"
#include "numbers/dyadic.h"

namespace foresee {

/// `Traits`: what the pieces are (pair_context.h).
template <class Traits>
class PairIntervals {
 public:
  /// `times_wanted`: more is asked than whether they touch.
  PairIntervals(const PairContext<Traits>& context, bool times_wanted, typename Traits::Space& space)
      : context_(context),
        containment_(context.setup, context.row_a, context.row_b, context.a, context.b, context.relative,
                     context.steps),
        tests_(context.a, context.b, context.relative, context.queried, context.sizes, times_wanted, space) {}

  PairIntervals(const PairIntervals&) = delete;
  PairIntervals& operator=(const PairIntervals&) = delete;

  /// When contact may begin that begins later than `after`; infinite if none may.
  double first_possible(double after) {
    double first = UncertainInterval::inf;
    context_.walk.visit(
        Order::earlier_first,
        [&](const Interval<double>& near) { return near.end > after && near.begin < first; },
        [&](std::size_t a, std::size_t b, const Interval<double>& near) {
          for (const PieceInterval& interval : tests_.of(a, b)) {
            const auto [begin, end] = possible(interval, near);
            if (begin <= end && begin > after) first = std::min(first, begin);
          }
        });
    return first;
  }
  /// Until when contact may last that may be at `from`.
  double possible_until(double from) {
    double until = from, passed_by = from;
    while (passed_by <= until) {
      passed_by = UncertainInterval::inf;
      const auto starts_by_then = [&](double begin) {
        if (begin > until) passed_by = std::min(passed_by, begin);
        return begin <= until;
      };
      context_.walk.visit(
          Order::earlier_first,
          [&](const Interval<double>& near) { return near.end >= from && starts_by_then(near.begin); },
          [&](std::size_t a, std::size_t b, const Interval<double>& near) {
            for (const PieceInterval& interval : tests_.of(a, b)) {
              const auto [begin, end] = possible(interval, near);
              if (begin <= end && end >= from && starts_by_then(begin)) until = std::max(until, end);
            }
          });
    }
    return until;
  }
  /// Gives `take` each pair of pieces that may touch within the period, as long as it returns true. It may
  /// shorten the period.
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
  /// Whether one lies within the other when what is asked about begins. Where the surfaces touch then it may
  /// say anything.
  bool is_within_at_start() {
    const Interval<double>& near = context_.walk.near();
    return containment_.may_be() && near.begin <= context_.queried.begin.high && near.begin <= near.end &&
           containment_.at_start();
  }
  bool is_grown() const { return is_of_size(context_.sizes.radius); }  ///< near counts as touching

  /// Whether one lies within the other. Requires: their surfaces do not touch then.
  bool is_within_at(const Dyadic& time) { return containment_.at(time); }

 protected:
  /// At no other moment may they touch; never if the end is before the begin.
  static Interval<double> possible(const PieceInterval& interval, const Interval<double>& near) {
    return {std::max(interval.begin.low, near.begin), std::min(interval.end.high, near.end)};
  }

  const PairContext<Traits>& context_;
  typename Traits::Containment containment_;
  typename Traits::Tests tests_;
};

}  // namespace foresee
