// Position and velocity of an object at one time, and whether it exists then.
//
//   const Motion<2> ship = …;                        // of a row: motion_of() in shape/bodies.h
//   if (exists_at(ship, 700)) use(state_at(ship, 700).x);
//
// Existence is exact: an object exists during the closed interval [t, until]. Position and velocity are
// computed in double, but carry the time since t exactly. Their error is a few units in the last place of the
// largest term; they are infinite if no double holds them.
#pragma once

#include "motion/motion.h"

namespace foresee {

template <int D>
struct State {
  Vec<D> x, v;
};

template <int D>
bool exists_at(const Motion<D>& motion, double time) {
  return motion.t <= time && time <= motion.until;
}

/// Defined for any finite time, also one at which the object does not exist. Requires: time finite.
template <int D>
State<D> state_at(const Motion<D>& motion, double time);

}  // namespace foresee
