// When may two objects touch that are unions of pieces, and which pieces are it then? Trees of boxes and
// tests of pieces, for one pair.
//
//   for (double from = stays.first_possible(-inf); from < inf; from = stays.first_possible(until)) {
//     until = stays.possible_until(from);
//     stays.possible_pairs({from, until}, ask);               // at no other moments may they touch
//   }
//
// A Kit says what the pieces are. It has `axes` and `degree` of the motion, the types Pieces (of one object,
// under a tree), Condition, Sizes<T>, Space, Tests (pair_tests.h) and NodeTests (tree_walk.h), sizes_of<T>()
// and Within, which tells of solids whether one lies within the other; `has_solids` says that there may be
// some.
#pragma once

#include "contact/certain/advancement.h"
#include "contact/certain/certain_motion.h"
#include "contact/pieces/tree_walk.h"
#include "numbers/dyadic.h"

namespace foresee::contact {

template <class Kit>
class PairStays {
 public:
  using Pieces = typename Kit::Pieces;

  /// The moments must not be none. `times_wanted`: more is asked than whether they touch. An interrupt is
  /// heeded at each of the `steps`.
  PairStays(const Setup& setup, const double* row_a, const double* row_b, const Pieces& a, const Pieces& b,
            const Moments& moments, bool times_wanted, typename Kit::Space& space, Steps& steps)
      : moments_(moments),
        relative_(certain_motion_of<Kit::axes, Kit::degree>(setup, row_a, row_b)),
        asked_(asked_of(moments)),
        sizes_(Kit::template sizes_of<Bounded>(setup, row_a, row_b)),
        within_(setup, row_a, row_b, a, b, relative_, steps),
        tests_(a, b, relative_, asked_, sizes_, times_wanted, space),
        walk_(a, b, relative_, {asked_.begin.low, asked_.end.high}, sizes_, steps) {}

  PairStays(const PairStays&) = delete;
  PairStays& operator=(const PairStays&) = delete;

  /// When contact may begin that begins later than `after`; infinite if none may.
  double first_possible(double after) {
    double first = Stay::inf;
    walk_.visit(
        Order::earlier_first,
        [&](const Period<double>& near) { return near.end > after && near.begin < first; },
        [&](std::size_t a, std::size_t b, const Period<double>& near) {
          for (const PieceStay& stay : tests_.of(a, b)) {
            const auto [begin, end] = possible(stay, near);
            if (begin <= end && begin > after) first = std::min(first, begin);
          }
        });
    return first;
  }
  /// Until when contact may last that may be at `from`.
  double possible_until(double from) {
    double until = from, passed_by = from;
    while (passed_by <= until) {
      passed_by = Stay::inf;
      const auto begins_by_then = [&](double begin) {
        if (begin > until) passed_by = std::min(passed_by, begin);
        return begin <= until;
      };
      walk_.visit(
          Order::earlier_first,
          [&](const Period<double>& near) { return near.end >= from && begins_by_then(near.begin); },
          [&](std::size_t a, std::size_t b, const Period<double>& near) {
            for (const PieceStay& stay : tests_.of(a, b)) {
              const auto [begin, end] = possible(stay, near);
              if (begin <= end && end >= from && begins_by_then(begin)) until = std::max(until, end);
            }
          });
    }
    return until;
  }
  /// Gives `take` each pair of pieces that may touch within the period, as long as it returns true. It may
  /// shorten the period.
  template <class Take>
  void possible_pairs(const Period<double>& period, Take&& take) {
    bool more = true;
    walk_.visit(
        Order::earlier_first,
        [&](const Period<double>& near) {
          return more && near.begin <= period.end && near.end >= period.begin;
        },
        [&](std::size_t a, std::size_t b, const Period<double>& near) {
          const auto stays = tests_.of(a, b);
          if (std::any_of(stays.begin(), stays.end(), [&](const PieceStay& stay) {
                const auto [begin, end] = possible(stay, near);
                return begin <= end && begin <= period.end && end >= period.begin;
              }))
            more = take(PiecePair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
        });
  }
  /// Whether one lies within the other when what is asked about begins. Where the surfaces touch then it may
  /// say anything.
  bool is_within_at_begin() {
    const Period<double>& near = walk_.near();
    return within_.may_be() && near.begin <= asked_.begin.high && near.begin <= near.end &&
           within_.at_begin();
  }
  bool is_grown() const { return is_of_size(sizes_.radius); }  ///< near counts as touching

  /// Whether one lies within the other. Requires: their surfaces do not touch then.
  bool is_within_at(const Dyadic& moment) { return within_.at(moment); }

 protected:
  /// At no other moment may they touch; never if the end is before the begin.
  static Period<double> possible(const PieceStay& stay, const Period<double>& near) {
    return {std::max(stay.begin.low, near.begin), std::min(stay.end.high, near.end)};
  }

  const Moments& moments_;
  const CertainMotion<Kit::axes> relative_;
  const Stay asked_;
  const typename Kit::template Sizes<Bounded> sizes_;
  typename Kit::Within within_;
  typename Kit::Tests tests_;
  const TreeWalk<Kit::axes, Pieces, typename Kit::NodeTests> walk_;

 private:
  /// Outward and inward.
  static Stay asked_of(const Moments& moments) {
    constexpr double u = unit_roundoff;
    const double begin = moments.dt_begin, end = moments.dt_end;
    const double wider_begin = moments.begin_exact ? 0 : 2 * u * begin;
    const double wider_end = moments.end_exact ? 0 : 2 * u * end;
    return {{begin - wider_begin, begin + wider_begin}, {end - wider_end, end + wider_end}};
  }
};

}  // namespace foresee::contact
