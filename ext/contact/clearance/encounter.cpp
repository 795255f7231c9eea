#include "contact/clearance/encounter.h"

#include "contact/set/relative_motion.h"

namespace foresee {
namespace {

DoubleDouble number(double value) {
  return {value, 0};
}

/// The last moment of the horizon after `s`, rounded up.
double horizon_end(const Horizon& horizon, double s) {
  if (s == horizon.now) return horizon.h;
  const DoubleDouble passed = difference(s, horizon.now), left = difference(horizon.h, passed.high);
  if (passed.low == 0 && left.low == 0) return left.high;
  return left.high + 0x1p-50 * (horizon.h + std::abs(passed.high));
}

}  // namespace

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
      encounter.x[axis] = gap.high, encounter.v[axis] = other.v;
      encounter.ex[axis] = std::abs(gap.low), encounter.ev[axis] = 0;
      continue;
    }
    const DoubleDouble gained = age * number(other.a);
    const DoubleDouble v = number(other.v) + gained, x = gap + age * (number(other.v) + half_of(gained));
    const double magnitude = std::abs(age.high) * (std::abs(other.v) + std::abs(gained.high));
    encounter.x[axis] = x.high, encounter.v[axis] = v.high;
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

template Encounter<1> encounter_of<1>(const OwnMotion&, const Horizon&, const Bodies&, const double*,
                                      const GrowingExtents<1>&);
template Encounter<2> encounter_of<2>(const OwnMotion&, const Horizon&, const Bodies&, const double*,
                                      const GrowingExtents<2>&);
template Encounter<3> encounter_of<3>(const OwnMotion&, const Horizon&, const Bodies&, const double*,
                                      const GrowingExtents<3>&);

}  // namespace foresee
