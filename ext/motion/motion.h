// One object's motion, and the moments that a question asks about.
//
// At time s the centre is x + v (s - t) + a (s - t)^2 / 2 on each axis (eq. 1 of the GPCD paper); the object
// exists during the closed span [t, until].
#pragma once

#include <Eigen/Core>

#include "motion/law.h"

namespace foresee {

// Vectors of one to three axes, in the scene's own unit of length.

/// An array, not a vector in Eigen's sense: `*`, `<` and `max` go axis by axis, as boxes need.
template <int D>
using Vec = Eigen::Array<double, D, 1>;

/// The moments that a question asks about: the closed interval [now, now + h], its end being the exact real
/// sum. Requires: now finite; h finite and >= 0.
struct Horizon {
  double now = 0;
  double h = 0;
};

/// One object's motion as numbers of its own: what is not declared is at rest, from time 0, for ever.
template <int D>
struct Motion {
  double t;
  Vec<D> x, v, a;
  double until;
};

}  // namespace foresee
