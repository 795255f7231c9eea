// Swept box: bounds of a moving box over the horizon, rounded outward (GPCD step 1).
//
// It contains the moving box at every time of [now, now + h] at which the motion exists, turning points of
// accelerated motion included. An index that compares swept boxes therefore never loses a pair. A motion that
// does not exist during the horizon has the empty box (lower = +inf, upper = -inf), which intersects no box.
// Bounds that no double holds are infinite. Cost: some tens of flops per axis.
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/axis_aligned_box.h"
#include "motion/motion.h"

namespace foresee {

// The part of a horizon during which an object exists.

/// The intersection of an object's [t, until] with the horizon, as time since t.
struct LifeInterval {
  double begin, end;
  double reach;  ///< upper bound of the distance in time between the object's t and any time of the horizon
  bool none;
};

inline LifeInterval life_of(double t, double until, const Horizon& horizon) {
  const double since = horizon.now - t;
  LifeInterval life;
  life.begin = std::max(since, 0.0);
  life.end = std::min(since + horizon.h, until - t);
  life.reach = std::abs(since) + horizon.h;
  // Rounding keeps order: if t - now, rounded, exceeds the double h, then so does the exact difference.
  life.none = t - horizon.now > horizon.h || until < horizon.now;
  return life;
}

/// The range of x + v s + a s^2 / 2 on one axis for all s of `life`, grown by `below` and `above`.
Ends swept_axis(double x, double v, double a, const LifeInterval& life, double below, double above);

template <int D>
Box<D> swept_box(const Motion<D>& motion, const Horizon& horizon, const Extents<D>& extents) {
  const LifeInterval life = life_of(motion.t, motion.until, horizon);
  if (life.none) return Box<D>::empty();
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    const Ends bounds = swept_axis(motion.x[axis], motion.v[axis], motion.a[axis], life, -extents.lower[axis],
                                   extents.upper[axis]);
    box.lower[axis] = bounds.lower, box.upper[axis] = bounds.upper;
  }
  return box;
}

/// The same for a box that also grows by `growth` (>= 0) per second since t, on every side: each face has a velocity
/// of its own, rounded outward.
template <int D>
Box<D> swept_box(const Motion<D>& motion, const Horizon& horizon, const Extents<D>& extents,
                 const Vec<D>& growth) {
  Motion<D> lower = motion, upper = motion;
  for (int axis = 0; axis < D; ++axis) {
    if (growth[axis] == 0) continue;
    lower.v[axis] = std::nextafter(motion.v[axis] - growth[axis], -HUGE_VAL);
    upper.v[axis] = std::nextafter(motion.v[axis] + growth[axis], HUGE_VAL);
  }
  return {swept_box<D>(lower, horizon, extents).lower, swept_box<D>(upper, horizon, extents).upper};
}

/// A box inside the object at time `now`, given that `inner` lies within its shape: every point of the box
/// touches the object. Empty if the motion does not exist then, or if rounding leaves no such box.
template <int D>
Box<D> core_box(const Motion<D>& motion, double now, const Extents<D>& inner) {
  constexpr double u = 0x1p-53;
  const LifeInterval life = life_of(motion.t, motion.until, {now, 0});
  if (life.none) return Box<D>::empty();
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    const Ends position = swept_axis(motion.x[axis], motion.v[axis], motion.a[axis], life, 0, 0);
    const double lower = position.upper + inner.lower[axis], upper = position.lower + inner.upper[axis];
    box.lower[axis] = lower + 4 * u * std::abs(lower);
    box.upper[axis] = upper - 4 * u * std::abs(upper);
    if (!std::isfinite(box.upper[axis] - box.lower[axis])) return Box<D>::empty();
  }
  return box.is_empty() ? Box<D>::empty() : box;
}

}  // namespace foresee
