// The interval Newton method: closing in on the one root that a polynomial has between two numbers, as far as
// the length of the numbers allows.
//
// The root lies within x - p(x) / p'([low, high]), which is rigorous and needs no signs at the new ends; it
// at least doubles the digits as soon as the slope has one sign. Until then the sign at x halves the
// interval, or halves its exponent: a root may be 2^-5000 away from 0. (R. Moore, "Interval Analysis", 1966,
// chapter 7.)
#pragma once

#include <algorithm>

#include "numbers/coefficients.h"
#include "numbers/midrad.h"

namespace foresee {

inline Midrad128 number(const Midrad128& x, int /*bits*/) {
  return x;
}
inline Midrad number(const Dyadic& x, int bits) {
  return {x, bits};
}
/// About x, to a few digits more than those in which numbers so far apart differ: short factors multiply
/// faster.
inline Midrad128 shortened(const Midrad128& x, const Midrad128& /*apart*/) {
  return x.middle();
}
inline Dyadic shortened(const Dyadic& x, const Dyadic& apart) {
  constexpr int more = 8;
  return Midrad(x, std::max(0, x.magnitude() - apart.magnitude()) + more).middle();
}
inline Midrad128 hull(const Midrad128& low, const Midrad128& high, int /*bits*/) {
  return Midrad128::hull(low, high);
}
inline Midrad hull(const Dyadic& low, const Dyadic& high, int bits) {
  return Midrad::hull(low, high, bits);
}

template <class N>
N value_at(const Coefficients<N>& p, int degree, const N& x) {
  if (degree < 0) return {};
  N value = p[degree];
  for (int k = degree - 1; k >= 0; --k) value = value * x + p[k];
  return value;
}

/// The same polynomial by powers of the distance from x.
template <class N>
Coefficients<N> around(Coefficients<N> p, int degree, const N& x) {
  for (int k = 0; k < degree; ++k)
    for (int i = degree - 1; i >= k; --i) p[i] = p[i] + x * p[i + 1];
  return p;
}

/// N is Midrad128 or Midrad; ends are exact numbers.
template <class N>
class IntervalNewton {
 public:
  using End = decltype(N().low());

  /// The polynomial has one root in [low, high], at which its sign changes from `sign_low`.
  /// Requires: 0 <= low.
  IntervalNewton(const Coefficients<N>& p, int degree, const End& low, const End& high, int sign_low,
                 int bits)
      : low(low), high(high), p_(p), degree_(degree), bits_(bits), sign_low_(sign_low) {
    while (closer()) {
    }
  }

  End low, high;

 private:
  /// Halves the bracket at least; false if that is all.
  bool closer() {
    const End width = high - low;
    const N x = number(shortened(between(), width), bits_);
    const End place = x.middle();
    if (!less(low, place) || !less(place, high)) return false;
    // From x the slope is bounded far better than from 0, where almost all cancels.
    const N rest = hull(low, high, bits_) - x;
    const Coefficients<N> d = around(p_, degree_, x);
    const N slope = d[1] + rest * (d[2].scaled(1) + rest * (d[3] * three_ + rest * d[4].scaled(2)));
    const int sign = d[0].sign(), slope_sign = slope.sign();
    if (sign == 0) {
      low = high = place;
      return false;
    }
    if (sign != unknown_sign) (sign == sign_low_ ? low : high) = place;
    if (slope_sign != 0 && slope_sign != unknown_sign) {
      const N root = x - d[0] / slope;
      const End left = root.low(), right = root.high();
      if (less(low, left)) low = left;
      if (less(right, high)) high = right;
    }
    if (less(high - low, high.scaled(lost_digits - bits_))) return false;
    return sign != unknown_sign || less(high - low, width.scaled(-1));
  }

  /// The middle, or that of the exponents where these are far apart.
  End between() {
    if (low.sign() == 0) return high.scaled(-(1 << std::min(round_++, 12)));
    const int least = low.magnitude(), most = high.magnitude();
    if (most - least >= 2) return End(1.0).scaled(least + (most - least + 1) / 2);
    return half_of(low + high);
  }

  static bool less(const End& a, const End& b) { return (b - a).sign() == 1; }

  static constexpr int lost_digits = 16;  ///< about as many as a step may lose

  const Coefficients<N>& p_;
  N three_ = number(End(3.0), 2);
  int degree_, bits_, sign_low_;
  int round_ = 0;
};

}  // namespace foresee
