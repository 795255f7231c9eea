// What the contact room knows about a pair before any geometry: its rows, its moments, its relative motion.
//
// Time runs from `now`: tau = 0 is now. With exact numbers as T nothing is rounded; with DoubleDouble little
// is.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/motion.h"
#include "numbers/exact_conversion.h"
#include "shape/bodies.h"

namespace foresee {

struct WindowFaces;

/// Two tables and a question; `within` is the limit in x and y (or along all axes), `within_z` the one along
/// z. Where the first table is a window, `window` says where its faces are.
struct Setup {
  Bodies a, b;
  Horizon horizon;
  double within = 0;
  double within_z = 0;
  const WindowFaces* window = nullptr;
};

/// Centre of b minus centre of a: x + v tau + a tau^2 on each axis, so `a` is half the relative acceleration.
template <class T, int D>
struct RelativeMotion {
  T x[D], v[D], a[D];
};

/// The same on one axis.
template <class T>
struct RelativeAxisMotion {
  T x, v, a;
};

/// When both exist within the horizon, measured from now and absolute; each rounded once.
struct PairLifetime {
  double dt_start, dt_end;
  double t_start, t_end;
  bool start_exact, end_exact;  ///< dt_start, dt_end are the exact values
  bool ends_with_horizon;       ///< the end is now + h, not an object's own
  bool none;                    ///< the two never exist together during the horizon
};

/// Decided exactly: `none` is never a guess.
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

/// What is not declared is 0.
inline AxisMotion<double> axis_motion(const Bodies& bodies, const double* row, int axis) {
  const Offsets& at = bodies.at;
  return {row[at.x + axis], at.v == Offsets::absent ? 0 : row[at.v + axis],
          at.a == Offsets::absent ? 0 : row[at.a + axis]};
}

template <class T>
RelativeAxisMotion<T> relative_axis_motion_of(const Setup& setup, const double* row_a, const double* row_b,
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

/// From `now` on, on all axes, in T's precision.
template <class T, int D>
RelativeMotion<T, D> relative_motion_of(const Setup& setup, const double* row_a, const double* row_b) {
  RelativeMotion<T, D> relative;
  for (int axis = 0; axis < D; ++axis) {
    const RelativeAxisMotion<T> one = relative_axis_motion_of<T>(setup, row_a, row_b, axis);
    relative.x[axis] = one.x, relative.v[axis] = one.v, relative.a[axis] = one.a;
  }
  return relative;
}

}  // namespace foresee
