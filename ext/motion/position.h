// Where is an object at a moment, how fast does it move there, and does it exist then?
//
//   const Motion<2> ship = …;                        // of a row: motion_of() in shape/bodies.h
//   if (exists_at(ship, 700)) use(state_at(ship, 700).x);
//
// Existence is exact: an object exists during the closed span [t, until]. Position and velocity are computed
// in double with the time since t carried exactly, so that a few units in the last place of the largest term
// are all they can be off; they are infinite where no double holds them.
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

/// Requires: moment finite. Any moment is answered, also one at which the object does not exist.
template <int D>
State<D> state_at(const Motion<D>& motion, double time);

}  // namespace foresee
