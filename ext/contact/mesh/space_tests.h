// When do two pieces in space touch, certainly and possibly? All conditions of their sum, grown or not
// (round_parts.h, round_parts.h), in doubles with error bounds.
//
//   SpaceTests<1> tests(a, b, relative, queried, sizes, true, space);
//   for (const PieceInterval& interval : tests.of(triangle_a, triangle_b)) best = std::min(best, interval.begin.high);
//
// Where the sum is flat, as that of a triangle and a point is, d goes through it in a moment: begin and end
// are one root, certain if d is surely within the other planes then. Cost: about a microsecond; some more
// where near counts as touching.
#pragma once

#include "contact/certain/certain_motion.h"
#include "contact/certain/root_bracketing.h"
#include "contact/mesh/round_parts.h"
#include "contact/mesh/space_condition.h"
#include "contact/pieces/motion_expansion.h"
#include "contact/pieces/pair_tests.h"
#include "contact/pieces/uncertain_interval.h"

namespace foresee {

// What do plain doubles tell of two triangles that pass each other? The first question about a pair of them,
// which lets most go, and saves the rest most of what is asked with error bounds.
//
//   const TriangleFilter passing = filter_triangles(a, b, x, radius, queried);
//   if (passing.is_apart() || passing.near.begin > by) return;      // else they may touch by then
//   SpaceHull(a, b).for_each(take, passing.axes);                   // the planes that matter
//
// Whatever direction n is, the two touch only while n d lies between the least and the greatest of n (p - q)
// over their corners. So the roundings of n do no harm, and those of the products are far less than the slack
// that all of it is given. Where d is bent its chord stands for it, and how far it can be beside that
// (chord.h). What lies between both by more than the slack, and the roundings of n, as long as the other axes
// let them touch has no say in when they do. Cost: some hundred nanoseconds.

struct TriangleFilter {
  Interval<double> near;  ///< they touch at no other moments
  unsigned axes;          ///< a bit for each that may say when they touch: numbered as SpaceHull has them

  bool is_apart() const { return !(near.begin <= near.end); }
};

/// `x`: d by powers of the time from now on. Requires: two triangles.
TriangleFilter filter_triangles(const SpacePiece& a, const SpacePiece& b,
                                const std::array<Coefficients<Bounded, 2>, 3>& x, const Bounded& radius,
                                const UncertainInterval& queried);

template <int Degree>
class SpaceTests : public PairTests<SpaceTests<Degree>, SpaceCondition> {
  using Base = PairTests<SpaceTests, SpaceCondition>;

 public:
  /// `queried`: the moments asked about, enclosed. What is given must outlive this.
  SpaceTests(const SpacePieces& a, const SpacePieces& b, const CertainMotion<3>& relative,
             const UncertainInterval& queried, const SpaceSizes<Bounded>& sizes, bool times_wanted,
             PieceWorkspace<SpaceCondition>& space)
      : Base(queried, times_wanted, space),
        a_(a),
        b_(b),
        relative_(relative),
        radius_(sizes.radius),
        lost_(relative.underflow + 0x1p-1060),
        x_(from_now(relative, sizes)) {
    for (std::size_t j = 0; j < 3; ++j) std::copy(x_[j].begin(), x_[j].end(), plain_x_[j].begin());
  }

 private:
  friend Base;
  using Kind = SpaceCondition::Kind;
  using Base::begin_part, Base::end_part, Base::keep;
  using Base::queried_, Base::space_;

  static std::array<Coefficients<Bounded, Degree>, 3> from_now(const CertainMotion<3>& relative,
                                                               const SpaceSizes<Bounded>& sizes) {
    auto x = expanded_at<Degree>(relative, 0);
    for (std::size_t j = 0; j < 3; ++j)
      if (sizes.steady[j]) x[j] = {}, x[j][0] = Bounded{*sizes.steady[j]};
    return x;
  }

  /// Whether it is told, as it is not of what begins later than `by`.
  bool test(const PiecePair& pair, double by) {
    Base::begin_test();
    const SpacePiece a = a_.piece(pair.a), b = b_.piece(pair.b);
    unsigned axes = ~0U;
    if (!a.is_box() && !b.is_box()) {
      const TriangleFilter passing = filter_triangles(a, b, plain_x_, radius_, queried_);
      if (passing.is_apart()) return true;
      if (passing.near.begin > by) return false;
      axes = passing.axes;
    }
    if (radius_.value > 0)
      test_grown(a, b);
    else
      test_as_they_are(a, b, axes);
    return true;
  }

  void test_as_they_are(const SpacePiece& a, const SpacePiece& b, unsigned axes) {
    std::optional<SpacePlanes> flat;
    SpaceHull(a, b).for_each(
        [&](const SpacePlanes& pair) {
          if (pair.is_flat && a_or_b_is_a_mesh())
            flat = pair;  // of a triangle's sum, all such are the plane that it lies in
          else
            keep(pair);
          return !space_.clipped.empty();
        },
        axes);
    if (space_.clipped.empty()) return;
    if (flat)
      end_flat_part(*flat);
    else
      end_part();
  }

  /// The stays within all other planes are known.
  void end_flat_part(const SpacePlanes& flat) {
    space_.outer.start(space_.clipped);
    keep(flat);
    for (const UncertainInterval& interval : space_.clipped) {
      const bool is_one_root = interval.begin.low == interval.end.low &&
                               interval.begin.high == interval.end.high &&
                               interval.begin.low > -UncertainInterval::inf;
      const bool is_within =
          std::any_of(space_.outer.begin(), space_.outer.end(), [&](const UncertainInterval& within) {
            return within.begin.high <= interval.begin.low && interval.end.high <= within.end.low;
          });
      Base::add(interval, is_one_root && is_within);
    }
  }

  /// First what lies within all planes moved out by R, which is more; then each part of the grown sum. A flat
  /// sum lies in what is near its faces and edges.
  void test_grown(const SpacePiece& a, const SpacePiece& b) {
    bool is_flat = false;
    planes_.clear();
    SpaceHull(a, b).for_each([&](const SpacePlanes& pair) {
      is_flat |= pair.is_flat;
      planes_.push_back(pair);
      const Bounded more = radius_ * sqrt(with_lost(squared_length(pair.direction), 0x1p-1060));
      for (const SpaceCondition& plane : {pair.before, pair.beyond})
        space_.clipped.keep(times_within(plane, pair.direction, more));
      return !space_.clipped.empty();
    });
    if (space_.clipped.empty()) return;
    Base::share();
    if (!is_flat || !a_or_b_is_a_mesh()) {
      for (const SpacePlanes& pair : planes_) keep(pair);
      end_part();
    }
    RoundParts(a, b).for_each([this](const RoundPart& part) {
      if (Base::is_decided()) return false;
      begin_part();
      for (int i = 0; i < part.count; ++i) keep_plane(part.beside[static_cast<std::size_t>(i)]);
      keep_round(part.round);
      end_part();
      return true;
    });
  }

  bool a_or_b_is_a_mesh() const { return a_.is_mesh() || b_.is_mesh(); }

  void keep(const SpacePlanes& pair) {
    for (const SpaceCondition& plane : {pair.before, pair.beyond})
      keep(plane, times_within(plane, pair.direction, {}));
  }
  void keep_plane(const SpaceCondition& plane) {
    if (space_.clipped.empty()) return;
    keep(plane, times_within(plane, close_direction_of(plane.axis), {}));
  }
  /// Not farther beyond the plane than `more`, in lengths of its direction.
  SublevelIntervals times_within(const SpaceCondition& plane, const Components<Bounded>& direction,
                                 const Bounded& more) const {
    Coefficients<Bounded, Degree> p = beyond_plane<Degree>(plane, direction, x_);
    p[0] = p[0] - more;
    // Along the plane, in it: what has no error is 0.
    if (std::all_of(p.begin(), p.end(), [](const Bounded& c) { return c.value == 0 && c.error == 0; }))
      return SublevelIntervals::one(UncertainInterval::always());
    return times_inside(p, lost_, queried_.end.high);
  }

  void keep_round(const SpaceCondition& round) {
    if (space_.clipped.empty()) return;
    if (round.kind == Kind::slab) return keep_slab(round);
    if constexpr (Degree > 1)
      keep(round, sublevel_by_leaps([&](double tau) { return polynomial_at(round, tau); }, lost_, queried_));
    else
      keep(round, times_inside(round_polynomial<Degree>(round, x_, radius_), lost_, queried_.end.high));
  }
  /// As two planes: fewer powers than their square has.
  void keep_slab(const SpaceCondition& slab) {
    const Components<Bounded> direction = close_direction_of(slab.axis);
    const Bounded more = radius_ * sqrt(with_lost(squared_length(direction), 0x1p-1060));
    for (const int side : {-1, 1}) {
      SpaceCondition plane = slab;
      plane.sign = side;
      keep(slab, times_within(plane, direction, more));
    }
  }

  Coefficients<Bounded, 4> polynomial_at(const SpaceCondition& round, double tau) const {
    return round_polynomial<2>(round, expanded_at<2>(relative_, tau), radius_);
  }

  const SpacePieces &a_, &b_;
  const CertainMotion<3>& relative_;
  const Bounded radius_;
  const double lost_;
  std::vector<SpacePlanes> planes_;                       ///< of the pair at hand
  const std::array<Coefficients<Bounded, Degree>, 3> x_;  ///< the motion from now on
  std::array<Coefficients<Bounded, 2>, 3> plain_x_{};     ///< the same, whatever the degree
};

}  // namespace foresee
