// A box along the axes: half extents hx, hy, hz.
#pragma once

#include "motion/box.h"
#include "shape/size_column.h"

namespace foresee {

struct BoxShape {
  static constexpr Shape shape = Shape::box;
  static constexpr SizeColumn sizes[] = {half_extent_columns};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return symmetric<D>(Eigen::Map<const Vec<D>>(numbers + at.half));
  }
  template <int D>
  static Extents<D> core(const double* numbers, const Offsets& at) {
    return extents<D>(numbers, at);
  }
};

}  // namespace foresee
