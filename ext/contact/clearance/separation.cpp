#include "contact/clearance/separation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/clearance/departure.h"
#include "contact/clearance/separation_case.h"
#include "contact/clearance/turned_lines.h"

namespace foresee {
namespace {

constexpr double rounding = 0x1p-49;

/// A range of delays, where time counts from the start of each delayed motion. So all delays start at one
/// position, and the other object is where it is by then. A resting object then has one position for all delays,
/// and the path before the start need not be clear. The family has no all.starts. Cost: some 100 ns.
template <int D>
struct SeenFromStart {
  Encounter<D> encounter;
  TrajectoryFamily<D> family;
};

/// One delay: minus the displacement of the other object until the start, and the velocity relative to it
/// then.
template <int D>
TrajectoryEstimate<D> estimate_from_start(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                          double k) {
  const double duration = family.all.end - family.all.starts->to;
  return {-k * (encounter.v + (0.5 * k) * encounter.a), family.all.starts->velocity.centre - k * encounter.a,
          family.middle.a, std::max(0.0, encounter.begin - k), std::min(duration, encounter.end - k)};
}

/// What touches is seen to touch: a range that is clear as it is seen from the start is clear.
template <int D>
SeenFromStart<D> seen_from_start(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  SeenFromStart<D> seen{encounter, {}};
  const auto& starts = *family.all.starts;
  const double p = starts.from, q = starts.to, middle = p + 0.5 * (q - p),
               half = std::max(middle - p, q - middle) * (1 + 0x1p-50), far = std::max(std::abs(p), q);
  seen.encounter.begin = std::max(0.0, encounter.begin - q * (1 + 0x1p-50) - 0x1p-50 * encounter.begin);
  seen.encounter.end = encounter.end - p + 0x1p-50 * (std::abs(encounter.end) + std::abs(p));
  if (encounter.extents.grows) seen.encounter.extents.add(encounter.extents.growth, q * (1 + 0x1p-49));
  TrajectoryFamily<D>& after = seen.family;
  const Vec<D> v = encounter.v.abs(), a = encounter.a.abs();
  after.all.place.centre = -middle * (encounter.v + (0.5 * middle) * encounter.a);
  after.all.place.along = half * (encounter.v + middle * encounter.a);
  after.all.place.pad = 0.5 * half * half * a * (1 + rounding) + far * encounter.ev * (1 + rounding) +
                        rounding * (far * (v + far * a));
  after.all.velocity = starts.velocity;
  if (encounter.bends()) {
    after.all.velocity.centre -= middle * encounter.a;
    after.all.velocity.along = half * encounter.a;
    after.all.velocity.pad += rounding * (starts.velocity.centre.abs() + 2 * far * a);
  }
  after.all.acceleration = family.all.acceleration;
  after.all.begin = 0;
  after.all.end = family.all.end - p + 0x1p-50 * (std::abs(family.all.end) + std::abs(p));
  after.middle = estimate_from_start<D>(encounter, family, middle);
  after.first = estimate_from_start<D>(encounter, family, p);
  after.last = estimate_from_start<D>(encounter, family, q);
  after.bends = family.bends;
  after.one_interval = family.one_interval;
  after.is_from_start = true;
  find_bounds<D>(after);
  after.turned[0] = after.all.place.pad.sum();
  return seen;
}

/// The verdict on a set that does not rotate, by the normals at the nearest approaches of three motions. In this order:
///   - a plane by the middle motion;
///   - for two that nearly touch: do they move apart at once, and are they apart from then on?
///   - planes by the first and the last motion, unless the middle one touches and the paths are straight;
///   - do all motions touch at one time: when the middle one does, or the first, or the last?
///   - do all touch, each at its own time?
template <int D>
class VerdictByPlanes {
 public:
  VerdictByPlanes(SeparationCase<D>& separation, const Encounter<D>& encounter,
                  const TrajectoryFamily<D>& family)
      : separation_(separation), encounter_(encounter), family_(family) {}

  ClearanceVerdict verdict() {
    if (separation_.never_together()) return ClearanceVerdict::clear;
    if (!separation_.is_finite()) return ClearanceVerdict::blocked;
    probe_middle();
    if (encounter_.nearly_touches && !family_.all.starts && middle_ != ProbeResult::separated)
      if (const auto known = verdict_by_departure()) return *known;
    if (middle_ == ProbeResult::separated) return ClearanceVerdict::clear;
    if (middle_ == ProbeResult::inconclusive && an_end_is_separated()) return ClearanceVerdict::clear;
    if (separation_.all_touch_about(tau_) || separation_.ends_touch_about(tau_))
      return ClearanceVerdict::blocked;
    if (separation_.bends() && middle_ == ProbeResult::overlapping && an_end_is_separated())
      return ClearanceVerdict::clear;
    return all_touch() ? ClearanceVerdict::blocked : ClearanceVerdict::undecided;
  }

 private:
  void probe_middle() { middle_ = separation_.probe(family_.middle, tau_); }

  /// No value: other tests decide, from now on from the time until which the two move apart.
  std::optional<ClearanceVerdict> verdict_by_departure() {
    const Departure departure = departure_of<D>(encounter_, family_);
    const double length = separation_.end() - separation_.begin();
    if (length <= 0 || departure.away_until >= length) return ClearanceVerdict::clear;
    const bool moves_apart = departure.away_until > 0;
    if (!moves_apart && departure.all_touch && separation_.all_start_together())
      return ClearanceVerdict::blocked;
    if (!departure.all_approach) separation_.require_certain_touches();
    if (!moves_apart) return std::nullopt;
    separation_.start_at(separation_.begin() + 0.5 * departure.away_until);
    if (separation_.is_proven_after(separation_.begin())) return ClearanceVerdict::clear;
    probe_middle();
    return std::nullopt;
  }

  /// Whether the first or the last motion gives a plane; else nearest_times_ are known.
  bool an_end_is_separated() {
    for (std::size_t i = 0; i < 2; ++i) {
      double tau = 0;
      if (separation_.probe(*ends_[i], tau) == ProbeResult::separated) return true;
      nearest_times_[i] = tau;
    }
    return false;
  }

  /// Whether all touch, each at its own time, or at that of the first or the last motion. Approximate.
  bool all_touch() {
    if (separation_.bends()) return all_touch_between();
    if (family_.one_interval) return separation_.touches(family_.first) && separation_.touches(family_.last);
    for (std::size_t i = 0; i < 2; ++i) {
      if (!nearest_times_[i]) nearest_times_[i] = separation_.nearest_time(*ends_[i]);
      if (separation_.ends_touch_about(*nearest_times_[i])) return true;
    }
    return encounter_.extents.is_thin() && all_touch_between();
  }
  bool all_touch_between() const {
    const auto passing = [&](std::size_t i) {
      return passing_time<D>(encounter_.extents, relative(encounter_, *ends_[i]), *nearest_times_[i]);
    };
    return separation_.all_touch_between(passing(0), passing(1));
  }

  SeparationCase<D>& separation_;
  const Encounter<D>& encounter_;
  const TrajectoryFamily<D>& family_;
  const TrajectoryEstimate<D>* const ends_[2] = {&family_.first, &family_.last};
  ProbeResult middle_ = ProbeResult::inconclusive;  ///< of the middle motion
  double tau_ = 0;                                  ///< when it touches, or is nearest
  std::optional<double> nearest_times_[2];          ///< of the first and the last motion, once known
};

/// For a sum that rotates: whether all motions bring one corner into the other piece at tau. Approximate.
template <int D>
bool has_corner_inside(const SeparationCase<D>& separation, const Encounter<D>& encounter,
                       const TrajectoryFamily<D>& family, double tau) {
  const PairExtents<D> extents = encounter.extents.after(tau);
  const double slack = separation.slack_at(tau);
  const Vec<D> other = place_at<D>({encounter.x, encounter.v, encounter.a}, tau),
               own = place_at<D>(family.middle, tau);
  for (int axis = 2; axis < D; ++axis)
    if (!(std::abs(other[axis] - own[axis]) - extents.half[axis] <= slack)) return false;
  const VectorSet<D>& turned = family.all.velocity;
  return encounter.turning->has_corner_inside({other[0], other[D > 1]}, {own[0], own[D > 1]},
                                              {turned.sine, turned.cosine}, extents.radius, slack);
}

/// The verdict on a sum that rotates, on paths that are not bent: the pose of each motion is its own.
template <int D>
ClearanceVerdict verdict_on_turns(const SeparationCase<D>& separation, const Encounter<D>& encounter,
                                  const TrajectoryFamily<D>& family) {
  if (separation.never_together()) return ClearanceVerdict::clear;
  if (!separation.is_finite()) return ClearanceVerdict::blocked;
  if constexpr (D > 1)
    if (const auto known = verdict_by_lines<D>(encounter, family, separation.begin(), separation.end()))
      return *known;
  const RangeOfTurns& turns = *family.rotations;
  const TrajectoryEstimate<D>* const motions[] = {&family.middle, &family.first, &family.last};
  const SineCosine<double>* const poses[] = {&turns.middle, &turns.ends[0], &turns.ends[1]};
  StraightApproach<D> approaches[3];
  const auto is_inside = [&](int i) {
    return has_corner_inside<D>(separation, encounter, family, approaches[i].tau);
  };
  bool touch = true, apart = true;  // all so far; nearly touching is both
  for (int i = 0; i < 3; ++i) {
    if (i > 0) encounter.turning->turn(*poses[i]);
    const TrajectoryEstimate<D> path = relative(encounter, *motions[i]);
    approaches[i] = separation.approach_of(path);
    touch = touch && separation.touches(approaches[i]);
    apart = apart && approaches[i].gap > 0;
    if (apart && separation.any_plane_proves(path, approaches[i], separation.begin()))
      return ClearanceVerdict::clear;
    if (!touch && !apart) return ClearanceVerdict::undecided;
    if (i == 0 && touch && is_inside(0)) return ClearanceVerdict::blocked;
  }
  if (!touch) return ClearanceVerdict::undecided;
  encounter.turning->turn(turns.middle);
  const int shallow = approaches[1].gap > approaches[2].gap ? 1 : 2;
  const bool all_touch =
      is_inside(shallow) || separation.all_touch_about(approaches[0].tau) || is_inside(3 - shallow);
  return all_touch ? ClearanceVerdict::blocked : ClearanceVerdict::undecided;
}

/// The verdict on motions as they are given, whenever they start: by VerdictByPlanes, unless a sum rotates on paths
/// that are not bent.
template <int D>
CountedVerdict verdict_as_given(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  SeparationCase<D> separation(encounter, family);
  const ClearanceVerdict verdict = encounter.turning && !separation.bends()
                                       ? verdict_on_turns<D>(separation, encounter, family)
                                       : VerdictByPlanes<D>(separation, encounter, family).verdict();
  return {verdict, 1 + separation.parts()};
}

/// The verdict on delays, as they are seen from the start of each.
template <int D>
CountedVerdict verdict_from_start(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  const SeenFromStart<D> seen = seen_from_start<D>(encounter, family);
  CountedVerdict counted = verdict_as_given<D>(seen.encounter, seen.family);
  // Extents that grow are seen as large as at the last start: of the first ones too much seems to touch.
  if (encounter.extents.grows && counted.verdict == ClearanceVerdict::blocked)
    counted.verdict = ClearanceVerdict::undecided;
  return counted;
}

}  // namespace

template <int D>
CountedVerdict certify_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  CountedVerdict from_start{ClearanceVerdict::undecided};
  if (family.all.starts) from_start = verdict_from_start<D>(encounter, family);
  if (from_start.verdict != ClearanceVerdict::undecided) return from_start;
  CountedVerdict counted = verdict_as_given<D>(encounter, family);
  counted.evaluations += from_start.evaluations;
  return counted;
}

template <int D>
CountedVerdict certify_only_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  const auto clear_or_undecided = [](bool clear) {
    return clear ? ClearanceVerdict::clear : ClearanceVerdict::undecided;
  };
  const SeparationCase<D> separation(encounter, family);
  if (separation.bends() || encounter.nearly_touches || encounter.turning || family.all.starts) {
    const CountedVerdict counted = certify_clearance<D>(encounter, family);
    return {clear_or_undecided(counted.verdict == ClearanceVerdict::clear), counted.evaluations};
  }
  if (separation.never_together()) return {ClearanceVerdict::clear, 1};
  if (!separation.is_finite()) return {ClearanceVerdict::undecided, 1};
  const auto probe = [&](const TrajectoryEstimate<D>& own) {
    double ignored = 0;
    return separation.probe(own, ignored);
  };
  const ProbeResult middle = probe(family.middle);
  if (middle != ProbeResult::inconclusive) return {clear_or_undecided(middle == ProbeResult::separated), 1};
  const bool by_an_end =
      probe(family.first) == ProbeResult::separated || probe(family.last) == ProbeResult::separated;
  return {clear_or_undecided(by_an_end), 1};
}

template CountedVerdict certify_only_clearance<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template CountedVerdict certify_only_clearance<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template CountedVerdict certify_only_clearance<3>(const Encounter<3>&, const TrajectoryFamily<3>&);
template CountedVerdict certify_clearance<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template CountedVerdict certify_clearance<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template CountedVerdict certify_clearance<3>(const Encounter<3>&, const TrajectoryFamily<3>&);

}  // namespace foresee
