// Time-parameterized bounds of a TPR-tree: intervals of position, velocity and acceleration around many
// motions.
//
//   Bounds<2> around = Bounds<2>::nothing();
//   around.include(bounds_at(motion, extents, epoch));    // for every object
//   around = carried(around, epoch, later);                    // the same motions, at another epoch
//
// Bounds are a box in the space of motions (Saltenis et al. 2000, with acceleration added). Position,
// velocity and acceleration at an epoch each have a lower and an upper end. At s seconds after the epoch a
// lower face is at x_lower + v_lower*s + a_lower*s²/2. Before the epoch (s < 0) the ends of the velocity
// change places: v_upper replaces v_lower. Both hold because x, v and a of every object are inside the
// bounds.
//
// Rounding. Every operation here is exact or rounds outward, so bounds never lose an object. x_lower is at
// most the real lower face of the shape at the epoch; v_lower and a_lower are at most the real velocity and
// acceleration. Let M = |x| + |v*s| + |a|*s²/2. The error of x + v*s + a*s²/2 is below 8 units of 2^-53 times
// M: s is one rounded difference, and there are 3 sums and 3 products. Padding by 32 such units also covers
// the rounding of M and of the padding itself. Products that underflow err by less than 2^-1023;
// `smallest_pad` covers them. A number beyond 1e300, infinite or NaN becomes infinite: no bound.
#pragma once

#include <limits>

#include "motion/axis_aligned_box.h"
#include "motion/motion.h"

namespace foresee {

/// Relative and absolute padding, and the largest finite bound.
inline constexpr double rounding_pad = 0x1p-48;
inline constexpr double smallest_pad = 0x1p-1000;
inline constexpr double largest_bound = 1e300;

/// lower_end() where the computed end exceeds largest_bound on an axis: unbounded below, or largest_bound.
template <int D>
Vec<D> unbounded_lower_end(const Vec<D>& end);

/// The lower end of a bound whose computed value is `value` ± `pad`.
template <int D>
inline Vec<D> lower_end(const Vec<D>& value, const Vec<D>& pad) {
  const Vec<D> end = value - pad;
  return (end.abs() <= largest_bound).all() ? end : unbounded_lower_end(end);
}
template <int D>
inline Vec<D> upper_end(const Vec<D>& value, const Vec<D>& pad) {
  return -lower_end<D>(-value, pad);
}

template <int D>
struct Bounds {
  Vec<D> x_lower, x_upper, v_lower, v_upper, a_lower, a_upper;

  /// Contains no motion; after include() it equals the included bounds.
  static Bounds nothing() {
    const Vec<D> infinity = Vec<D>::constant(std::numeric_limits<double>::infinity());
    return {infinity, -infinity, infinity, -infinity, infinity, -infinity};
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
  /// Requires: both bounds contain the same objects at the same epoch.
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

/// Bounds of one object at `epoch`, padded outward by `pad` times the magnitudes of its terms.
template <int D>
Bounds<D> bounds_at(const Motion<D>& motion, const Extents<D>& extents, double epoch,
                    double pad = rounding_pad);

/// These bounds of an object, widened for its growth: by `growth` per unit of time on every side, for `age` so far. Its
/// lower faces move like objects slower by `growth`, its upper faces like faster ones. Before its
/// t an object has the size of its t.
template <int D>
Bounds<D> with_growth(const Bounds<D>& bounds, const Vec<D>& growth, double age, double pad = rounding_pad);

/// Bounds at the epoch `to` of all motions within `bounds` at the epoch `from`.
template <int D>
Bounds<D> carried(const Bounds<D>& bounds, double from, double to);

}  // namespace foresee
