#include <algorithm>

#include "contact/certified/certain_motion.h"
#include "contact/certified/exact_union.h"
#include "contact/certified/pair_context.h"
#include "contact/certified/pair_tests.h"
#include "contact/certified/union_contact.h"
#include "contact/certified/union_pair.h"
#include "contact/contact_factories.h"
#include "contact/mesh/containment.h"
#include "contact/mesh/disc_tests.h"
#include "contact/mesh/space_constraint.h"
#include "contact/mesh/space_sum.h"
#include "contact/mesh/triangle_filter.h"

namespace foresee {
namespace {

/// Test of two convex pieces in space: the uncertain intervals in which they touch, from all constraints of
/// their Minkowski sum (space_sum.h), in doubles with error bounds. A flat sum, such as that of a triangle and a
/// point, is in contact for one instant: start and end are one root. The contact is certain if d is surely within
/// the other planes then. Cost: about a microsecond; more if the contact distance is not 0.
template <int Degree>
class SpaceTests : public PairTests<SpaceTests<Degree>, SpaceConstraint> {
  using Base = PairTests<SpaceTests, SpaceConstraint>;

 public:
  /// As PairTests.
  template <class Context>
  SpaceTests(const Context& context, PieceWorkspace<SpaceConstraint>& space)
      : Base(context, space),
        a_(context.a),
        b_(context.b),
        relative_(context.relative),
        radius_(context.sizes.radius.value),
        lost_(relative_.underflow + 0x1p-1060),
        x_(from_now(relative_, context.sizes)) {
    for (std::size_t j = 0; j < 3; ++j) std::copy(x_[j].begin(), x_[j].end(), plain_x_[j].begin());
  }

 private:
  friend Base;
  using Kind = ConstraintKind;
  using Base::queried_, Base::space_;
  using Base::start_part, Base::end_part, Base::keep;

  static std::array<Coefficients<Bounded, Degree>, 3> from_now(const CertainMotion<3>& relative,
                                                               const SpaceSizes<Bounded>& sizes) {
    auto x = expanded_at<Degree>(relative, 0);
    for (std::size_t j = 0; j < 3; ++j)
      if (sizes.steady[j]) x[j] = {}, x[j][0] = Bounded{*sizes.steady[j]};
    return x;
  }

  /// False, without a result, if contact starts later than `by`.
  bool test(const PiecePair& pair, double by) {
    Base::start_test();
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
            flat = pair;  // all of a triangle's flat sum lies in this plane
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

  /// Ends a part with one flat plane, after all other planes.
  void end_flat_part(const SpacePlanes& flat) {
    space_.outer.start(space_.clipped);
    keep(flat);
    for (const UncertainInterval& interval : space_.clipped) {
      const bool is_one_root = interval.begin == interval.end && interval.begin.low > -unbounded;
      const bool is_within =
          std::any_of(space_.outer.begin(), space_.outer.end(), [&](const UncertainInterval& within) {
            return within.begin.high <= interval.begin.low && interval.end.high <= within.end.low;
          });
      Base::add(interval, is_one_root && is_within);
    }
  }

  /// The first step cuts the time by all planes moved out by R, which contain the grown sum. The parts of the
  /// grown sum follow. A flat sum needs no part of its own: those of its faces and edges contain it.
  void test_grown(const SpacePiece& a, const SpacePiece& b) {
    bool is_flat = false;
    planes_.clear();
    SpaceHull(a, b).for_each([&](const SpacePlanes& pair) {
      is_flat |= pair.is_flat;
      planes_.push_back(pair);
      const Bounded more = radius_ * sqrt(with_lost(squared_length(pair.direction), 0x1p-1060));
      for (const SpaceConstraint& plane : {pair.before, pair.beyond})
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
      start_part();
      for (int i = 0; i < part.count; ++i) keep_plane(part.beside[static_cast<std::size_t>(i)]);
      keep_round(part.round);
      end_part();
      return true;
    });
  }

  bool a_or_b_is_a_mesh() const { return a_.is_mesh() || b_.is_mesh(); }

  void keep(const SpacePlanes& pair) {
    for (const SpaceConstraint& plane : {pair.before, pair.beyond})
      keep(plane, times_within(plane, pair.direction, {}));
  }
  void keep_plane(const SpaceConstraint& plane) {
    if (space_.clipped.empty()) return;
    keep(plane, times_within(plane, close_direction_of(plane.feature.axis), {}));
  }
  /// The times at which d is beyond the plane by at most `more`, a distance times the length of `direction`.
  SublevelIntervals times_within(const SpaceConstraint& plane, const Components<Bounded>& direction,
                                 const Bounded& more) const {
    Coefficients<Bounded, Degree> p = beyond<Degree>(plane, direction, x_);
    p[0] = p[0] - more;
    // d moves in the plane: all coefficients are exactly 0.
    if (std::all_of(p.begin(), p.end(), [](const Bounded& c) { return c.value == 0 && c.error == 0; }))
      return SublevelIntervals::one(UncertainInterval::always());
    return sublevel_intervals(p, lost_, queried_.end.high);
  }

  void keep_round(const SpaceConstraint& round) {
    if (space_.clipped.empty()) return;
    if (round.kind == Kind::slab) return keep_slab(round);
    if constexpr (Degree > 1)
      keep(round, sublevel_by_steps([&](double tau) { return polynomial_at(round, tau); }, lost_, queried_));
    else
      keep(round,
           sublevel_intervals(round_polynomial<Degree>(round, x_, {radius_}), lost_, queried_.end.high));
  }
  /// Keeps a slab as two planes, whose polynomials have half its degree.
  void keep_slab(const SpaceConstraint& slab) {
    const Components<Bounded> direction = close_direction_of(slab.feature.axis);
    const Bounded more = radius_ * sqrt(with_lost(squared_length(direction), 0x1p-1060));
    for (const int side : {-1, 1}) {
      const SpaceConstraint plane{.sign = side, .feature = slab.feature};
      keep(slab, times_within(plane, direction, more));
    }
  }

  Coefficients<Bounded, 4> polynomial_at(const SpaceConstraint& round, double tau) const {
    return round_polynomial<2>(round, expanded_at<2>(relative_, tau), {radius_});
  }

  const SpacePieces &a_, &b_;
  const CertainMotion<3>& relative_;
  const Bounded radius_;
  const double lost_;
  std::vector<SpacePlanes> planes_;                       ///< of the pair in work
  const std::array<Coefficients<Bounded, Degree>, 3> x_;  ///< the motion after now
  std::array<Coefficients<Bounded, 2>, 3> plain_x_{};     ///< the same as polynomials of degree 2
};

/// Traits of contact between meshes (certified/pair_context.h): triangles, boxes and points in space.
template <int Degree>
struct SpaceTraits {
  static constexpr int axes = 3, degree = Degree;
  static constexpr bool has_solids = true, has_cuts = false, counts_work = true;
  using Tables = MeshTables;
  using Filter = EachPair;
  using Pieces = SpacePieces;
  using PieceConstraint = SpaceConstraint;
  template <class T>
  using Sizes = SpaceSizes<T>;
  using Space = PieceWorkspace<SpaceConstraint>;
  using Tests = SpaceTests<Degree>;
  using Walk = TreeWalk<3, SpacePieces, DiscTests>;
  using Containment = foresee::Containment;
  using Context = PairContext<SpaceTraits>;
  using Staged = UnionPair<SpaceTraits>;
  using Exact = ExactUnion<SpaceTraits>;

  template <class T>
  static SpaceSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b, const Pieces&) {
    SpaceSizes<T> sizes{.radius = {size_as_of_t<T>(setup.rule.radius, row_a, row_b)}};
    if constexpr (std::is_same_v<T, Bounded>) sizes.steady = steady_axes_of(setup, row_a, row_b);
    return sizes;
  }
  static std::vector<SpaceConstraint> shared_constraints(const Setup&) { return {}; }
  /// Adds the parts of the sum of two pieces, for the exact stage.
  static void add_pair(UndecidedPieces<SpaceTraits>& out, const SpacePiece& a, const SpacePiece& b,
                       bool grown, const std::vector<int>&) {
    Conditions core;
    SpaceHull(a, b).for_each([&](const SpacePlanes& planes) {
      core.all.push_back(out.add(planes.before));
      core.all.push_back(out.add(planes.beyond));
      return true;
    });
    out.add_piece(core);
    if (!grown) return;
    RoundParts(a, b).for_each([&out](const RoundPart& part) {
      Conditions conditions;
      for (int i = 0; i < part.count; ++i)
        conditions.all.push_back(out.add(part.beside[static_cast<std::size_t>(i)]));
      conditions.ball = out.add(part.round);
      conditions.all.push_back(conditions.ball);
      out.add_piece(conditions);
      return true;
    });
  }
  /// Reads the pieces of a pair of rows.
  static void load(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair) {
    take_pair(a, b, setup, tables, pair);
  }
};

}  // namespace

std::unique_ptr<Contact> make_mesh_contact(const Setup& setup, const MeshTables& meshes, int degree) {
  if (degree < 2) return std::make_unique<UnionContact<SpaceTraits<1>>>(setup, meshes);
  return std::make_unique<UnionContact<SpaceTraits<2>>>(setup, meshes);
}

}  // namespace foresee
