// A pair of moving objects that are unions of pieces: relative motion, sizes, queried time and the walk over
// their trees. All stages of the contact test read it.
//
//   const PairContext<FlatTraits<2, 1>> context(setup, row_a, row_b, a, b, lifetime, any_time, steps);
//   if (context.walk.near().begin > context.walk.near().end) …              // they never touch
//
// A traits type says what the pieces are. It has `axes` and `degree` of the motion. If `has_solids`, an object
// may have an inside; if `has_cuts`, pieces may share an edge (is_cut()). Its types are Pieces (of one object),
// Walk over them (tree_walk.h), PieceConstraint, Sizes<T>, Space (a PieceWorkspace), Tests (pair_tests.h) and
// Containment. Containment decides whether one object is inside the other, and sizes_of<T>() computes the sizes.
// union_contact.h names what all traits have, those of sets too.
#pragma once

#include "contact/certified/certain_motion.h"
#include "contact/certified/tree_walk.h"
#include "contact/certified/uncertain_interval.h"
#include "numbers/dyadic.h"

namespace foresee {

enum class Verdict : std::uint8_t { no, yes, uncertain };

constexpr Interval<double> any_time{0, unbounded};

/// The result of a filter in plain doubles, which finds no intervals.
struct FilterAnswer {
  Verdict touches = Verdict::uncertain;
  bool at_start = false;   ///< they surely touch when the queried time starts
  bool all_along = false;  ///< they surely touch during all of the queried time
};

/// The filter of many pairs that rejects none.
struct EachPair {
  template <class Tables>
  EachPair(const Setup& /*setup*/, const Tables& /*tables*/) {}

  /// Calls `visit` with each pair that is not certainly apart, in order. Its other arguments are the time
  /// outside of which they do not touch, and whether they certainly touch. That is about the start of the queried
  /// time if times are wanted, else about any time.
  template <class Visit>
  void for_each(std::span<const Pair> pairs, bool /*times_wanted*/, Visit&& visit) const {
    for (const Pair& pair : pairs) visit(pair, any_time, false);
  }
};

/// For pieces that include the inside of their object.
struct NoContainment {
  template <class Context>
  explicit NoContainment(const Context& /*context*/) {}
  static constexpr bool may_be() { return false; }
  static constexpr bool at_start() { return false; }
  static constexpr bool at(const Dyadic& /*time*/) { return false; }
};

template <class Traits>
struct PairContext {
  using Pieces = typename Traits::Pieces;

  /// `near`: they touch at no other times. Requires: the lifetime is not empty; all arguments outlive this.
  /// Each of the `steps` polls the interrupt.
  PairContext(const Setup& setup, const double* row_a, const double* row_b, const Pieces& a, const Pieces& b,
              const PairLifetime& lifetime, const Interval<double>& near, Steps& steps)
      : setup(setup),
        row_a(row_a),
        row_b(row_b),
        a(a),
        b(b),
        lifetime(lifetime),
        steps(steps),
        relative(certain_motion_of<Traits::axes, Traits::degree>(setup, row_a, row_b)),
        queried(queried_of(lifetime)),
        sizes(Traits::template sizes_of<Bounded>(setup, row_a, row_b, a)),
        walk(a, b, relative, {std::max(queried.begin.low, near.begin), std::min(queried.end.high, near.end)},
             sizes, steps) {}

  PairContext(const PairContext&) = delete;
  PairContext& operator=(const PairContext&) = delete;

  const Setup& setup;
  const double *const row_a, *const row_b;
  const Pieces &a, &b;
  const PairLifetime& lifetime;
  Steps& steps;
  const CertainMotion<Traits::axes> relative;
  const UncertainInterval queried;  ///< the queried time, enclosed
  const typename Traits::template Sizes<Bounded> sizes;
  const typename Traits::Walk walk;

 private:
  /// Both ends rounded outward and inward.
  static UncertainInterval queried_of(const PairLifetime& lifetime) {
    constexpr double u = unit_roundoff;
    const double begin = lifetime.dt_start, end = lifetime.dt_end;
    const double wider_start = lifetime.start_exact ? 0 : 2 * u * begin;
    const double wider_end = lifetime.end_exact ? 0 : 2 * u * end;
    return {{begin - wider_start, begin + wider_start}, {end - wider_end, end + wider_end}};
  }
};

}  // namespace foresee
