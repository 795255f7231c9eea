// The motion of one object, and the time interval (horizon) of a query.
//
// At time s the centre is x + v (s - t) + a (s - t)^2 / 2 on each axis (eq. 1 of the GPCD paper); the object
// exists during the closed interval [t, until].
#pragma once

#include <Eigen/Core>
#include <array>

#include "motion/law.h"

namespace foresee {

// Vectors of one to three axes, in the scene's own unit of length.

/// An Eigen array, not a vector: `*`, `<` and `max` are element-wise, as boxes need.
template <int D>
using Vec = Eigen::Array<double, D, 1>;

/// The first D numbers; the others are those of axes that a scene does not have.
template <int D>
Vec<D> vector_of(const std::array<double, 3>& values) {
  return Eigen::Map<const Vec<D>>(values.data());
}

/// The closed time interval [now, now + h] of a query; its end is the exact real sum. Requires: now finite;
/// h finite and >= 0.
struct Horizon {
  double now = 0;
  double h = 0;
};

/// The motion of one object. Columns that are not declared have defaults: at rest, from time 0, unbounded.
template <int D>
struct Motion {
  double t;
  Vec<D> x, v, a;
  double until;
};

}  // namespace foresee
