#include "contact/growing/seen_from_start.h"

#include <algorithm>
#include <cmath>

namespace foresee::contact {
namespace {

constexpr double rounding = 0x1p-49;

/// Where the other is at the start, and how fast, of one change: what the own place and velocity have less.
template <int D>
RoughWay<D> rough_way_after(const Encounter<D>& met, const ChangedWays<D>& ways, double k) {
  const double duration = ways.all.end - ways.delay_to;
  return {-k * (met.v + (0.5 * k) * met.a), ways.at_start.centre - k * met.a, ways.middle.a,
          std::max(0.0, met.begin - k), std::min(duration, met.end - k)};
}

}  // namespace

template <int D>
SeenFromStart<D> seen_from_start(const Encounter<D>& met, const ChangedWays<D>& ways) {
  SeenFromStart<D> seen{met, {}};
  const double p = ways.delay_from, q = ways.delay_to, middle = p + 0.5 * (q - p),
               half = std::max(middle - p, q - middle) * (1 + 0x1p-50), far = std::max(std::abs(p), q);
  seen.met.begin = std::max(0.0, met.begin - q * (1 + 0x1p-50) - 0x1p-50 * met.begin);
  seen.met.end = met.end - p + 0x1p-50 * (std::abs(met.end) + std::abs(p));
  if (met.extents.grows) seen.met.extents.add(met.extents.growth, q * (1 + 0x1p-49));
  ChangedWays<D>& after = seen.ways;
  const Vec<D> v = met.v.abs(), a = met.a.abs();
  after.all.place.centre = -middle * (met.v + (0.5 * middle) * met.a);
  after.all.place.along = half * (met.v + middle * met.a);
  after.all.place.pad = 0.5 * half * half * a * (1 + rounding) + far * met.ev * (1 + rounding) +
                        rounding * (far * (v + far * a));
  after.all.velocity = ways.at_start;
  if (met.bends()) {
    after.all.velocity.centre -= middle * met.a;
    after.all.velocity.along = half * met.a;
    after.all.velocity.pad += rounding * (ways.at_start.centre.abs() + 2 * far * a);
  }
  after.all.acceleration = ways.all.acceleration;
  after.all.begin = 0;
  after.all.end = ways.all.end - p + 0x1p-50 * (std::abs(ways.all.end) + std::abs(p));
  after.middle = rough_way_after<D>(met, ways, middle);
  after.first = rough_way_after<D>(met, ways, p), after.last = rough_way_after<D>(met, ways, q);
  after.bends = ways.bends, after.one_interval = ways.one_interval, after.is_from_start = true;
  find_ends<D>(after);
  after.turned[0] = after.all.place.pad.sum();
  return seen;
}

template SeenFromStart<1> seen_from_start<1>(const Encounter<1>&, const ChangedWays<1>&);
template SeenFromStart<2> seen_from_start<2>(const Encounter<2>&, const ChangedWays<2>&);
template SeenFromStart<3> seen_from_start<3>(const Encounter<3>&, const ChangedWays<3>&);

}  // namespace foresee::contact
