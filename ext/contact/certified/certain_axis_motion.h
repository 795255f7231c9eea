// The relative motion of a pair in double, with a bound on the error of each coefficient.
//
// Let u = 2^-53 and let S be the larger |now - t|. Positions are subtracted before any addition, so that two
// objects near each other and far from the origin lose no digits. Each coefficient is a sum of at most six
// rounded terms, and a term has at most seven roundings. The error is at most 12u of the sum of the
// magnitudes of the terms, plus the underflow, which is below 2^-1070 (1 + S)^2.
//
// No types of rows are included, for kernels (base/simd.h); certain_motion.h reads rows.
//
// Real: double, or several pairs at once (base/doubles.h).
#pragma once

#include <cmath>

#include "base/lane_math.h"
#include "motion/motion.h"
#include "numbers/double_double.h"

namespace foresee {

/// Up to this age of a motion the bound on underflow is usual_underflow. It is a constant, because a product
/// of subnormal numbers takes a hundred cycles.
constexpr double usual_age = 0x1p40, usual_underflow = 0x1p-988;

/// Motion on one axis: x + v tau + a tau^2 (a is half the relative acceleration), and bounds on the errors.
template <class Real>
struct CertainAxisMotion {
  Real x, v, a;
  Real ex, ev, ea;
};

template <int D, class Real = double>
struct CertainMotion {
  CertainAxisMotion<Real> axis[D];
  Real underflow;  ///< bound on the underflow of an evaluation at any tau of the horizon
};

/// Relative motion on one axis for any two reference times, `s_a` and `s_b` before now.
template <int Degree, class Real>
CertainAxisMotion<Real> axis_of_any_age(const AxisMotion<Real>& a, const AxisMotion<Real>& b, const Real& s_a,
                                        const Real& s_b, const Real& underflow) {
  using std::abs;
  constexpr double u = unit_roundoff;
  const Real x = b.x - a.x, v = b.v - a.v;
  if constexpr (Degree < 2)
    return {x + (s_b * b.v - s_a * a.v),
            v,
            0.0,
            12 * u * (abs(x) + abs(s_a) * abs(a.v) + abs(s_b) * abs(b.v)) + underflow,
            u * abs(v) + underflow,
            0.0};
  const Real turn_a = s_a * a.a, turn_b = s_b * b.a, half = 0.5 * (b.a - a.a);
  return {x + (s_b * (b.v + 0.5 * turn_b) - s_a * (a.v + 0.5 * turn_a)),
          v + (turn_b - turn_a),
          half,
          12 * u * (abs(x) + abs(s_a) * (abs(a.v) + abs(turn_a)) + abs(s_b) * (abs(b.v) + abs(turn_b))) +
              underflow,
          12 * u * (abs(v) + abs(turn_a) + abs(turn_b)) + underflow,
          u * abs(half) + underflow};
}

/// The motion on one axis by powers of the time after tau. Requires: 0 <= tau <= h.
template <int Degree, class Real>
[[gnu::always_inline]] inline CertainAxisMotion<Real> view_from(const CertainAxisMotion<Real>& r,
                                                                const Real& tau, const Real& underflow) {
  using std::abs;
  constexpr double u = unit_roundoff;
  if constexpr (Degree < 2)
    return {r.x + tau * r.v,
            r.v,
            0.0,
            r.ex + tau * r.ev + 4 * u * (abs(r.x) + tau * abs(r.v)) + underflow,
            r.ev,
            0.0};
  const Real turn = tau * r.a, reach = tau * (abs(r.v) + abs(turn));
  return {r.x + tau * (r.v + turn),
          r.v + 2 * turn,
          r.a,
          r.ex + tau * (r.ev + tau * r.ea) + 5 * u * (abs(r.x) + reach) + underflow,
          r.ev + 2 * tau * r.ea + 4 * u * (abs(r.v) + 2 * abs(turn)) + underflow,
          r.ea};
}

/// The motion on all axes by powers of the time after tau.
template <int Degree, int D, class Real>
CertainMotion<D, Real> view_from(const CertainMotion<D, Real>& r, const Real& tau) {
  CertainMotion<D, Real> view{{}, r.underflow};
  for (int j = 0; j < D; ++j) view.axis[j] = view_from<Degree>(r.axis[j], tau, r.underflow);
  return view;
}

}  // namespace foresee
