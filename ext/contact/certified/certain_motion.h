// The relative motion of a pair from its two rows, in double, with a bound on the error of each coefficient
// (certain_axis_motion.h).
#pragma once

#include <algorithm>
#include <array>

#include "contact/certified/certain_axis_motion.h"
#include "contact/minkowski/relative_motion.h"
#include "numbers/coefficients.h"

namespace foresee {

/// Relative motion on one axis for a common reference time, `age` before now.
template <int Degree>
CertainAxisMotion<double> axis_of_one_age(const AxisMotion<double>& a, const AxisMotion<double>& b,
                                          double age, double underflow) {
  constexpr double u = unit_roundoff;
  const double x = b.x - a.x, v = b.v - a.v, acceleration = Degree < 2 ? 0 : b.a - a.a;
  CertainAxisMotion<double> r{
      x, v, 0.5 * acceleration, u * std::abs(x) + underflow, u * std::abs(v) + underflow, 0};
  if (acceleration != 0) r.ea = u * std::abs(r.a) + 0x1p-1022;
  if (age == 0) return r;
  const double turn = age * acceleration, swing = std::abs(v) + std::abs(turn);
  r.x += age * (v + 0.5 * turn), r.v += turn;
  r.ex = 12 * u * (std::abs(x) + std::abs(age) * swing) + underflow, r.ev = 12 * u * swing + underflow;
  return r;
}

/// Relative motion on all axes, from `now` on. If numbers overflow, then nothing is certain.
template <int D, int Degree>
CertainMotion<D> certain_motion_of(const Setup& setup, const double* row_a, const double* row_b) {
  const double now = setup.horizon.now;
  const double t_a = value_or(row_a, setup.a.at.t, 0), t_b = value_or(row_b, setup.b.at.t, 0);
  const double s_a = now - t_a, s_b = now - t_b;
  CertainMotion<D> r;
  const double age = 1 + std::max(std::abs(s_a), std::abs(s_b)) + setup.horizon.h;
  r.underflow = age <= usual_age ? usual_underflow : 0x1p-1068 * age * age;
  for (int j = 0; j < D; ++j) {
    const AxisMotion<double> a = axis_motion(setup.a, row_a, j), b = axis_motion(setup.b, row_b, j);
    r.axis[j] = t_a == t_b ? axis_of_one_age<Degree>(a, b, s_a, r.underflow)
                           : axis_of_any_age<Degree>(a, b, s_a, s_b, r.underflow);
  }
  return r;
}

/// The relative motion, by powers of the time after tau.
template <int Degree, int D>
[[gnu::always_inline]] inline std::array<Coefficients<Bounded, Degree>, D> expanded_at(
    const CertainMotion<D>& relative, double tau) {
  std::array<Coefficients<Bounded, Degree>, D> x;
  for (std::size_t j = 0; j < D; ++j) {
    const CertainAxisMotion<double> view = view_from<Degree>(relative.axis[j], tau, relative.underflow);
    x[j][0] = {view.x, view.ex}, x[j][1] = {view.v, view.ev};
    if constexpr (Degree > 1) x[j][2] = {view.a, view.ea};
  }
  return x;
}

}  // namespace foresee
