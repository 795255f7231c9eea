// An interval, a disc or a ball, by the number of axes: a radius r, or none at first where it grows.
#pragma once

#include "motion/box.h"
#include "shape/size_column.h"

namespace foresee {

/// Half the side of a square or cube in a disc or ball of radius 1, by the number of axes; rounded down.
constexpr double inscribed[] = {1, 1, 0.7071, 0.5773};

struct BallShape {
  static constexpr Shape shape = Shape::ball;
  static constexpr SizeColumn sizes[] = {radius_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return symmetric<D>(Vec<D>::Constant(value_or(numbers, at.r, 0)));
  }
  template <int D>
  static Extents<D> core(const double* numbers, const Offsets& at) {
    return symmetric<D>(Vec<D>::Constant(value_or(numbers, at.r, 0) * inscribed[D]));
  }
};

}  // namespace foresee
