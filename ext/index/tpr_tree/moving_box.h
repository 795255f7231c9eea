// When can two boxes meet whose faces move? A moving box is what a question sees of bounds or of an object.
//
//   MovingBox<2> ship = moving_box(motion, half_extents, horizon, margin), zone = …;
//   TimeSpan when = shared_span(ship, zone);
//   if (narrow_to_contact(ship, zone, when)) …                // they may meet, during `when` only
//
// At tau seconds after `now` the faces are at lower + v_lower*tau and upper + v_upper*tau, for tau in `span`
// (the part of the horizon during which anything is there). Acceleration has become velocity: an arc that
// bends outward is replaced by its chord, one that bends inward by its tangent at `now`; both lie outside.
//
// Rounding. Faces are padded by 32 units in the last place of everything that went into them, movement over
// the horizon included. The tests below compute with plain doubles: differences, one product, one quotient,
// whose errors are some 4 units of the same magnitudes. So what can meet is never lost; what cannot may
// pass. A face without a bound is infinite and has velocity 0; finite faces and velocities stay within 1e300,
// so that no difference overflows.
#pragma once

#include <algorithm>

#include "index/tpr_tree/bounds.h"

namespace foresee {

/// Seconds after `now`.
struct TimeSpan {
  double begin = 0, end = 0;

  bool is_empty() const { return !(begin <= end); }
};

template <int D>
struct MovingBox {
  Vec<D> lower, upper, v_lower, v_upper;
  TimeSpan span;
};

/// The part of [0, h] between two moments, rounded outward.
inline TimeSpan span_between(double first, double last, const Horizon& horizon) {
  const double begin = first - horizon.now, end = last - horizon.now;
  return {std::max(0.0, begin - std::abs(begin) * rounding_pad),
          std::min(horizon.h, end < 0 ? end * (1 - rounding_pad) : end * (1 + rounding_pad))};
}

/// Bounds at the epoch `now`, as a moving box.
template <int D>
MovingBox<D> moving_box(const Bounds<D>& at_now, const TimeSpan& span, const Vec<D>& margin) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double duration = std::max(span.end, smallest_pad);
  MovingBox<D> box{at_now.x_lower, at_now.x_upper, at_now.v_lower, at_now.v_upper, span};
  auto settle = [&](Vec<D>& face, Vec<D>& velocity, const Vec<D>& acceleration) {
    const Vec<D> bend = acceleration.min(0.0) * (0.5 * duration);
    velocity = lower_end<D>(velocity + bend, (velocity.abs() - bend) * rounding_pad + smallest_pad);
    face = lower_end<D>(face - margin,
                        (face.abs() + margin + velocity.abs() * duration) * rounding_pad + smallest_pad);
    if ((face.min(velocity) >= -largest_bound).all()) return;
    face = (velocity >= -largest_bound).select(face, -infinity);
    velocity = (face >= -largest_bound).select(velocity, 0.0);
  };
  settle(box.lower, box.v_lower, at_now.a_lower);
  box.upper = -box.upper, box.v_upper = -box.v_upper;
  settle(box.upper, box.v_upper, -at_now.a_upper);
  box.upper = -box.upper, box.v_upper = -box.v_upper;
  return box;
}

/// An object as a moving box, grown by `margin` on both sides of every axis.
template <int D>
MovingBox<D> moving_box(const Motion<D>& motion, const Vec<D>& half_extents, const Horizon& horizon,
                        const Vec<D>& margin) {
  return moving_box<D>(bounds_at(motion, half_extents, horizon.now),
                       span_between(motion.t, motion.until, horizon), margin);
}

/// A window whose faces are at lower and upper at `now` and move along from then on; bounds may be infinite.
template <int D>
MovingBox<D> moving_window(const Vec<D>& lower, const Vec<D>& upper, const Vec<D>& velocity,
                           const Horizon& horizon) {
  const Bounds<D> window{lower, upper, velocity, velocity, Vec<D>::Zero(), Vec<D>::Zero()};
  return moving_box<D>(window, TimeSpan{0, horizon.h}, Vec<D>::Zero());
}

template <int D>
TimeSpan shared_span(const MovingBox<D>& a, const MovingBox<D>& b) {
  return {std::max(a.span.begin, b.span.begin), std::min(a.span.end, b.span.end)};
}

/// Narrows `span` to the moments at which gap + speed * tau <= 0; false if there are none.
inline bool narrow_to_closed(double gap, double speed, TimeSpan& span) {
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

/// Narrows `span` to moments outside which the boxes do not meet; false if there are none. Touching counts.
template <int D>
bool narrow_to_contact(const MovingBox<D>& a, const MovingBox<D>& b, TimeSpan& span) {
  for (int axis = 0; axis < D; ++axis) {
    if (!narrow_to_closed(a.lower[axis] - b.upper[axis], a.v_lower[axis] - b.v_upper[axis], span))
      return false;
    if (!narrow_to_closed(b.lower[axis] - a.upper[axis], b.v_lower[axis] - a.v_upper[axis], span))
      return false;
  }
  return !span.is_empty();
}

}  // namespace foresee
