// An outline of its own, flat, or the upright prism over it of half height hz; with r it is grown on all
// sides in x and y. What has no outline is what its other columns say: a point, a disc, or an upright
// cylinder.
//
// A row knows the number of its outline and the smallest box around it as it lies (outline/turn.h), so that
// who only needs boxes looks no outline up. Extents reach to the position too, which may lie outside: so they
// are of use for questions about positions.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/box.h"
#include "shape/size_column.h"

namespace foresee::shape {

struct OutlineShape {
  static constexpr Shape shape = Shape::outline;
  static constexpr SizeColumn sizes[] = {radius_column, half_height_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    Extents<D> around = Extents<D>::none();
    const double r = value_or(numbers, at.r, 0);
    for (int axis = 0; axis < std::min(D, 2); ++axis) {
      around.lower[axis] = std::min(0.0, outward(numbers[at.bounds + axis], -r));
      around.upper[axis] = std::max(0.0, outward(numbers[at.bounds + 2 + axis], r));
    }
    if constexpr (D == 3) around.lower[2] = -numbers[at.hz], around.upper[2] = numbers[at.hz];
    return around;
  }
  /// None: what lies within the box may lie in a hole.
  template <int D>
  static Extents<D> core(const double* /*numbers*/, const Offsets& /*at*/) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return {Vec<D>::Constant(inf), Vec<D>::Constant(-inf)};
  }

 private:
  /// The sum, and what rounding may have lost of it.
  static double outward(double bound, double more) {
    if (more == 0) return bound;
    const double sum = bound + more;
    return sum + std::copysign(std::abs(sum) * 0x1p-52, more);
  }
};

}  // namespace foresee::shape
