#include "index/tpr_tree/bounds.h"

#include <algorithm>

namespace foresee {

template <int D>
Vec<D> unbounded_lower_end(const Vec<D>& end) {
  return (end >= -largest_bound).select(end, -std::numeric_limits<double>::infinity()).min(largest_bound);
}

namespace {

/// A lower face carried by s seconds; the upper face is its mirror image.
template <int D>
struct CarriedFace {
  Vec<D> x, v;

  /// `v_before` is the end of the velocity that applies for s < 0; `a_before` likewise.
  CarriedFace(const Vec<D>& x0, const Vec<D>& v0, const Vec<D>& v_before, const Vec<D>& a0,
              const Vec<D>& a_before, double s) {
    const Vec<D> by_velocity = (s < 0 ? v_before : v0) * s, by_acceleration = a0 * s * s * 0.5;
    const Vec<D> gained = (s < 0 ? a_before : a0) * s;
    x = lower_end<D>(x0 + by_velocity + by_acceleration,
                     (x0.abs() + by_velocity.abs() + by_acceleration.abs()) * rounding_pad + smallest_pad);
    v = lower_end<D>(v0 + gained, (v0.abs() + gained.abs()) * rounding_pad + smallest_pad);
  }
};

/// These bounds, with no end beyond largest_bound.
template <int D>
Bounds<D> limited(const Bounds<D>& ends) {
  const auto lower = [](const Vec<D>& end) { return lower_end<D>(end, Vec<D>::zero()); };
  return {lower(ends.x_lower),   -lower(-ends.x_upper), lower(ends.v_lower),
          -lower(-ends.v_upper), lower(ends.a_lower),   -lower(-ends.a_upper)};
}

}  // namespace

template <int D>
Bounds<D> bounds_at(const Motion<D>& motion, const Extents<D>& extents, double epoch, double pad) {
  const double s = epoch - motion.t;
  const Vec<D> by_velocity = motion.v * s, gained = motion.a * s, by_acceleration = gained * s * 0.5;
  const Vec<D> centre = motion.x + by_velocity + by_acceleration, velocity = motion.v + gained;
  const double absolute_pad = pad > 0 ? smallest_pad : 0;
  const Vec<D> x_pad =
      (motion.x.abs() + by_velocity.abs() + by_acceleration.abs() + reach_of(extents)) * pad + absolute_pad;
  const Vec<D> v_pad = (motion.v.abs() + gained.abs()) * pad + absolute_pad;
  // As lower_end() and upper_end() compute them.
  const Bounds<D> ends{centre + extents.lower - x_pad,
                       -(-(centre + extents.upper) - x_pad),
                       velocity - v_pad,
                       -(-velocity - v_pad),
                       motion.a,
                       motion.a};
  // One sum shows the size of all ends, and passes infinity and NaN on.
  const Vec<D> sizes =
      ends.x_lower.abs() + ends.x_upper.abs() + ends.v_lower.abs() + ends.v_upper.abs() + motion.a.abs();
  return (sizes <= largest_bound).all() ? ends : limited(ends);
}

template <int D>
Bounds<D> with_growth(const Bounds<D>& bounds, const Vec<D>& growth, double age, double pad) {
  const double absolute_pad = pad > 0 ? smallest_pad : 0;
  const Vec<D> more = growth * std::max(age, 0.0);
  const auto padding = [&](const Vec<D>& end, const Vec<D>& grown) {
    return end.is_finite().select((end.abs() + grown) * pad + absolute_pad, 0);
  };
  return {lower_end<D>(bounds.x_lower - more, padding(bounds.x_lower, more)),
          upper_end<D>(bounds.x_upper + more, padding(bounds.x_upper, more)),
          lower_end<D>(bounds.v_lower - growth, padding(bounds.v_lower, growth)),
          upper_end<D>(bounds.v_upper + growth, padding(bounds.v_upper, growth)),
          bounds.a_lower,
          bounds.a_upper};
}

template <int D>
Bounds<D> carried(const Bounds<D>& bounds, double from, double to) {
  if (from == to) return bounds;
  const double s = to - from;
  const CarriedFace<D> lower(bounds.x_lower, bounds.v_lower, bounds.v_upper, bounds.a_lower, bounds.a_upper,
                             s);
  const CarriedFace<D> upper(-bounds.x_upper, -bounds.v_upper, -bounds.v_lower, -bounds.a_upper,
                             -bounds.a_lower, s);
  return {lower.x, -upper.x, lower.v, -upper.v, bounds.a_lower, bounds.a_upper};
}

#define FORESEE_OF_AXES(D)                                                           \
  template Vec<D> unbounded_lower_end<D>(const Vec<D>&);                             \
  template Bounds<D> bounds_at(const Motion<D>&, const Extents<D>&, double, double); \
  template Bounds<D> with_growth(const Bounds<D>&, const Vec<D>&, double, double);   \
  template Bounds<D> carried(const Bounds<D>&, double, double)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
