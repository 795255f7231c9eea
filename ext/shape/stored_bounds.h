// Which box is around a shape of which a row knows the bounds? They are those of the outline or mesh as it
// lies, not yet grown by r.
//
//   extents_of_bounds<3, 2>(row, at)          // x and y of an outline that is a prism; along z none
//
// Extents reach to the position too, which may lie outside: so they are of use for questions about positions.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/box.h"
#include "shape/layout.h"

namespace foresee {

/// The sum, and what rounding may have lost of it.
inline double sum_outward(double bound, double more) {
  if (more == 0) return bound;
  const double sum = bound + more;
  return sum + std::copysign(std::abs(sum) * 0x1p-52, more);
}

/// `Bounded`: in how many axes the shape has bounds.
template <int D, int Bounded>
Extents<D> extents_of_bounds(const double* numbers, const Offsets& at) {
  Extents<D> around = Extents<D>::none();
  const double r = value_or(numbers, at.r, 0);
  for (int axis = 0; axis < std::min(D, Bounded); ++axis) {
    around.lower[axis] = std::min(0.0, sum_outward(numbers[at.bounds + axis], -r));
    around.upper[axis] = std::max(0.0, sum_outward(numbers[at.bounds + Bounded + axis], r));
  }
  return around;
}

/// Those of a box in which nothing is.
template <int D>
Extents<D> no_extents() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {Vec<D>::Constant(inf), Vec<D>::Constant(-inf)};
}

}  // namespace foresee
