// A pair of moving objects that are unions of pieces: relative motion, sizes, queried time and the walk over
// their trees. All stages of the contact test read it.
//
//   const PairContext<FlatTraits<2, 1>> context(setup, row_a, row_b, a, b, lifetime, steps);
//   if (context.walk.near().begin > context.walk.near().end) …              // they never touch
//
// A traits type says what the pieces are. It has `axes` and `degree` of the motion, and `has_solids`,
// which is true if an object may have an inside. Its types are Pieces (of one object, under a tree),
// PieceConstraint, Sizes<T>, Space (a PieceWorkspace), Tests (pair_tests.h), NodeTests (tree_walk.h) and
// Containment. Containment decides whether one object is inside the other. Its functions are sizes_of<T>()
// and is_cut().
#pragma once

#include "contact/certain/advancement.h"
#include "contact/certain/certain_motion.h"
#include "contact/pieces/tree_walk.h"
#include "contact/pieces/uncertain_interval.h"

namespace foresee {

/// The result of a filter in plain doubles, which finds no intervals.
struct FilterAnswer {
  Verdict touches = Verdict::uncertain;
  bool at_start = false;   ///< they surely touch when the queried time starts
  bool all_along = false;  ///< they surely touch during all of the queried time
};

template <class Traits>
struct PairContext {
  using Pieces = typename Traits::Pieces;

  /// Requires: the lifetime is not empty; all arguments outlive this. Each of the `steps` polls the
  /// interrupt.
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
  const UncertainInterval queried;  ///< the queried time, enclosed
  const typename Traits::template Sizes<Bounded> sizes;
  const TreeWalk<Traits::axes, Pieces, typename Traits::NodeTests> walk;

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
