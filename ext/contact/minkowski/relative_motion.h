// The input of a contact test without geometry: two tables and the horizon, a moving window, the common
// lifetime of a pair and its relative motion.
//
// Time is measured from `now`: tau = 0 is now. With an exact number type as T no result is rounded; with
// DoubleDouble the rounding errors are small.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "contact/pair_rule.h"
#include "motion/law.h"
#include "numbers/coefficients.h"
#include "numbers/crossed_root.h"
#include "numbers/exact_conversion.h"
#include "shape/bodies.h"

namespace foresee {

/// A moving window: a closed box that may be open to any side. The positions of its faces at `now`, one pair
/// per axis of the tables. Requires: lower < +infinity, upper > -infinity, lower <= upper; velocity finite.
struct WindowFaces {
  std::array<double, 3> lower{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  std::array<double, 3> upper{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<double, 3> velocity{};

  bool has_lower(int axis) const { return std::isfinite(lower[static_cast<std::size_t>(axis)]); }
  bool has_upper(int axis) const { return std::isfinite(upper[static_cast<std::size_t>(axis)]); }
  /// The origin of coordinates along an axis: a finite face if one exists, else 0.
  double reference(int axis) const {
    const auto j = static_cast<std::size_t>(axis);
    return has_lower(axis) ? lower[j] : has_upper(axis) ? upper[j] : 0;
  }
};

/// The inputs of contact: two tables, the horizon and the rule of their distance. If the first table is a
/// window, then `window` has its faces.
struct Setup {
  Bodies a, b;
  Horizon horizon;
  PairRule rule = {};
  const WindowFaces* window = nullptr;
};

/// Centre of b minus centre of a, on each axis by powers of tau: the last coefficient is half the relative
/// acceleration.
template <class T, std::size_t D>
using RelativeMotion = std::array<Coefficients<T, 2>, D>;

/// When both objects exist within the horizon, measured from now and absolute; each rounded once.
struct PairLifetime {
  double dt_start, dt_end;
  double t_start, t_end;
  bool start_exact, end_exact;  ///< dt_start, dt_end are the exact values
  bool ends_with_horizon;       ///< the end is now + h, not that of an object
  bool none;                    ///< the two objects never exist together during the horizon

  Instant start() const { return {dt_start, t_start}; }
  Instant end() const { return {dt_end, t_end}; }
};

/// The lifetime of a pair. `none` is decided exactly.
inline PairLifetime pair_lifetime_of(const Setup& setup, const double* row_a, const double* row_b) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double now = setup.horizon.now, h = setup.horizon.h;
  const double start = std::max({now, value_or(row_a, setup.a.at.t, 0), value_or(row_b, setup.b.at.t, 0)});
  const double stop =
      std::min(value_or(row_a, setup.a.at.until, inf), value_or(row_b, setup.b.at.until, inf));
  const DoubleDouble begin = difference(start, now);
  PairLifetime lifetime{begin.high, h, start, now + h, begin.low == 0, true, true, false};
  lifetime.none = start > stop || begin.high > h || (begin.high == h && begin.low > 0);
  if (stop < inf) {
    const DoubleDouble end = difference(stop, now);
    if (end.high < h || (end.high == h && end.low < 0)) {
      lifetime.dt_end = end.high;
      lifetime.t_end = stop;
      lifetime.end_exact = end.low == 0;
      lifetime.ends_with_horizon = false;
    }
  }
  return lifetime;
}

/// The motion of one object on one axis; undeclared coefficients are 0.
inline AxisMotion<double> axis_motion(const Bodies& bodies, const double* row, int axis) {
  const Offsets& at = bodies.at;
  return {row[at.x + axis], at.v == Offsets::absent ? 0 : row[at.v + axis],
          at.a == Offsets::absent ? 0 : row[at.a + axis]};
}

template <class T>
Coefficients<T, 2> relative_axis_motion_of(const Setup& setup, const double* row_a, const double* row_b,
                                           int axis) {
  using E = Exactly<T>;
  const double now = setup.horizon.now;
  const double t_a = value_or(row_a, setup.a.at.t, 0), t_b = value_or(row_b, setup.b.at.t, 0);
  const AxisMotion<double> a = axis_motion(setup.a, row_a, axis), b = axis_motion(setup.b, row_b, axis);
  const T x = E::difference_of(b.x, a.x), v = E::difference_of(b.v, a.v);
  const T acceleration = E::difference_of(b.a, a.a), half_acceleration = half_of(acceleration);
  if (t_a == now && t_b == now) return {x, v, half_acceleration};
  const T s_a = E::difference_of(now, t_a);
  if (t_a == t_b) return {x + s_a * (v + s_a * half_acceleration), v + s_a * acceleration, half_acceleration};
  const T s_b = E::difference_of(now, t_b);
  const T turn_a = s_a * E::number(a.a), turn_b = s_b * E::number(b.a);
  return {x + (s_b * (E::number(b.v) + half_of(turn_b)) - s_a * (E::number(a.v) + half_of(turn_a))),
          v + (turn_b - turn_a), half_acceleration};
}

/// The relative motion from `now` on in the precision of T, on so many axes; 0 on the others.
template <class T, std::size_t D>
RelativeMotion<T, D> relative_motion_of(const Setup& setup, const double* row_a, const double* row_b,
                                        int axes = D) {
  RelativeMotion<T, D> relative;
  for (int axis = 0; axis < axes; ++axis)
    relative[static_cast<std::size_t>(axis)] = relative_axis_motion_of<T>(setup, row_a, row_b, axis);
  return relative;
}

}  // namespace foresee
