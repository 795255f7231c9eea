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
/// position, and the other object is where it is by then. A resting object then has one position for all
/// delays, and the path before the start need not be clear. Cost: some 100 ns.
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
  after.first = estimate_from_start<D>(encounter, family, p),
  after.last = estimate_from_start<D>(encounter, family, q);
  after.bends = family.bends, after.one_interval = family.one_interval, after.is_from_start = true;
  find_ends<D>(after);
  after.turned[0] = after.all.place.pad.sum();
  return seen;
}

/// `nearest`: when the first and the last change touch, about.
template <int D>
bool all_touch_between(const SeparationCase<D>& separation, const Encounter<D>& encounter,
                       const TrajectoryFamily<D>& family, const std::optional<double> (&nearest)[2]) {
  const auto passing = [&](const TrajectoryEstimate<D>& own, double tau) {
    return passing_time<D>(encounter.extents, relative(encounter, own), tau);
  };
  return separation.all_touch_between(passing(family.first, *nearest[0]), passing(family.last, *nearest[1]));
}

/// The verdict on a set that does not rotate, by the normals at the nearest approaches of three motions.
template <int D>
ClearanceVerdict verdict_by_planes(SeparationCase<D>& separation, const Encounter<D>& encounter,
                                   const TrajectoryFamily<D>& family) {
  if (separation.never_together()) return ClearanceVerdict::clear;
  if (!separation.is_finite()) return ClearanceVerdict::blocked;
  double tau = 0;
  std::optional<double> nearest[2];  // of the first and the last change, once known
  const TrajectoryEstimate<D>* const ends[] = {&family.first, &family.last};
  ProbeResult probe = separation.probe(family.middle, separation.begin(), tau);
  if (encounter.beside && !family.all.starts && probe != ProbeResult::separated) {
    const Departure leaving = departure_of<D>(encounter, family);
    const double length = separation.end() - separation.begin();
    if (length <= 0 || leaving.away_until >= length) return ClearanceVerdict::clear;
    if (leaving.away_until > 0)
      separation.start_at(separation.begin() + 0.5 * leaving.away_until);
    else if (leaving.all_touch && separation.all_start_together())
      return ClearanceVerdict::blocked;
    if (!leaving.all_approach) separation.take_only_certain_touches();
    if (leaving.away_until > 0) {
      if (separation.is_proven_after(separation.begin())) return ClearanceVerdict::clear;
      probe = separation.probe(family.middle, separation.begin(), tau);
    }
  }
  switch (probe) {
    case ProbeResult::separated:
      return ClearanceVerdict::clear;
    case ProbeResult::overlapping:
      if (separation.all_touch_about(tau)) return ClearanceVerdict::blocked;
      break;
    case ProbeResult::inconclusive:
      for (int i = 0; i < 2; ++i) {
        double near = 0;
        if (separation.probe(*ends[i], separation.begin(), near) == ProbeResult::separated)
          return ClearanceVerdict::clear;
        nearest[i] = near;
      }
      if (separation.all_touch_about(tau)) return ClearanceVerdict::blocked;
      break;
  }
  if (separation.ends_touch_about(tau)) return ClearanceVerdict::blocked;
  if (separation.bends()) {
    for (int i = 0; i < 2; ++i) {
      double near = 0;
      if (!nearest[i] && separation.probe(*ends[i], separation.begin(), near) == ProbeResult::separated)
        return ClearanceVerdict::clear;
      if (!nearest[i]) nearest[i] = near;
    }
    return all_touch_between<D>(separation, encounter, family, nearest) ? ClearanceVerdict::blocked
                                                                        : ClearanceVerdict::open;
  }
  if (!family.one_interval) {
    for (int i = 0; i < 2; ++i) {
      if (!nearest[i]) nearest[i] = separation.nearest_time(*ends[i]);
      if (separation.ends_touch_about(*nearest[i])) return ClearanceVerdict::blocked;
    }
    if (encounter.extents.is_thin() && all_touch_between<D>(separation, encounter, family, nearest))
      return ClearanceVerdict::blocked;
  }
  if (family.one_interval && separation.touches(family.first) && separation.touches(family.last))
    return ClearanceVerdict::blocked;
  return ClearanceVerdict::open;
}

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
  const RangeOfTurns& turns = *family.turns;
  const TrajectoryEstimate<D>* const motions[] = {&family.middle, &family.first, &family.last};
  const SineCosine<double>* const poses[] = {&turns.middle, &turns.ends[0], &turns.ends[1]};
  StraightApproach<D> near[3];
  const auto is_inside = [&](int i) {
    return has_corner_inside<D>(separation, encounter, family, near[i].tau);
  };
  bool touch = true, apart = true;  // all so far; nearly touching is both
  for (int i = 0; i < 3; ++i) {
    if (i > 0) encounter.turning->turn(*poses[i]);
    const TrajectoryEstimate<D> path = relative(encounter, *motions[i]);
    near[i] = separation.approach_of(path);
    touch = touch && separation.touches(near[i]), apart = apart && near[i].gap > 0;
    if (apart && separation.is_proven_beside(path, near[i], separation.begin()))
      return ClearanceVerdict::clear;
    if (!touch && !apart) return ClearanceVerdict::open;
    if (i == 0 && touch && is_inside(0)) return ClearanceVerdict::blocked;
  }
  if (!touch) return ClearanceVerdict::open;
  encounter.turning->turn(turns.middle);
  const int shallow = near[1].gap > near[2].gap ? 1 : 2;
  const bool all_touch =
      is_inside(shallow) || separation.all_touch_about(near[0].tau) || is_inside(3 - shallow);
  return all_touch ? ClearanceVerdict::blocked : ClearanceVerdict::open;
}

}  // namespace

template <int D>
CountedVerdict certify_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  CountedVerdict counted{};
  if (family.all.starts) {
    const SeenFromStart<D> seen = seen_from_start<D>(encounter, family);
    counted = certify_clearance<D>(seen.encounter, seen.family);
    // Extents that grow are seen as large as at the last start: of the first ones too much seems to touch.
    const bool is_sure = counted.verdict == ClearanceVerdict::clear || !encounter.extents.grows;
    if (counted.verdict != ClearanceVerdict::open && is_sure) return counted;
  }
  SeparationCase<D> separation(encounter, family);
  counted.verdict = encounter.turning && !separation.bends()
                        ? verdict_on_turns<D>(separation, encounter, family)
                        : verdict_by_planes<D>(separation, encounter, family);
  counted.evaluations += 1 + separation.parts();
  return counted;
}

template <int D>
CountedVerdict certify_only_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  const auto clear_or_open = [](bool clear) {
    return clear ? ClearanceVerdict::clear : ClearanceVerdict::open;
  };
  const SeparationCase<D> separation(encounter, family);
  if (separation.bends() || encounter.beside || encounter.turning || family.all.starts) {
    const CountedVerdict counted = certify_clearance<D>(encounter, family);
    return {clear_or_open(counted.verdict == ClearanceVerdict::clear), counted.evaluations};
  }
  if (separation.never_together()) return {ClearanceVerdict::clear, 1};
  if (!separation.is_finite()) return {ClearanceVerdict::open, 1};
  const auto probe = [&](const TrajectoryEstimate<D>& own) {
    double ignored = 0;
    return separation.probe(own, separation.begin(), ignored);
  };
  const ProbeResult middle = probe(family.middle);
  if (middle != ProbeResult::inconclusive) return {clear_or_open(middle == ProbeResult::separated), 1};
  const bool by_an_end =
      probe(family.first) == ProbeResult::separated || probe(family.last) == ProbeResult::separated;
  return {clear_or_open(by_an_end), 1};
}

template CountedVerdict certify_only_clearance<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template CountedVerdict certify_only_clearance<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template CountedVerdict certify_only_clearance<3>(const Encounter<3>&, const TrajectoryFamily<3>&);
template CountedVerdict certify_clearance<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template CountedVerdict certify_clearance<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template CountedVerdict certify_clearance<3>(const Encounter<3>&, const TrajectoryFamily<3>&);

}  // namespace foresee
