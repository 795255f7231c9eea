// Traits of contact between outlines (pieces/pair_context.h): convex pieces in the plane, prisms over them,
// and the test of two such pieces in doubles with error bounds.
//
//   PieceTests<2, 1> tests(a, b, relative, queried, sizes, true, space);
//   for (const PieceInterval& interval : tests.of(piece_a, piece_b)) best = std::min(best, interval.begin.high);
//
// A test takes all conditions of the Minkowski sum (condition.h). Differences of corners, and of the two
// positions, come first, so that large coordinates cost no precision. Two prisms must also overlap along z,
// which is a condition of each pair of pieces. Cost: some ten nanoseconds per edge.
#pragma once

#include "base/interrupt_steps.h"
#include "contact/certain/certain_motion.h"
#include "contact/certain/chord.h"
#include "contact/contact_factories.h"
#include "contact/exact/pair_polynomials.h"
#include "contact/outline/condition.h"
#include "contact/outline/critical_pieces.h"
#include "contact/outline/object_pieces.h"
#include "contact/outline/outline_filter.h"
#include "contact/pieces/pair_context.h"
#include "contact/pieces/pair_tests.h"
#include "contact/pieces/time_expansion.h"

namespace foresee {

/// The memory of the tests, used for one pair of objects after another.
struct FlatSpace : PieceWorkspace<Condition> {
  std::vector<SumEdge> edges;  ///< of the pair in work
};

template <int D, int Degree>
class PieceTests : public PairTests<PieceTests<D, Degree>, Condition> {
  using Base = PairTests<PieceTests, Condition>;

 public:
  /// `queried`: the queried time, enclosed. Requires: pieces, motion and space outlive this.
  PieceTests(const ObjectPieces& a, const ObjectPieces& b, const CertainMotion<D>& relative,
             const UncertainInterval& queried, const PairSizes<Bounded>& sizes, bool times_wanted,
             FlatSpace& space)
      : Base(queried, times_wanted, space),
        a_(a),
        b_(b),
        relative_(relative),
        sizes_(sizes),
        lost_(relative.underflow + 0x1p-1060),
        edges_(space.edges),
        x_(expanded_at<Degree>(relative, 0)),
        chord_(relative, queried.end.high) {}

 private:
  friend Base;
  using Kind = Condition::Kind;
  using Base::queried_, Base::space_;
  using Base::start_part, Base::end_part, Base::is_decided, Base::keep, Base::share;

  bool test(const PiecePair& pair, double /*by*/) {
    Base::start_test();
    if constexpr (D == 3)
      for (const int side : {-1, 1})
        if (sizes_.has_face(side)) keep({.kind = Kind::height, .sign = side});
    const ConvexPiece a = a_.piece(pair.a), b = b_.piece(pair.b);
    if (is_of_size(sizes_.radius))
      test_grown(a, b);
    else
      test_as_they_are(a, b);
    return true;
  }

  void test_as_they_are(const ConvexPiece& a, const ConvexPiece& b) {
    Condition condition;
    for (ConvexSum sum(a, b); !space_.clipped.empty() && sum.next(condition.edge);) keep(condition);
    end_part();
  }

  /// The first step cuts the time by the polygon whose edges are moved out by R, which contains the grown
  /// sum. All parts of the grown sum follow. Each of them is inside that polygon, so its intervals start
  /// and end with its own conditions: the polygon's edges give no candidates for ends.
  void test_grown(const ConvexPiece& a, const ConvexPiece& b) {
    edges_.clear();
    SumEdge edge;
    for (ConvexSum sum(a, b); !space_.clipped.empty() && sum.next(edge);) {
      edges_.push_back(edge);
      space_.clipped.keep(beside(edge, 1));
    }
    if (space_.clipped.empty()) return;
    share();
    const Interval<double> all = reached(space_.outer);
    for (const SumEdge& one : edges_) keep({.edge = one});
    const Interval<double> inside = surely_held(space_.clipped);
    end_part();
    for (const SumEdge& one : edges_) {
      if (is_decided()) return;
      const Interval<double> near = near_edge(one, all);
      if (!(near.begin <= near.end) || (inside.begin <= near.begin && near.end <= inside.end)) continue;
      start_part();
      for (const int side : {-1, 1}) keep({.kind = Kind::foot, .sign = side, .edge = one});
      for (const int side : {-1, 1}) keep({.kind = Kind::side, .edge = one}, beside(one, side));
      end_part();
      start_part();
      keep({.kind = Kind::corner, .edge = one});
      end_part();
    }
  }

  static Interval<double> reached(const IntervalUnion& intervals) {
    Interval<double> reached{UncertainInterval::inf, -UncertainInterval::inf};
    for (const UncertainInterval& interval : intervals)
      reached = {std::min(reached.begin, interval.begin.low), std::max(reached.end, interval.end.high)};
    return reached;
  }
  /// An interval during which they surely touch.
  static Interval<double> surely_held(const IntervalUnion& intervals) {
    Interval<double> held{UncertainInterval::inf, -UncertainInterval::inf};
    for (const UncertainInterval& interval : intervals)
      if (interval.is_certain()) held = {interval.begin.high, interval.end.low};
    return held;
  }
  /// The part of `when` in which d may be in the box of an edge, grown by R. Most edges are never near.
  Interval<double> near_edge(const SumEdge& edge, const Interval<double>& when) const {
    static constexpr Faces faces[] = {{.axis = 0, .below = {0}, .above = {1}},
                                      {.axis = 1, .below = {2}, .above = {3}}};
    const Bounded radius = largest(sizes_.radius, queried_.end.high);
    Bounded reach[4];
    for (int j = 0; j < 2; ++j) {
      const Bounded begin = start_of<Bounded>(edge, j), end = end_of<Bounded>(edge, j);
      const double error = std::max(begin.error, end.error);
      reach[2 * j] = radius - Bounded{std::min(begin.value, end.value), error};
      reach[2 * j + 1] = radius + Bounded{std::max(begin.value, end.value), error};
    }
    return chord_.between(faces, 2, reach, when);
  }

  void keep(const Condition& condition) {
    if (space_.clipped.empty()) return;
    if (Degree > 1 && condition.kind == Kind::corner)
      return keep(condition, sublevel_by_steps([&](double tau) { return around_corner(condition, tau); },
                                               lost_, queried_));
    // Higher degrees have only sides, which beside() handles, and corners.
    with_polynomial<Degree>(condition, x_, sizes_, [&, last = queried_.end.high](const auto& p) {
      if constexpr (std::tuple_size_v<std::decay_t<decltype(p)>> < 5)
        this->keep(condition, sublevel_intervals(p, lost_, last));
    });
  }

  /// The times at which d is at most R from the line of an edge, on one side: half the degree of both sides.
  SublevelIntervals beside(const SumEdge& edge, int side) const {
    Coefficients<Bounded, Degree> p = beyond<Degree>(edge, x_.data());
    if (side < 0)
      for (Bounded& c : p) c = -c;
    // R may be large, so the underflow of the square counts before the product.
    subtract_multiple<Degree>(p, sizes_.radius, sqrt(with_lost(squared_length<Bounded>(edge), 0x1p-1060)));
    return sublevel_intervals(p, lost_, queried_.end.high);
  }

  Coefficients<Bounded, 4> around_corner(const Condition& condition, double tau) const {
    const auto x = expanded_at<Degree>(relative_, tau);
    const auto p = round_polynomial<Degree>(condition, x.data(), expanded_at(sizes_.radius, tau));
    Coefficients<Bounded, 4> all{};
    std::copy(p.begin(), p.end(), all.begin());
    return all;
  }

  const ObjectPieces &a_, &b_;
  const CertainMotion<D>& relative_;
  const PairSizes<Bounded> sizes_;
  const double lost_;
  std::vector<SumEdge>& edges_;
  const std::array<Coefficients<Bounded, Degree>, D> x_;  ///< the motion after now
  const Chord<D> chord_;
};

template <int D, int Degree>
struct FlatTraits {
  static constexpr int axes = D, degree = Degree;
  static constexpr bool has_solids = false;
  using Tables = OutlineTables;
  using Pieces = ObjectPieces;
  using Condition = foresee::Condition;
  template <class T>
  using Sizes = PairSizes<T>;
  using Space = FlatSpace;
  using Tests = PieceTests<D, Degree>;
  using NodeTests = BoxTests<D, ObjectPieces>;

  /// Never: the pieces of an outline include its inside.
  struct Containment {
    Containment(const Setup&, const double*, const double*, const Pieces&, const Pieces&,
                const CertainMotion<D>&, Steps&) {}
    static constexpr bool may_be() { return false; }
    static constexpr bool at_start() { return false; }
    static constexpr bool at(const Dyadic&) { return false; }
  };

  /// The exact polynomials of some pairs of pieces.
  class Polynomials {
   public:
    Polynomials(const Setup& setup, const double* row_a, const double* row_b, const Pieces& a,
                const Pieces& b, std::span<const PiecePair> pairs, bool grown)
        : critical_(critical_pieces(setup, a, b, pairs, grown)), all_(critical_.set, setup, row_a, row_b) {}

    PiecePolynomials& all() { return all_; }
    std::span<const std::uint32_t> ends() const { return critical_.ends; }

   private:
    const CriticalPieces critical_;
    PairPolynomials all_;
  };

  template <class T>
  static PairSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b) {
    return foresee::sizes_of<T>(setup, row_a, row_b);
  }
  /// For prisms it decides only that their outlines are apart.
  static FilterAnswer filter_answer(const PairContext<FlatTraits>& context, bool times_wanted);
  /// Whether a point that leaves a piece there enters its neighbour. Not around a corner: there the part that
  /// grows by R ends beside the cut that starts at the corner, not beyond it.
  static bool is_cut(const Condition& condition) {
    return condition.kind != Condition::Kind::corner && condition.edge.inner;
  }
  /// Reads the pieces of a pair of rows.
  static void take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair);
};

}  // namespace foresee
