#include "contact/clearance/trajectory_family.h"

#include "contact/minkowski/relative_motion.h"
#include "numbers/correct_rounding.h"

namespace foresee {
namespace {

/// Upper bound of the relative error of sums of lengths.
constexpr double rounded_up = 0x1p-50;

/// The extents whose sizes are size(each size of the rule).
template <int D, class SizeOf>
PairExtents<D> composed(const PairRule& rule, const SizeOf& size) {
  PairExtents<D> pair{Vec<D>::zero(), size(rule.radius), rule.distance == Distance::upright ? 2 : D};
  for (int axis = 0; axis < D; ++axis) pair.half[axis] = size(rule.extent[axis]);
  return pair;
}

DoubleDouble number(double value) {
  return {value, 0};
}

/// The end of the horizon, in seconds after `s`, rounded up.
double horizon_end(const Horizon& horizon, double s) {
  if (s == horizon.now) return horizon.h;
  const DoubleDouble passed = difference(s, horizon.now), left = difference(horizon.h, passed.high);
  if (passed.low == 0 && left.low == 0) return left.high;
  return left.high + 0x1p-50 * (horizon.h + std::abs(passed.high));
}

/// Both bounds on each axis; most sets of a scene contain only 0.
template <int D>
void find_bounds(const VectorSet<D>& set, Vec<D>& lower, Vec<D>& upper) {
  lower = upper = Vec<D>::zero();
  if ((set.centre == 0).all() && (set.along == 0).all() && (set.pad == 0).all()) return;
  for (int axis = 0; axis < D; ++axis) {
    const bool is_one = !set.is_arc && set.along[axis] == 0 && set.pad[axis] == 0;
    upper[axis] = is_one ? set.centre[axis] : set.max(axis);
    lower[axis] = is_one ? set.centre[axis] : set.min(axis);
  }
}

}  // namespace

template <int D>
GrowingExtents<D> extents_of_both(const PairRule& rule, const double* row_a, const double* row_b,
                                  double time) {
  const auto size = [&](const PairSize& both) { return size_as_of_t<double>(both, row_a, row_b); };
  GrowingExtents<D> pair{composed<D>(rule, size)};
  if (rule.grows) {
    // The size that growth adds in these times.
    const auto grown = [&](double age_a, double age_b) {
      return [&, age_a, age_b](const PairSize& both) {
        return age_a * value_or(row_a, both.growth_a, 0) + age_b * value_or(row_b, both.growth_b, 0);
      };
    };
    const double age_a = time - value_or(row_a, rule.t_a, 0), age_b = time - value_or(row_b, rule.t_b, 0);
    pair.growth = composed<D>(rule, grown(1 + rounded_up, 1 + rounded_up));
    pair.grows = pair.growth.radius > 0 || (pair.growth.half > 0).any();
    pair.add(composed<D>(rule, grown(std::abs(age_a), std::abs(age_b))), rounded_up);
    pair.add(composed<D>(rule, grown(age_a, age_b)));
  }
  pair.half += rounded_up * pair.half.abs();
  pair.radius += rounded_up * std::abs(pair.radius);
  return pair;
}

template <int D>
Encounter<D> encounter_of(const OwnMotion& base, const Horizon& horizon, const Bodies& others,
                          const double* row, const GrowingExtents<D>& extents) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double t = value_or(row, others.at.t, 0), until = value_or(row, others.at.until, inf);
  const DoubleDouble age = difference(base.t, t);
  Encounter<D> encounter;
  for (int axis = 0; axis < D; ++axis) {
    const AxisMotion<double> other = axis_motion(others, row, axis);
    const double own = base.x[static_cast<std::size_t>(axis)];
    const DoubleDouble gap = difference(other.x, own);
    encounter.a[axis] = other.a;
    if (age.high == 0) {
      encounter.x[axis] = gap.high;
      encounter.v[axis] = other.v;
      encounter.ex[axis] = std::abs(gap.low);
      encounter.ev[axis] = 0;
      continue;
    }
    const DoubleDouble gained = age * number(other.a);
    const DoubleDouble v = number(other.v) + gained, x = gap + age * (number(other.v) + half_of(gained));
    const double magnitude = std::abs(age.high) * (std::abs(other.v) + std::abs(gained.high));
    encounter.x[axis] = x.high;
    encounter.v[axis] = v.high;
    encounter.ex[axis] = std::abs(x.low) + 0x1p-95 * (std::abs(other.x) + std::abs(own) + magnitude) +
                         (magnitude == 0 ? 0 : 0x1p-1000);
    encounter.ev[axis] = std::abs(v.low) + 0x1p-95 * (std::abs(other.v) + std::abs(gained.high)) +
                         (gained.high == 0 ? 0 : 0x1p-1000);
  }
  encounter.extents = extents;
  const double begin = t - base.t, end = until - base.t;
  encounter.begin = std::max(0.0, begin * (1 - 0x1p-50));
  encounter.end = std::min(horizon_end(horizon, base.t), end > 0 ? end * (1 + 0x1p-50) : end * (1 - 0x1p-50));
  return encounter;
}

RangeOfTurns range_of_turns(double p, double q) {
  const double middle = p + 0.5 * (q - p), half = std::max(middle - p, q - middle) * (1 + 0x1p-50);
  RangeOfTurns turns;
  turns.middle = quick_sine_cosine(middle);
  if (!(half > 0)) return {{turns.middle, turns.middle}, turns.middle, 0};
  turns.ends = {quick_sine_cosine(p), quick_sine_cosine(q)};
  turns.chord = std::min(2.0, half * (radians_per_degree * (1 + 0x1p-40)));  // not above the arc
  return turns;
}

template <int D>
void find_bounds(TrajectoryFamily<D>& family) {
  const VectorSet<D>* const parts[] = {&family.all.place, &family.all.velocity, &family.all.acceleration};
  for (int part = 0; part < 3; ++part) find_bounds<D>(*parts[part], family.lower[part], family.upper[part]);
}

template <int D>
TrajectoryFamily<D> trajectory_family(const Changes& changes, double p, double q) {
  TrajectoryFamily<D> family;
  family.all = changes.between<D>(p, q);
  const auto& all = family.all;
  family.middle = {all.place.centre, all.velocity.centre, all.acceleration.centre, all.begin, all.end};
  family.first = changes.estimate<D>(p);
  family.last = changes.estimate<D>(q);
  find_bounds<D>(family);
  const auto off_chord = [](const VectorSet<D>& set) {
    return set.is_arc ? (1 - (set.whole_circle ? -1 : set.cosine)) * set.radius : set.bulge;
  };
  family.turned[0] = off_chord(all.place) + all.place.pad.sum();
  family.turned[1] = off_chord(all.velocity);
  family.turned[2] = off_chord(all.acceleration);
  // For turns by more than a third of a circle the middle is not typical: the mean is near 0.
  const auto shorten = [](const VectorSet<D>& set, Vec<D>& middle) {
    if (set.is_arc && set.cosine < 0.5) middle *= set.cosine > 0 ? 0.5 : 0;
  };
  shorten(all.velocity, family.middle.v);
  shorten(all.place, family.middle.x);
  family.bends = (family.upper[2] != 0).any() || (family.lower[2] != 0).any();
  family.one_interval = changes.touches_in_one_interval() && p < q;
  family.from = p, family.to = q;
  return family;
}

template GrowingExtents<1> extents_of_both<1>(const PairRule&, const double*, const double*, double);
template GrowingExtents<2> extents_of_both<2>(const PairRule&, const double*, const double*, double);
template GrowingExtents<3> extents_of_both<3>(const PairRule&, const double*, const double*, double);
template Encounter<1> encounter_of<1>(const OwnMotion&, const Horizon&, const Bodies&, const double*,
                                      const GrowingExtents<1>&);
template Encounter<2> encounter_of<2>(const OwnMotion&, const Horizon&, const Bodies&, const double*,
                                      const GrowingExtents<2>&);
template Encounter<3> encounter_of<3>(const OwnMotion&, const Horizon&, const Bodies&, const double*,
                                      const GrowingExtents<3>&);
template void find_bounds<1>(TrajectoryFamily<1>&);
template void find_bounds<2>(TrajectoryFamily<2>&);
template void find_bounds<3>(TrajectoryFamily<3>&);
template TrajectoryFamily<1> trajectory_family<1>(const Changes&, double, double);
template TrajectoryFamily<2> trajectory_family<2>(const Changes&, double, double);
template TrajectoryFamily<3> trajectory_family<3>(const Changes&, double, double);

}  // namespace foresee
