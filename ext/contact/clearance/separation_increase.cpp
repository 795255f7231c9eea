#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contact/clearance/separation.h"
#include "contact/clearance/separation_case.h"

namespace foresee {
namespace {

/// A ball, or an upright disc: half extents are 0 on the round axes. Pieces too are tested on all their axes
/// together.
template <int D>
bool is_round_alone(const PairExtents<D>& extents) {
  if (extents.sum) return true;
  for (int axis = 0; axis < extents.round_axes; ++axis)
    if (extents.half[axis] != 0) return false;
  return true;
}

/// Twice the error along n that a proof adds to each of these vectors, less a little.
template <int D>
double twice_error_along(const VectorSet<D>& set, const Vec<D>& n) {
  const double length = set.is_arc ? std::sqrt(n[0] * n[0] + n[D > 1] * n[D > 1]) * set.radius : 0;
  return 1.9 * ((n.abs() * set.pad).sum() + 0x1p-47 * length);
}

/// Whether the distance of the centres never decreases, on paths that are not bent. Its slope increases with
/// time, so its sign at the start decides.
template <int D>
ClearanceVerdict certify_straight_separation_increases(const Encounter<D>& encounter,
                                                       const TrajectoryFamily<D>& family) {
  const auto& own = family.all.velocity;
  const double along = (encounter.x * encounter.v).sum(), support = own.support(encounter.x);
  const Vec<D> v = family.upper[1].abs().max(family.lower[1].abs()) + encounter.v.abs();
  // A 0 has no error: side by side at the same velocity the distance does not decrease.
  double error = 0;
  for (int axis = 0; axis < D; ++axis)
    error += encounter.ex[axis] * (v[axis] + encounter.ev[axis]) +
             std::abs(encounter.x[axis]) * encounter.ev[axis] +
             8 * unit_roundoff * std::abs(encounter.x[axis]) * v[axis];
  error *= 1 + 0x1p-48;
  const double min_slope = along - support;
  if (min_slope - error >= 0) return ClearanceVerdict::clear;
  // With twice the error of each velocity, no single change has a proof.
  const double max_slope = along + own.support(-encounter.x);
  return max_slope <= error + twice_error_along<D>(own, encounter.x) ? ClearanceVerdict::blocked
                                                                     : ClearanceVerdict::undecided;
}

/// Whether the gap along some axes never decreases, for a set that grows by `rate`. `x`: the position of the
/// other object on these axes, 0 on the rest.
template <int D>
ClearanceVerdict certify_gap_increases(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                       const Vec<D>& x, double rate) {
  const auto& own = family.all.velocity;
  const double opening = std::sqrt((x * x).sum()) * rate, along = (x * encounter.v).sum() - opening;
  const Vec<D> v = family.upper[1].abs().max(family.lower[1].abs()) + encounter.v.abs() + encounter.ev;
  const double error = ((encounter.ex * (v + rate) + x.abs() * encounter.ev).sum() +
                        16 * unit_roundoff * ((x.abs() * v).sum() + opening)) *
                       (1 + 0x1p-48);
  if (along - own.support(x) - error >= 0) return ClearanceVerdict::clear;
  return along + own.support(-x) <= error + twice_error_along<D>(own, x) ? ClearanceVerdict::blocked
                                                                         : ClearanceVerdict::undecided;
}

/// certify_gap_increases() on all axes, on paths that are not bent. A growing disc or ball is left permanently if the
/// distance of the centres grows at least as fast. For other sets each axis is tested separately, as a
/// growing interval; that is sufficient. Sets that are smaller at first do not touch later either.
template <int D>
ClearanceVerdict certify_growing_separation_increases(const Encounter<D>& encounter,
                                                      const TrajectoryFamily<D>& family) {
  const PairExtents<D>& growth = encounter.extents.growth;
  const int together = is_round_alone(encounter.extents) ? encounter.extents.round_axes : 0;
  std::array<ClearanceVerdict, D + 1> parts;
  std::size_t count = 0;
  if (together > 0) {
    Vec<D> round = Vec<D>::zero();
    for (int axis = 0; axis < together; ++axis) round[axis] = encounter.x[axis];
    parts[count++] = certify_gap_increases<D>(encounter, family, round, growth.radius);
  }
  for (int axis = together; axis < D; ++axis) {
    Vec<D> one = Vec<D>::zero();
    one[axis] = encounter.x[axis];
    const double rate = growth.half[axis] + (axis < encounter.extents.round_axes ? growth.radius : 0);
    parts[count++] = certify_gap_increases<D>(encounter, family, one, rate);
  }
  const auto any = [&](ClearanceVerdict what) {
    return std::find(parts.begin(), parts.begin() + count, what) != parts.begin() + count;
  };
  return any(ClearanceVerdict::blocked)     ? ClearanceVerdict::blocked
         : any(ClearanceVerdict::undecided) ? ClearanceVerdict::undecided
                                            : ClearanceVerdict::clear;
}

}  // namespace

template <int D>
CountedVerdict certify_separation_increases(const Encounter<D>& encounter,
                                            const TrajectoryFamily<D>& family) {
  const SeparationCase<D> separation(encounter, family);
  if (separation.never_together() || separation.end() <= 0) return {ClearanceVerdict::clear};
  if (!separation.is_finite()) return {ClearanceVerdict::blocked};
  // A growing set may catch up with an object that slows down, and pieces may be on any side of the position.
  if (separation.bends() && (encounter.extents.grows || encounter.extents.sum))
    return {ClearanceVerdict::blocked};
  if (encounter.extents.grows) return {certify_growing_separation_increases<D>(encounter, family)};
  // On bent paths the slope at the start decides which approach at once.
  const ClearanceVerdict at_once = certify_straight_separation_increases<D>(encounter, family);
  if (!separation.bends() || at_once == ClearanceVerdict::blocked) return {at_once};
  return certify_bent_separation<D>(encounter, family);
}

namespace {

/// Rotations by less are not bisected further if all of the range seems to touch.
constexpr double min_chord = 0x1p-17;

/// The direction of all changes across a line that may separate a position from a piece.
enum class Trend : std::uint8_t { departing, approaching, mixed };

/// The trend over all lines that may separate the two. A position outside is beyond one of these lines, and
/// remains there if it moves outward. Requires: near the boundary; paths that are not bent.
template <int D>
Trend trend_at_boundary(const Encounter<D>& encounter, const TrajectoryFamily<D>& family, double slack) {
  const auto& extents = encounter.extents;
  const double speed =
      (family.upper[1].abs().max(family.lower[1].abs()) + encounter.v.abs() + encounter.ev).sum();
  Trend trend = Trend::departing;
  const auto probe_along = [&](const Vec<D>& n, double error, double growth) {
    const double unsure = (error + 0x1p-44) * (speed + growth);
    if (min_of<D>(n, encounter.v, encounter.ev, family.all.velocity) > growth + unsure ||
        trend == Trend::approaching)
      return;
    const bool in = (n * encounter.v).sum() + family.all.velocity.support(-n) < growth - unsure;
    trend = in ? Trend::approaching : Trend::mixed;
  };
  Vec<D> n = Vec<D>::zero();
  for (int axis = 2; axis < D; ++axis) {
    n[axis] = std::copysign(1, encounter.x[axis]);
    if (extents.half[axis] - std::abs(encounter.x[axis]) <= slack)
      probe_along(n, 0, extents.growth.half[axis]);
    n[axis] = 0;
  }
  const double rate = extents.growth.radius, around = extents.radius;
  if (signed_distance_in_round_axes<D>(extents, encounter.x.abs(), encounter.x, n) <
      -encounter.inflation - slack)
    return trend;
  n = Vec<D>::zero();
  if (around > 0x1p20 * (encounter.inflation + slack)) {
    // With so small an error the nearest point of a piece has nearly the same direction.
    const double distance = extents.sum->signed_distance(encounter.x[0], encounter.x[1], n[0], n[1]);
    if (!(distance > 0.5 * around)) return Trend::mixed;
    probe_along(n, 4 * std::sqrt((encounter.inflation + slack) / distance), rate);
  } else if (around > slack) {
    return Trend::mixed;
  } else {
    const double near = 2 * encounter.rotation_chord * (encounter.x.abs().sum() + extents.size()) +
                        encounter.inflation + slack;
    extents.sum->for_each_edge_near(encounter.x[0], encounter.x[1], near,
                                    [&](double x, double y, double error) {
                                      n[0] = x, n[1] = y;
                                      probe_along(n, error + 2 * encounter.rotation_chord, rate);
                                    });
  }
  return trend;
}

}  // namespace

template <int D>
CountedVerdict certify_piece_separation_increases(const Encounter<D>& encounter,
                                                  const TrajectoryFamily<D>& family) {
  if (encounter.begin > 0) return certify_clearance<D>(encounter, family);
  Vec<D> ignored;
  const double slack = touching_share * (encounter.x.abs().largest() + encounter.extents.size());
  const double outside = signed_distance<D>(encounter.extents, encounter.x, ignored);
  if (outside > encounter.inflation + slack) return certify_clearance<D>(encounter, family);
  const CountedVerdict increasing = certify_separation_increases<D>(encounter, family);
  if (outside <= -encounter.inflation - slack) return increasing;
  const bool is_narrow = encounter.rotation_chord < min_chord;
  if (D == 1 || (increasing.verdict == ClearanceVerdict::blocked && is_narrow))
    return {ClearanceVerdict::blocked, increasing.evaluations};
  const Trend trend = trend_at_boundary<D>(encounter, family, slack);
  if (trend == Trend::departing && increasing.verdict == ClearanceVerdict::clear) return increasing;
  const bool is_blocked = trend == Trend::approaching && is_narrow;
  return {is_blocked ? ClearanceVerdict::blocked : ClearanceVerdict::undecided, increasing.evaluations};
}

template CountedVerdict certify_separation_increases<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template CountedVerdict certify_separation_increases<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template CountedVerdict certify_separation_increases<3>(const Encounter<3>&, const TrajectoryFamily<3>&);
template CountedVerdict certify_piece_separation_increases<1>(const Encounter<1>&,
                                                              const TrajectoryFamily<1>&);
template CountedVerdict certify_piece_separation_increases<2>(const Encounter<2>&,
                                                              const TrajectoryFamily<2>&);
template CountedVerdict certify_piece_separation_increases<3>(const Encounter<3>&,
                                                              const TrajectoryFamily<3>&);

}  // namespace foresee
