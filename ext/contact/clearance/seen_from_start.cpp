#include "contact/clearance/seen_from_start.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

constexpr double rounding = 0x1p-49;

/// Where the other is at the start, and how fast, of one change: what the own place and velocity have less.
template <int D>
TrajectoryEstimate<D> rough_way_after(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                      double k) {
  const double duration = family.all.end - family.delay_to;
  return {-k * (encounter.v + (0.5 * k) * encounter.a), family.at_start.centre - k * encounter.a,
          family.middle.a, std::max(0.0, encounter.begin - k), std::min(duration, encounter.end - k)};
}

}  // namespace

template <int D>
SeenFromStart<D> seen_from_start(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  SeenFromStart<D> seen{encounter, {}};
  const double p = family.delay_from, q = family.delay_to, middle = p + 0.5 * (q - p),
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
  after.all.velocity = family.at_start;
  if (encounter.bends()) {
    after.all.velocity.centre -= middle * encounter.a;
    after.all.velocity.along = half * encounter.a;
    after.all.velocity.pad += rounding * (family.at_start.centre.abs() + 2 * far * a);
  }
  after.all.acceleration = family.all.acceleration;
  after.all.begin = 0;
  after.all.end = family.all.end - p + 0x1p-50 * (std::abs(family.all.end) + std::abs(p));
  after.middle = rough_way_after<D>(encounter, family, middle);
  after.first = rough_way_after<D>(encounter, family, p),
  after.last = rough_way_after<D>(encounter, family, q);
  after.bends = family.bends, after.one_interval = family.one_interval, after.is_from_start = true;
  find_ends<D>(after);
  after.turned[0] = after.all.place.pad.sum();
  return seen;
}

template SeenFromStart<1> seen_from_start<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template SeenFromStart<2> seen_from_start<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template SeenFromStart<3> seen_from_start<3>(const Encounter<3>&, const TrajectoryFamily<3>&);

}  // namespace foresee
