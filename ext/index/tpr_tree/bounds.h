// Bounds that move: between which motions does everything beneath an entry lie?
//
//   Bounds<2> around = Bounds<2>::nothing();
//   around.include(bounds_at(motion, extents, epoch));    // for every object
//   around = carried(around, epoch, later);                    // the same motions, seen from another moment
//
// Bounds are a box in the space of motions (Saltenis et al. 2000, with acceleration added): position,
// velocity and acceleration at an epoch, each between a lower and an upper end. At s seconds after the epoch
// a lower face is at x_lower + v_lower*s + a_lower*s²/2; before the epoch (s < 0) the velocity's ends
// change places: v_upper takes the part of v_lower. Both hold because x, v and a of every object lie inside.
//
// Rounding. Every operation here is exact or rounds outward, so nothing is ever lost: x_lower is at most the
// real lower face of the shape at the epoch, v_lower and a_lower at most the real velocity and acceleration.
// The error of x + v*s + a*s²/2 is below 8 units of 2^-53 times M = |x| + |v*s| + |a|*s²/2 (s is one rounded
// difference; there are 3 sums and 3 products), and padding by 32 such units leaves room for the rounding of
// M and of the padding itself. Products that underflow err by less than 2^-1023; `smallest_pad` covers them.
// What is beyond 1e300, overflows or is not a number becomes infinite: no bound at all.
#pragma once

#include <limits>

#include "motion/box.h"
#include "motion/motion.h"

namespace foresee {

/// Relative and absolute padding, and the largest finite bound.
inline constexpr double rounding_pad = 0x1p-48;
inline constexpr double smallest_pad = 0x1p-1000;
inline constexpr double largest_bound = 1e300;

/// The lower end of a bound that was computed as `value` give or take `pad`.
template <int D>
Vec<D> lower_end(const Vec<D>& value, const Vec<D>& pad);
template <int D>
Vec<D> upper_end(const Vec<D>& value, const Vec<D>& pad);

template <int D>
struct Bounds {
  Vec<D> x_lower, x_upper, v_lower, v_upper, a_lower, a_upper;

  /// Contains no motion; include() makes it whatever is included first.
  static Bounds nothing() {
    const Vec<D> most = Vec<D>::Constant(std::numeric_limits<double>::infinity());
    return {most, -most, most, -most, most, -most};
  }

  /// Contains every motion.
  static Bounds everything() {
    const Bounds none = nothing();
    return {none.x_upper, none.x_lower, none.v_upper, none.v_lower, none.a_upper, none.a_lower};
  }

  void include(const Bounds& other) {
    x_lower = x_lower.min(other.x_lower), x_upper = x_upper.max(other.x_upper);
    v_lower = v_lower.min(other.v_lower), v_upper = v_upper.max(other.v_upper);
    a_lower = a_lower.min(other.a_lower), a_upper = a_upper.max(other.a_upper);
  }
  /// Requires: both hold for the same objects at the same epoch.
  void narrow_to(const Bounds& other) {
    x_lower = x_lower.max(other.x_lower), x_upper = x_upper.min(other.x_upper);
    v_lower = v_lower.max(other.v_lower), v_upper = v_upper.min(other.v_upper);
    a_lower = a_lower.max(other.a_lower), a_upper = a_upper.min(other.a_upper);
  }
  bool contains(const Bounds& other) const {
    return (x_lower <= other.x_lower && other.x_upper <= x_upper && v_lower <= other.v_lower &&
            other.v_upper <= v_upper && a_lower <= other.a_lower && other.a_upper <= a_upper)
        .all();
  }
  friend bool operator==(const Bounds& a, const Bounds& b) { return a.contains(b) && b.contains(a); }
};

/// Bounds of one object at `epoch`, padded outward by `pad` times the magnitudes that went in.
template <int D>
Bounds<D> bounds_at(const Motion<D>& motion, const Extents<D>& extents, double epoch,
                    double pad = rounding_pad);

/// The same bounds of what grows by `growth` in a unit of time, on every side, and has done so for `age`. Its
/// lower faces move as objects would that are slower by that, its upper ones as faster ones. Before its time
/// it has the size of its t.
template <int D>
Bounds<D> with_growth(const Bounds<D>& bounds, const Vec<D>& growth, double age, double pad = rounding_pad);

/// Bounds at the epoch `to` of whatever lies within `bounds` at the epoch `from`.
template <int D>
Bounds<D> carried(const Bounds<D>& bounds, double from, double to);

}  // namespace foresee
