// A point: no size.
#pragma once

#include <span>

#include "motion/box.h"
#include "shape/size_column.h"

namespace foresee {

struct PointShape {
  static constexpr Shape shape = Shape::point;
  static constexpr std::span<const SizeColumn> sizes = {};

  template <int D>
  static Extents<D> extents(const double* /*numbers*/, const Offsets& /*at*/) {
    return Extents<D>::none();
  }
  template <int D>
  static Extents<D> core(const double* numbers, const Offsets& at) {
    return extents<D>(numbers, at);
  }
};

}  // namespace foresee
