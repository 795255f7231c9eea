// How does an object move? The laws of motion, each a motion of constant acceleration or simpler.
#pragma once

#include <cstdint>

namespace foresee {

/// How an object moves; each law adds columns to the one before.
enum class Law : std::uint8_t {
  rest,         ///< x
  uniform,      ///< x, v
  accelerated,  ///< x, v, a
  forced,       ///< x, v, force and mass: a = F/m, rounded once, computed when read
};

/// Of the centre's motion as a polynomial of time, and so of the relative motion of two that move by this
/// law.
constexpr int degree_of(Law law) {
  return law == Law::rest ? 0 : law == Law::uniform ? 1 : 2;
}

/// Motion on one axis as of a reference time. Real: double, or several objects at once (base/doubles.h). Without Eigen:
/// kernels include this.
template <class Real>
struct AxisMotion {
  Real x, v, a;
};

}  // namespace foresee
