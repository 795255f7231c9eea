// The motion of one object, and the time interval (horizon) of a query.
//
// At time s the centre is x + v (s - t) + a (s - t)^2 / 2 on each axis (eq. 1 of the GPCD paper); the object
// exists during the closed interval [t, until].
#pragma once

#include <cstdint>

#include "motion/vec.h"

namespace foresee {

/// How an object moves; each law adds columns to the one before.
enum class Law : std::uint8_t {
  rest,         ///< x
  uniform,      ///< x, v
  accelerated,  ///< x, v, a
  forced,       ///< x, v, force and mass: a = F/m, rounded once, computed when read
};

/// The degree of the centre's motion as a polynomial in time; the relative motion of two objects of this law
/// has it too.
constexpr int degree_of(Law law) {
  return law == Law::rest ? 0 : law == Law::uniform ? 1 : 2;
}

/// Motion on one axis as of a reference time. Real: double, or several objects at once (base/doubles.h).
template <class Real>
struct AxisMotion {
  Real x, v, a;
};

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
