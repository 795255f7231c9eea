#include "index/tpr_tree/moving_box.h"

namespace foresee::index {
namespace {

/// Pads faces that are computed from numbers whose magnitudes add up to `size`.
template <int D>
void pad_outward(MovingBox<D>& box, const Vec<D>& size) {
  const Vec<D> pad = size * rounding_pad + smallest_pad;
  box.lower -= pad, box.upper += pad;
  const Eigen::Array<bool, D, 1> bounded =
      size <= largest_bound && box.v_lower.abs() <= largest_bound && box.v_upper.abs() <= largest_bound;
  if (bounded.all()) return;  // as good as always
  const double infinity = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < D; ++axis)
    if (!bounded[axis])
      box.lower[axis] = -infinity, box.upper[axis] = infinity, box.v_lower[axis] = box.v_upper[axis] = 0;
}

}  // namespace

template <int D>
MovingBox<D> moving_box(const Bounds<D>& bounds, double epoch, const TimeSpan& span, const Horizon& horizon) {
  const double s = horizon.now - epoch, duration = std::max(span.end, 0.0);
  const double reach = std::abs(s) + duration + shortest_reach;
  const double half_s = 0.5 * s, half_duration = 0.5 * duration, eighth = 0.125 * duration;
  const bool before = s < 0;  // then the ends of velocity and acceleration change places (bounds.h)
  const Vec<D>&v_lower = before ? bounds.v_upper : bounds.v_lower,
        &v_upper = before ? bounds.v_lower : bounds.v_upper,
        &a_lower = before ? bounds.a_upper : bounds.a_lower,
        &a_upper = before ? bounds.a_lower : bounds.a_upper;
  MovingBox<D> box;
  box.span = span;
  box.lower = bounds.x_lower + s * (v_lower + half_s * bounds.a_lower) -
              eighth * (duration * bounds.a_lower.max(0.0));
  box.upper = bounds.x_upper + s * (v_upper + half_s * bounds.a_upper) -
              eighth * (duration * bounds.a_upper.min(0.0));
  box.v_lower = bounds.v_lower + s * a_lower + half_duration * bounds.a_lower;
  box.v_upper = bounds.v_upper + s * a_upper + half_duration * bounds.a_upper;
  pad_outward<D>(box, bounds.x_lower.abs() + bounds.x_upper.abs() +
                          reach * (bounds.v_lower.abs() + bounds.v_upper.abs() +
                                   (0.5 * reach) * (bounds.a_lower.abs() + bounds.a_upper.abs())));
  return box;
}

template <int D>
MovingBox<D> moving_box(const Motion<D>& motion, const Extents<D>& extents, const Horizon& horizon,
                        const Vec<D>& margin) {
  const TimeSpan span = span_between(motion.t, motion.until, horizon);
  const double s = horizon.now - motion.t, duration = std::max(span.end, 0.0);
  const double reach = std::abs(s) + duration + shortest_reach;
  const Vec<D> centre = motion.x + s * (motion.v + (0.5 * s) * motion.a);
  const Vec<D> below = margin - extents.lower, above = margin + extents.upper;
  const double eighth = 0.125 * duration;  // its square may overflow where there is no acceleration
  MovingBox<D> box;
  box.span = span;
  box.lower = centre - (below + eighth * (duration * motion.a.max(0.0)));
  box.upper = centre + (above - eighth * (duration * motion.a.min(0.0)));
  box.v_lower = box.v_upper = motion.v + (s + 0.5 * duration) * motion.a;
  pad_outward<D>(box, motion.x.abs() + reach_of(extents) + margin +
                          reach * (motion.v.abs() + (0.5 * reach) * motion.a.abs()));
  return box;
}

template <int D>
MovingBox<D> moving_window(const Vec<D>& lower, const Vec<D>& upper, const Vec<D>& velocity,
                           const Horizon& horizon) {
  const double infinity = std::numeric_limits<double>::infinity(), reach = horizon.h + shortest_reach;
  MovingBox<D> box{lower, upper, velocity, velocity, {0, horizon.h}};
  auto round_outward = [&](Vec<D>& face, Vec<D>& speed) {
    face = lower_end<D>(face, (face.abs() + speed.abs() * reach) * rounding_pad + smallest_pad);
    speed = (face >= -largest_bound).select(speed, 0.0);
    face = (speed.abs() * std::max(1.0, reach) <= largest_bound).select(face, -infinity);
    speed = (face >= -largest_bound).select(speed, 0.0);
  };
  round_outward(box.lower, box.v_lower);
  box.upper = -box.upper, box.v_upper = -box.v_upper;
  round_outward(box.upper, box.v_upper);
  box.upper = -box.upper, box.v_upper = -box.v_upper;
  return box;
}

template MovingBox<1> moving_box(const Bounds<1>&, double, const TimeSpan&, const Horizon&);
template MovingBox<1> moving_box(const Motion<1>&, const Extents<1>&, const Horizon&, const Vec<1>&);
template MovingBox<1> moving_window(const Vec<1>&, const Vec<1>&, const Vec<1>&, const Horizon&);
template MovingBox<2> moving_box(const Bounds<2>&, double, const TimeSpan&, const Horizon&);
template MovingBox<2> moving_box(const Motion<2>&, const Extents<2>&, const Horizon&, const Vec<2>&);
template MovingBox<2> moving_window(const Vec<2>&, const Vec<2>&, const Vec<2>&, const Horizon&);
template MovingBox<3> moving_box(const Bounds<3>&, double, const TimeSpan&, const Horizon&);
template MovingBox<3> moving_box(const Motion<3>&, const Extents<3>&, const Horizon&, const Vec<3>&);
template MovingBox<3> moving_window(const Vec<3>&, const Vec<3>&, const Vec<3>&, const Horizon&);

}  // namespace foresee::index
