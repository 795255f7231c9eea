// How do two objects move past each other that are unions of pieces, and when could they touch at most? What
// all stages of a pair begin with.
//
//   const PairContext<FlatTraits<2, 1>> context(setup, row_a, row_b, a, b, lifetime, steps);
//   if (context.walk.near().begin > context.walk.near().end) …              // they never touch
//
// A Kit says what the pieces are. It has `axes` and `degree` of the motion, the types Pieces (of one object,
// under a tree), Condition, Sizes<T>, Space, Tests (pair_tests.h) and NodeTests (tree_walk.h), sizes_of<T>()
// and Within, which tells of solids whether one lies within the other; `has_solids` says that there may be
// some.
#pragma once

#include "contact/certain/advancement.h"
#include "contact/certain/certain_motion.h"
#include "contact/pieces/tree_walk.h"
#include "contact/pieces/uncertain_interval.h"

namespace foresee {

template <class Traits>
struct PairContext {
  using Pieces = typename Traits::Pieces;

  /// The moments must not be none. What is given must outlive this. An interrupt is heeded at each of the
  /// `steps`.
  PairContext(const Setup& setup, const double* row_a, const double* row_b, const Pieces& a, const Pieces& b,
              const PairLifetime& lifetime, Steps& steps)
      : setup(setup),
        row_a(row_a),
        row_b(row_b),
        a(a),
        b(b),
        lifetime(lifetime),
        steps(steps),
        relative(certain_motion_of<Traits::axes, Traits::degree>(setup, row_a, row_b)),
        queried(queried_of(lifetime)),
        sizes(Traits::template sizes_of<Bounded>(setup, row_a, row_b)),
        walk(a, b, relative, {queried.begin.low, queried.end.high}, sizes, steps) {}

  PairContext(const PairContext&) = delete;
  PairContext& operator=(const PairContext&) = delete;

  const Setup& setup;
  const double *const row_a, *const row_b;
  const Pieces &a, &b;
  const PairLifetime& lifetime;
  Steps& steps;
  const CertainMotion<Traits::axes> relative;
  const UncertainInterval queried;  ///< the moments, enclosed
  const typename Traits::template Sizes<Bounded> sizes;
  const TreeWalk<Traits::axes, Pieces, typename Traits::NodeTests> walk;

 private:
  /// Outward and inward.
  static UncertainInterval queried_of(const PairLifetime& lifetime) {
    constexpr double u = unit_roundoff;
    const double begin = lifetime.dt_start, end = lifetime.dt_end;
    const double wider_start = lifetime.start_exact ? 0 : 2 * u * begin;
    const double wider_end = lifetime.end_exact ? 0 : 2 * u * end;
    return {{begin - wider_start, begin + wider_start}, {end - wider_end, end + wider_end}};
  }
};

}  // namespace foresee
