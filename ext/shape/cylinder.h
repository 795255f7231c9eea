// An upright cylinder, of three axes only: a radius r in x and y, a half height hz.
#pragma once

#include "shape/ball.h"

namespace foresee::shape {

struct CylinderShape {
  static constexpr Shape shape = Shape::cylinder;
  static constexpr SizeColumn sizes[] = {radius_column, half_height_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return upright<D>(numbers[at.r], numbers[at.hz]);
  }
  template <int D>
  static Extents<D> core(const double* numbers, const Offsets& at) {
    return upright<D>(numbers[at.r] * inscribed[2], numbers[at.hz]);
  }

 private:
  template <int D>
  static Extents<D> upright(double radius, double half_height) {
    Vec<D> half = Vec<D>::Constant(radius);
    half[D - 1] = half_height;
    return symmetric<D>(half);
  }
};

}  // namespace foresee::shape
