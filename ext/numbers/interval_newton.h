// Interval Newton method: narrows the bracket of a polynomial's only root as far as the number length allows.
//
// The root lies within x - p(x) / p'([low, high]), which is rigorous and needs no signs at the new ends. A
// step at least doubles the digits once the slope has one sign. Until then the sign at x halves the interval,
// or halves its exponent: a root may be as near to 0 as 2^-5000. (R. Moore, "Interval Analysis", 1966,
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
/// x, shortened to a few digits more than those in which numbers `apart` from each other differ: short
/// factors multiply faster.
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

/// The coefficients of the polynomial shifted to x, in powers of the distance from x.
template <class N>
Coefficients<N> around(Coefficients<N> p, int degree, const N& x) {
  for (int k = 0; k < degree; ++k)
    for (int i = degree - 1; i >= k; --i) p[i] = p[i] + x * p[i + 1];
  return p;
}

/// N: Midrad128 or Midrad. The ends of the bracket are exact numbers.
template <class N>
class IntervalNewton {
 public:
  using End = decltype(N().low());

  /// Requires: 0 <= low; the polynomial has one root in [low, high], at which its sign changes from
  /// `sign_low`.
  IntervalNewton(const Coefficients<N>& p, int degree, const End& low, const End& high, int sign_low,
                 int bits)
      : low(low), high(high), p_(p), degree_(degree), bits_(bits), sign_low_(sign_low) {
    while (closer()) {
    }
  }

  End low, high;

 private:
  /// Does one step; false if it does not at least halve the bracket.
  bool closer() {
    const End width = high - low;
    const N x = number(shortened(between(), width), bits_);
    const End place = x.middle();
    if (!less(low, place) || !less(place, high)) return false;
    // Expanded around x, the slope has a far better bound than around 0, where almost all terms cancel.
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

  /// The midpoint, or the power of two at the midpoint of the exponents if these are far apart.
  End between() {
    if (low.sign() == 0) return high.scaled(-(1 << std::min(round_++, 12)));
    const int lowest = low.magnitude(), highest = high.magnitude();
    if (highest - lowest >= 2) return End(1.0).scaled(lowest + (highest - lowest + 1) / 2);
    return half_of(low + high);
  }

  static bool less(const End& a, const End& b) { return (b - a).sign() == 1; }

  static constexpr int lost_digits = 16;  ///< about as many bits as one step may lose

  const Coefficients<N>& p_;
  N three_ = number(End(3.0), 2);
  int degree_, bits_, sign_low_;
  int round_ = 0;
};

}  // namespace foresee
