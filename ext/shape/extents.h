// How far does an object reach around its position, and what of it is filled for certain? The box of its
// shape, and a box within.
#pragma once

#include "motion/box.h"
#include "shape/bodies.h"

namespace foresee {

/// Half extents of the smallest box along the axes around an object's shape.
template <int D>
Vec<D> half_extents_of(const Bodies& bodies, std::size_t i) {
  const double* row = bodies.row(i);
  switch (bodies.layout.shape) {
    case Shape::box:
      return Eigen::Map<const Vec<D>>(row + bodies.at.half);
    case Shape::ball:
      return Vec<D>::Constant(row[bodies.at.r]);
    case Shape::cylinder: {
      Vec<D> half = Vec<D>::Constant(row[bodies.at.r]);
      half[D - 1] = row[bodies.at.hz];
      return half;
    }
    case Shape::point:
      break;
  }
  return Vec<D>::Zero();
}

/// Half extents of a box within an object's shape.
template <int D>
Vec<D> inner_half_extents_of(const Bodies& bodies, std::size_t i) {
  constexpr double below_root[] = {1, 1, 0.7071, 0.5773};  // of 1/axes
  const Vec<D> half = half_extents_of<D>(bodies, i);
  if (bodies.layout.shape == Shape::ball) return half * below_root[D];
  if (bodies.layout.shape != Shape::cylinder) return half;
  Vec<D> inner = half * below_root[2];
  inner[D - 1] = half[D - 1];
  return inner;
}

}  // namespace foresee
