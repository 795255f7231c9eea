// Laws of motion: at rest, uniform, uniformly accelerated, or driven by a force.
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

/// The degree of the centre's motion as a polynomial in time; the relative motion of two objects of this law
/// has it too.
constexpr int degree_of(Law law) {
  return law == Law::rest ? 0 : law == Law::uniform ? 1 : 2;
}

/// Motion on one axis as of a reference time. Real: double, or several objects at once (base/doubles.h).
/// Without Eigen: kernels include this.
template <class Real>
struct AxisMotion {
  Real x, v, a;
};

}  // namespace foresee
