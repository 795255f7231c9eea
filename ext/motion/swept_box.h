// Where can a moving box be during the horizon? The smallest box we can vouch for: it contains the moving one
// at every moment of [now, now + h] at which its motion holds, turning points of accelerated motion included
// (GPCD step 1).
//
// Bounds are rounded outward, so an index that compares swept boxes never loses a pair. A motion that does
// not hold during the horizon has the empty box (lower = +inf, upper = -inf), which meets nothing. Bounds
// that no double holds are infinite. Cost: some tens of flops per axis.
#pragma once

#include "motion/box.h"
#include "motion/life_interval.h"

namespace foresee {

/// What the position covers on one axis, x + v s + a s^2 / 2 for the time s of `life`, grown by what lies
/// below and above it.
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

/// A box that lies within what moves at the moment `now`, where `inner` lies within its shape: what is in it
/// touches the object. Empty where the motion does not hold then, and where no double vouches for one.
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
