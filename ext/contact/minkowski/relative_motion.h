// The motion of one object and the relative motion of a pair, on each axis by powers of time.
//
// Time is measured from `now`: tau = 0 is now. With an exact number type as T no result is rounded; with
// DoubleDouble the rounding errors are small.
#pragma once

#include <array>
#include <cstddef>

#include "contact/setup.h"
#include "motion/motion.h"
#include "numbers/coefficients.h"
#include "numbers/exact_conversion.h"

namespace foresee {

/// Centre of b minus centre of a, on each axis by powers of tau: the last coefficient is half the relative
/// acceleration.
template <class T, std::size_t D>
using RelativeMotion = std::array<Coefficients<T, 2>, D>;

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
