// The relative course of a pair in plain double, each number with a bound on its error.
//
// With u = 2^-53 and S the larger |now - t|: positions are differenced before anything is added, so that two
// objects near each other and far from the origin lose nothing. Each coefficient is a sum of at most six
// rounded terms, each with at most five roundings behind it: within 12u of the sum of the terms' magnitudes,
// plus what underflow loses (below 2^-1070 (1 + S)^2).
#pragma once

#include "contact/set/pair_source.h"

namespace foresee {

/// What underflow loses while no time exceeds 2^40.
constexpr double usual_underflow = 0x1p-988;

template <int D>
struct Relative {
  double x[D], v[D], a[D];     ///< a is half the relative acceleration
  double ex[D], ev[D], ea[D];  ///< bounds on the errors
  double underflow;            ///< bound on what underflow loses in evaluating at any tau of the horizon
};

/// One axis seen from a moment: p + q s + a s^2 for the time s after it.
struct AxisView {
  double p, q, a;
  double ep, eq, ea;
};

template <int D, int Degree>
Relative<D> relative_of(const Setup& setup, const double* row_a, const double* row_b) {
  constexpr double u = unit_roundoff;
  const double now = setup.horizon.now;
  const double t_a = value_or(row_a, setup.a.at.t, 0), t_b = value_or(row_b, setup.b.at.t, 0);
  const double s_a = now - t_a, s_b = now - t_b;
  const bool rebase = s_a != 0 || s_b != 0;
  Relative<D> r;
  const double age = 1 + std::max(std::abs(s_a), std::abs(s_b)) + setup.horizon.h;
  // For all ages in use a constant: multiplying subnormal numbers costs processors a hundred cycles each.
  r.underflow = age <= 0x1p40 ? usual_underflow : 0x1p-1068 * age * age;
  for (int j = 0; j < D; ++j) {
    AxisMotion a = axis_motion(setup.a, row_a, j), b = axis_motion(setup.b, row_b, j);
    if constexpr (Degree < 2) a.a = b.a = 0;
    const double x = b.x - a.x, v = b.v - a.v, acceleration = b.a - a.a;
    r.a[j] = 0.5 * acceleration;
    r.ea[j] = acceleration == 0 ? 0 : u * std::abs(r.a[j]) + 0x1p-1022;
    if (!rebase) {
      r.x[j] = x, r.v[j] = v;
      r.ex[j] = u * std::abs(x) + r.underflow, r.ev[j] = u * std::abs(v) + r.underflow;
      continue;
    }
    if (t_a == t_b) {
      const double turn = s_a * acceleration;
      r.v[j] = v + turn;
      r.x[j] = x + s_a * (v + 0.5 * turn);
      r.ev[j] = 12 * u * (std::abs(v) + std::abs(turn)) + r.underflow;
      r.ex[j] = 12 * u * (std::abs(x) + std::abs(s_a) * (std::abs(v) + std::abs(turn))) + r.underflow;
    } else {
      const double turn_a = s_a * a.a, turn_b = s_b * b.a;
      r.v[j] = v + (turn_b - turn_a);
      r.x[j] = x + (s_b * (b.v + 0.5 * turn_b) - s_a * (a.v + 0.5 * turn_a));
      r.ev[j] = 12 * u * (std::abs(v) + std::abs(turn_a) + std::abs(turn_b)) + r.underflow;
      r.ex[j] = 12 * u *
                    (std::abs(x) + std::abs(s_a) * (std::abs(a.v) + std::abs(turn_a)) +
                     std::abs(s_b) * (std::abs(b.v) + std::abs(turn_b))) +
                r.underflow;
    }
  }
  return r;
}

/// Requires: 0 <= tau <= h.
template <int D, int Degree>
void view_from(const Relative<D>& r, double tau, AxisView (&view)[D]) {
  constexpr double u = unit_roundoff;
  for (int j = 0; j < D; ++j) {
    AxisView& w = view[j];
    if constexpr (Degree < 2) {
      w.p = r.x[j] + tau * r.v[j];
      w.ep = r.ex[j] + tau * r.ev[j] + 4 * u * (std::abs(r.x[j]) + tau * std::abs(r.v[j])) + r.underflow;
      w.q = r.v[j], w.eq = r.ev[j];
      w.a = 0, w.ea = 0;
    } else {
      const double turn = tau * r.a[j];
      w.p = r.x[j] + tau * (r.v[j] + turn);
      w.q = r.v[j] + 2 * turn;
      w.a = r.a[j], w.ea = r.ea[j];
      const double reach = tau * (std::abs(r.v[j]) + std::abs(turn));
      w.ep = r.ex[j] + tau * (r.ev[j] + tau * r.ea[j]) + 5 * u * (std::abs(r.x[j]) + reach) + r.underflow;
      w.eq = r.ev[j] + 2 * tau * r.ea[j] + 4 * u * (std::abs(r.v[j]) + 2 * std::abs(turn)) + r.underflow;
    }
  }
}

}  // namespace foresee
