// An upright cylinder, of three axes only: a radius r in x and y, a half height hz, or neither at first where
// it grows.
#pragma once

#include "shape/ball.h"

namespace foresee {

struct CylinderShape {
  static constexpr Shape shape = Shape::cylinder;
  static constexpr SizeColumn sizes[] = {radius_column, half_height_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return upright<D>(value_or(numbers, at.r, 0), value_or(numbers, at.hz, 0));
  }
  template <int D>
  static Extents<D> core(const double* numbers, const Offsets& at) {
    return upright<D>(value_or(numbers, at.r, 0) * inscribed[2], value_or(numbers, at.hz, 0));
  }

 private:
  template <int D>
  static Extents<D> upright(double radius, double half_height) {
    Vec<D> half = Vec<D>::Constant(radius);
    half[D - 1] = half_height;
    return symmetric<D>(half);
  }
};

}  // namespace foresee
