// Moving boxes, whose faces move linearly during a horizon, and the time interval in which two of them can
// meet.
//
//   MovingBox<2> ship = moving_box(motion, extents, horizon, margin), zone = …;
//   SharedInterval when = shared_span(ship, zone);
//   if (narrow_to_contact(ship, zone, when)) …                // they may meet, during `when` only
//
// At tau seconds after `now` the faces are at lower + v_lower*tau and upper + v_upper*tau, for tau in `span`.
// That is the part of the horizon during which the object, or any object within the bounds, exists.
// Acceleration is folded into velocity: an arc is replaced by its chord over [0, span.end]. An arc that bends
// outward is padded by at most |a|*span.end²/8.
//
// Rounding. M, the sum of the magnitudes of all terms of a face over the whole span, bounds every
// intermediate result. The error of a face is less than 16 units of 2^-53 of M: 7 from the position at `now`,
// 5 from the chord, 4 from the sums. The tests below compute with plain doubles (differences, one product,
// one quotient), which adds about 4 units of the same magnitudes. So padding by 32 units of M loses no boxes
// that can meet; others may pass. A time below 2^-1022 s has an error of up to 2^-1075 s, however short the
// span is. M therefore includes 2^-1000 s more of every velocity. If M or a velocity is beyond 1e300,
// infinite or NaN, there is no bound: the faces are infinite and have velocity 0. Otherwise both are within
// 1e300, so no difference overflows.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/interval_tree.h"
#include "index/tpr_tree/bounds.h"
#include "shape/swept_boxes.h"

namespace foresee {

/// Added to time spans to bound their rounding errors.
inline constexpr double shortest_reach = 0x1p-1000;

/// An interval of seconds after `now`.
struct SharedInterval {
  double begin = 0, end = 0;

  bool is_empty() const { return !(begin <= end); }
};

template <int D>
struct MovingBox {
  Vec<D> lower, upper, v_lower, v_upper;
  SharedInterval span;
};

/// The spans of boxes, for those that exist together with another one.
template <int D>
IntervalTree spans_of(std::span<const MovingBox<D>> boxes) {
  std::vector<IntervalTree::Interval> spans;
  for (const MovingBox<D>& box : boxes) spans.push_back({box.span.begin, box.span.end});
  return IntervalTree(spans);
}

/// The part of [0, h] between two times, rounded outward.
inline SharedInterval span_between(double first, double last, const Horizon& horizon) {
  // A time before `now` remains before `now` however it is rounded.
  return {std::max(0.0, (first - horizon.now) * (1 - rounding_pad)),
          std::min(horizon.h, (last - horizon.now) * (1 + rounding_pad))};
}

/// Pads faces that are computed from numbers with a sum of magnitudes of `size`.
template <int D>
void pad_outward(MovingBox<D>& box, const Vec<D>& size) {
  const Vec<D> pad = size * rounding_pad + smallest_pad;
  box.lower -= pad, box.upper += pad;
  const VecMask<D> bounded =
      size <= largest_bound && box.v_lower.abs() <= largest_bound && box.v_upper.abs() <= largest_bound;
  if (bounded.all()) return;  // the usual case
  const double infinity = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < D; ++axis)
    if (!bounded[axis]) {
      box.lower[axis] = -infinity;
      box.upper[axis] = infinity;
      box.v_lower[axis] = box.v_upper[axis] = 0;
    }
}

/// The moving box of all motions within `bounds` at `epoch`. Inline, because a walk calls it for every entry.
template <int D>
MovingBox<D> moving_box(const Bounds<D>& bounds, double epoch, const SharedInterval& span,
                        const Horizon& horizon) {
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

/// The moving box of an object, grown by `margin` on both sides of every axis.
template <int D>
MovingBox<D> moving_box(const Motion<D>& motion, const Extents<D>& extents, const Horizon& horizon,
                        const Vec<D>& margin) {
  const SharedInterval span = span_between(motion.t, motion.until, horizon);
  const double s = horizon.now - motion.t, duration = std::max(span.end, 0.0);
  const double reach = std::abs(s) + duration + shortest_reach;
  const Vec<D> centre = motion.x + s * (motion.v + (0.5 * s) * motion.a);
  const Vec<D> below = margin - extents.lower, above = margin + extents.upper;
  const double eighth = 0.125 * duration;  // its square may overflow if there is no acceleration
  MovingBox<D> box;
  box.span = span;
  box.lower = centre - (below + eighth * (duration * motion.a.max(0.0)));
  box.upper = centre + (above - eighth * (duration * motion.a.min(0.0)));
  box.v_lower = box.v_upper = motion.v + (s + 0.5 * duration) * motion.a;
  pad_outward<D>(box, motion.x.abs() + reach_of(extents) + margin +
                          reach * (motion.v.abs() + (0.5 * reach) * motion.a.abs()));
  return box;
}

/// moving_box() of an object that grows by `growth` per unit of time, on every side, from `age` before now on.
/// Outside its span the box may have lower > upper.
template <int D>
MovingBox<D> with_growth(MovingBox<D> box, const Vec<D>& growth, double age) {
  const double reach = std::abs(age) + std::max(box.span.end, 0.0) + shortest_reach;
  const Vec<D> more = growth * age;
  box.lower -= more, box.upper += more;
  box.v_lower -= growth, box.v_upper += growth;
  pad_outward<D>(box, box.lower.abs().max(box.upper.abs()) +
                          reach * (growth + box.v_lower.abs().max(box.v_upper.abs())));
  return box;
}

/// moving_box() of object i of `bodies`, with its growth.
template <int D>
MovingBox<D> moving_box(const Bodies& bodies, std::size_t i, const Horizon& horizon, const Vec<D>& margin) {
  const Motion<D> motion = motion_of<D>(bodies, i);
  const MovingBox<D> box = moving_box<D>(motion, extents_of<D>(bodies, i), horizon, margin);
  if (!grows(bodies.layout)) return box;
  return with_growth<D>(box, growth_of<D>(bodies.layout.shape, bodies.row(i), bodies.at),
                        horizon.now - motion.t);
}

/// A window whose faces are at lower and upper at `now` and then move with `velocity`; faces may be infinite.
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

inline SharedInterval shared_span(const SharedInterval& a, const SharedInterval& b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}
template <int D>
SharedInterval shared_span(const MovingBox<D>& a, const MovingBox<D>& b) {
  return shared_span(a.span, b.span);
}

/// Narrows `span` to the times at which gap + speed * tau <= 0; false if no such time exists.
inline bool narrow_to_closed(double gap, double speed, SharedInterval& span) {
  const bool apart_first = gap + speed * span.begin > 0, apart_last = gap + speed * span.end > 0;
  if (!apart_first && !apart_last) return true;
  if (apart_first && apart_last) return false;
  const double meeting = -gap / speed;
  if (apart_first)
    span.begin = std::max(span.begin, meeting);
  else
    span.end = std::min(span.end, meeting);
  return true;
}

/// Narrows `span` to an interval outside which the boxes do not meet; false if they do not meet at all.
/// Touching boxes meet. Requires: the span is not empty.
template <int D>
bool narrow_to_contact(const MovingBox<D>& a, const MovingBox<D>& b, SharedInterval& span) {
  const Vec<D> left = a.lower - b.upper, right = b.lower - a.upper;
  const Vec<D> left_speed = a.v_lower - b.v_upper, right_speed = b.v_lower - a.v_upper;
  const Vec<D> left_first = left + left_speed * span.begin, left_last = left + left_speed * span.end,
               right_first = right + right_speed * span.begin, right_last = right + right_speed * span.end;
  // Most pairs are separated along one axis all the time, or overlap on all axes.
  if (left_first.min(left_last).max(right_first.min(right_last)).largest() > 0) return false;
  if (left_first.max(left_last).max(right_first.max(right_last)).largest() <= 0) return true;
  for (int axis = 0; axis < D; ++axis)
    if (!narrow_to_closed(left[axis], left_speed[axis], span) ||
        !narrow_to_closed(right[axis], right_speed[axis], span))
      return false;
  return !span.is_empty();
}

}  // namespace foresee
