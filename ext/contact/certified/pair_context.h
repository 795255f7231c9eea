// A pair of moving objects that are unions of pieces: relative motion, sizes, queried time and the walk over
// their trees. All stages of the contact test read it.
//
//   const PairContext<FlatTraits<2, 1>> context({setup, row_a, row_b, a, b, lifetime, any_time, true, steps});
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
#include "contact/setup.h"
#include "numbers/crossed_root.h"
#include "numbers/dyadic.h"

namespace foresee {

constexpr Interval<double> any_time{0, unbounded};

/// The result of a filter in plain doubles, which finds no intervals.
struct FilterAnswer {
  Verdict touches = Verdict::uncertain;
  bool at_start = false;   ///< they surely touch when the queried time starts
  bool all_along = false;  ///< they surely touch during all of the queried time
};

/// What a stage has found of the first contact of a pair.
struct FirstContact {
  Verdict touches = Verdict::no;
  Instant begin = unknown_instant(), end = unknown_instant();  ///< if they touch, `begin` is known
};

/// Which certain contact a filter of many pairs reports.
enum class CertainContact : std::uint8_t { at_any_time, at_start };

/// The filter of many pairs that rejects none.
struct EachPair {
  template <class Tables>
  EachPair(const Setup& /*setup*/, const Tables& /*tables*/) {}

  /// Calls `visit` with each pair that is not certainly apart, in order. Its other arguments are the time
  /// outside of which they do not touch, and whether they certainly touch: at any time, or when the queried time
  /// starts.
  template <class Visit>
  void for_each(std::span<const Pair> pairs, CertainContact /*certain*/, Visit&& visit) const {
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

/// A pair of objects, and what is queried of it. All that it refers to must outlive its use.
template <class PiecesOfObject>
struct PairInput {
  const Setup& setup;
  const double *row_a, *row_b;
  const PiecesOfObject &a, &b;
  const PairLifetime& lifetime;  ///< not empty
  Interval<double> near;         ///< they touch at no other times
  bool times_wanted;             ///< the query wants more than whether they touch
  Steps& steps;                  ///< each polls the interrupt
};

template <class Traits>
struct PairContext : PairInput<typename Traits::Pieces> {
  using Input = PairInput<typename Traits::Pieces>;

  /// Inline, so that the input is not copied in memory.
  [[gnu::always_inline]] explicit PairContext(const Input& input)
      : Input(input),
        relative(certain_motion_of<Traits::axes, Traits::degree>(input.setup, input.row_a, input.row_b)),
        queried(queried_of(input.lifetime)),
        sizes(Traits::template sizes_of<Bounded>(input.setup, input.row_a, input.row_b, input.a)),
        walk(input.a, input.b, relative,
             {std::max(queried.begin.low, input.near.begin), std::min(queried.end.high, input.near.end)},
             sizes, input.steps) {}

  PairContext(const PairContext&) = delete;
  PairContext& operator=(const PairContext&) = delete;

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
