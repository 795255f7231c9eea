// Traits of contact between outlines (certified/pair_context.h): convex pieces in the plane, prisms over them,
// and the test of two such pieces in doubles with error bounds.
//
//   PieceTests<2, 1> tests(context, space);
//   for (const PieceInterval& interval : tests.of(piece_a, piece_b)) best = std::min(best, interval.begin.high);
//
// A test takes all constraints of the Minkowski sum (flat_constraint.h). Differences of corners, and of the two
// positions, come first, so that large coordinates cost no precision. Two prisms must also overlap along z,
// which is a constraint of each pair of pieces. Cost: some ten nanoseconds per edge.
#pragma once

#include "base/interrupt_steps.h"
#include "contact/certified/certain_motion.h"
#include "contact/certified/chord.h"
#include "contact/certified/exact_union.h"
#include "contact/certified/pair_context.h"
#include "contact/certified/pair_tests.h"
#include "contact/certified/union_pair.h"
#include "contact/contact_factories.h"
#include "contact/outline/flat_constraint.h"
#include "contact/outline/object_pieces.h"
#include "contact/outline/outline_filter.h"

namespace foresee {

/// An edge of the sum; and how far d is beyond its line, times the length of its direction.
template <int Degree>
struct EdgeLine {
  SumEdge edge;
  Coefficients<Bounded, Degree> beyond;
  Bounded length;
};

/// The memory of the tests, used for one pair of objects after another.
template <int Degree>
struct FlatSpace : PieceWorkspace<FlatConstraint> {
  std::vector<EdgeLine<Degree>> edges;  ///< of the pair in work, if R is more than 0
};

template <int D, int Degree>
class PieceTests : public PairTests<PieceTests<D, Degree>, FlatConstraint> {
  using Base = PairTests<PieceTests, FlatConstraint>;

 public:
  /// As PairTests.
  template <class Context>
  PieceTests(const Context& context, FlatSpace<Degree>& space)
      : Base(context, space),
        a_(context.a),
        b_(context.b),
        relative_(context.relative),
        sizes_(context.sizes),
        lost_(relative_.underflow + 0x1p-1060),
        edges_(space.edges),
        x_(expanded_at<Degree>(relative_, 0)),
        chord_(relative_, queried_.end.high) {}

 private:
  friend Base;
  using Kind = ConstraintKind;
  using Direction = FlatFeature::Direction;
  using Base::queried_, Base::space_;
  using Base::start_part, Base::end_part, Base::is_decided, Base::keep, Base::share;

  bool test(const PiecePair& pair, double /*by*/) {
    Base::start_test();
    if constexpr (D == 3)
      for (const int side : {-1, 1})
        if (sizes_.has_face(side)) keep({.sign = side, .feature = {.towards = Direction::up}});
    const ConvexPiece a = a_.piece(pair.a), b = b_.piece(pair.b);
    if (is_of_size(sizes_.radius))
      test_grown(a, b);
    else
      test_as_they_are(a, b);
    return true;
  }

  void test_as_they_are(const ConvexPiece& a, const ConvexPiece& b) {
    FlatConstraint inside;
    for (ConvexSum sum(a, b); !space_.clipped.empty() && sum.next(inside.feature.edge);) keep(inside);
    end_part();
  }

  /// The first step cuts the time by the polygon whose edges are moved out by R, which contains the grown
  /// sum. All parts of the grown sum follow. Each of them is inside that polygon, so its intervals start
  /// and end with its own conditions: the polygon's edges give no candidates for ends.
  void test_grown(const ConvexPiece& a, const ConvexPiece& b) {
    edges_.clear();
    SumEdge edge;
    for (ConvexSum sum(a, b); !space_.clipped.empty() && sum.next(edge);) {
      edges_.push_back(line_of(edge));
      space_.clipped.keep(beside(edges_.back(), 1));
    }
    if (space_.clipped.empty()) return;
    share();
    const Interval<double> all = reached(space_.outer);
    for (const EdgeLine<Degree>& line : edges_)
      keep({.feature = {.edge = line.edge}}, sublevel_intervals(line.beyond, lost_, queried_.end.high));
    const Interval<double> inside = surely_held(space_.clipped);
    end_part();
    for (const EdgeLine<Degree>& line : edges_) {
      if (is_decided()) return;
      const SumEdge& one = line.edge;
      const Interval<double> near = near_edge(one, all);
      if (!(near.begin <= near.end) || (inside.begin <= near.begin && near.end <= inside.end)) continue;
      start_part();
      for (const int side : {-1, 1}) keep({.sign = side, .feature = {Direction::along, one}});
      for (const int side : {-1, 1}) keep({.kind = Kind::slab, .feature = {.edge = one}}, beside(line, side));
      end_part();
      start_part();
      keep({.kind = Kind::ball, .feature = {.edge = one}});
      end_part();
    }
  }

  static Interval<double> reached(const IntervalUnion& intervals) {
    Interval<double> reached{unbounded, -unbounded};
    for (const UncertainInterval& interval : intervals)
      reached = {std::min(reached.begin, interval.begin.low), std::max(reached.end, interval.end.high)};
    return reached;
  }
  /// An interval during which they surely touch.
  static Interval<double> surely_held(const IntervalUnion& intervals) {
    Interval<double> held{unbounded, -unbounded};
    for (const UncertainInterval& interval : intervals)
      if (interval.is_certain()) held = {interval.begin.high, interval.end.low};
    return held;
  }
  /// The part of `when` in which d may be in the box of an edge, grown by R. Most edges are never near.
  Interval<double> near_edge(const SumEdge& edge, const Interval<double>& when) const {
    static constexpr Faces faces[] = {{.axis = 0, .below = {0}, .above = {1}},
                                      {.axis = 1, .below = {2}, .above = {3}}};
    const Bounded radius = largest(sizes_.radius, queried_.end.high);
    const auto starts = gap_between<Bounded>(*edge.p, *edge.q);
    const auto ends = gap_between<Bounded>(*edge.p_end, *edge.q_end);
    Bounded reach[4];
    for (std::size_t j = 0; j < 2; ++j) {
      const Bounded &begin = starts[j], &end = ends[j];
      const double error = std::max(begin.error, end.error);
      reach[2 * j] = radius - Bounded{std::min(begin.value, end.value), error};
      reach[2 * j + 1] = radius + Bounded{std::max(begin.value, end.value), error};
    }
    return chord_.between(faces, 2, reach, when);
  }

  void keep(const FlatConstraint& constraint) {
    if (space_.clipped.empty()) return;
    if (Degree > 1 && constraint.kind == Kind::ball)
      return keep(constraint, sublevel_by_steps([&](double tau) { return around_corner(constraint, tau); },
                                                lost_, queried_));
    // Higher degrees have only slabs, which beside() handles, and balls.
    with_polynomial<Degree>(constraint, x_, sizes_, [&, last = queried_.end.high](const auto& p) {
      if constexpr (std::tuple_size_v<std::decay_t<decltype(p)>> < 5)
        this->keep(constraint, sublevel_intervals(p, lost_, last));
    });
  }

  EdgeLine<Degree> line_of(const SumEdge& edge) const {
    const FlatConstraint inside{.feature = {.edge = edge}};
    const std::array<Bounded, 2> direction = inside.feature.direction<Bounded>();
    // R may be large, so the underflow of the square counts before the product.
    return {edge, beyond<Degree>(inside, direction, x_),
            sqrt(with_lost(squared_length(direction), 0x1p-1060))};
  }

  /// The times at which d is at most R from the line of an edge, on one side: half the degree of both sides.
  SublevelIntervals beside(const EdgeLine<Degree>& line, int side) const {
    Coefficients<Bounded, Degree> p = line.beyond;
    if (side < 0)
      for (Bounded& c : p) c = -c;
    subtract_multiple<Degree>(p, sizes_.radius, line.length);
    return sublevel_intervals(p, lost_, queried_.end.high);
  }

  Coefficients<Bounded, 4> around_corner(const FlatConstraint& corner, double tau) const {
    const auto x = expanded_at<Degree>(relative_, tau);
    const auto p = round_polynomial<Degree>(corner, x, expanded_at(sizes_.radius, tau));
    Coefficients<Bounded, 4> all{};
    std::copy(p.begin(), p.end(), all.begin());
    return all;
  }

  const ObjectPieces &a_, &b_;
  const CertainMotion<D>& relative_;
  const PairSizes<Bounded> sizes_;
  const double lost_;
  std::vector<EdgeLine<Degree>>& edges_;
  const std::array<Coefficients<Bounded, Degree>, D> x_;  ///< the motion after now
  const Chord<D> chord_;
};

template <int D, int Degree>
struct FlatTraits {
  static constexpr int axes = D, degree = Degree;
  static constexpr bool has_solids = false, has_cuts = true, counts_work = true;
  using Tables = OutlineTables;
  using Filter = EachPair;
  using Pieces = ObjectPieces;
  using PieceConstraint = FlatConstraint;
  template <class T>
  using Sizes = PairSizes<T>;
  using Space = FlatSpace<Degree>;
  using Tests = PieceTests<D, Degree>;
  using Walk = TreeWalk<D, ObjectPieces, BoxTests<D, ObjectPieces>>;
  using Containment = NoContainment;
  using Context = PairContext<FlatTraits>;
  using Staged = UnionPair<FlatTraits>;
  using Exact = ExactUnion<FlatTraits>;

  /// The faces across z of prisms.
  static std::vector<FlatConstraint> shared_constraints(const Setup& setup) {
    std::vector<FlatConstraint> faces;
    if (D < 3) return faces;
    for (const int side : {-1, 1})
      if (!setup.window || (side < 0 ? setup.window->has_lower(2) : setup.window->has_upper(2)))
        faces.push_back({.sign = side, .feature = {.towards = FlatFeature::Direction::up}});
    return faces;
  }
  /// Adds the parts of the sum of two pieces, for the exact stage.
  static void add_pair(UndecidedPieces<FlatTraits>& out, const ConvexPiece& a, const ConvexPiece& b,
                       bool grown, const std::vector<int>& shared) {
    Conditions inside{.all = shared};
    const auto add_round = [&](Conditions& part, ConstraintKind kind, const SumEdge& edge) {
      part.ball = out.add({.kind = kind, .feature = {.edge = edge}});
      part.all.push_back(part.ball);
      out.add_piece(part);
    };
    SumEdge edge;
    for (ConvexSum sum(a, b); sum.next(edge);) {
      inside.all.push_back(out.add({.feature = {.edge = edge}}));
      if (!grown) continue;
      Conditions beside{.all = shared}, around{.all = shared};
      for (const int sign : {-1, 1})
        beside.all.push_back(out.add({.sign = sign, .feature = {FlatFeature::Direction::along, edge}}));
      add_round(beside, ConstraintKind::slab, edge);
      add_round(around, ConstraintKind::ball, edge);
    }
    out.add_piece(inside);
  }

  template <class T>
  static PairSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b, const Pieces&) {
    return foresee::sizes_of<T>(setup, row_a, row_b);
  }
  /// For prisms it decides only that their outlines are apart.
  static FilterAnswer filter_answer(const PairContext<FlatTraits>& context);
  /// Whether a point that leaves a piece there enters its neighbour. Not around a corner: there the part that
  /// grows by R ends beside the cut that starts at the corner, not beyond it.
  static bool is_cut(const FlatConstraint& constraint) {
    return constraint.kind != ConstraintKind::ball && constraint.feature.edge.inner;
  }
  /// Reads the pieces of a pair of rows.
  static void load(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair) {
    take_pair(a, b, setup, tables, pair);
    if (a.is_point() && b.is_point()) a.take_box(0, 0);  // a sum needs edges
  }
};

}  // namespace foresee
