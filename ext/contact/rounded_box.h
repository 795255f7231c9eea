// A box grown by R in the Euclidean sense, as the union of simpler sets; each lies inside it, and together
// they are it: the box grown along one axis, for every axis; in three dimensions a cylinder around every
// edge; a ball around every corner. Box against ball or point, and the x-y part of box against cylinder.
#pragma once

#include "contact/certified.h"

namespace foresee {

/// The face of an axis on the side that bit `bit` of `signs` tells.
template <class T>
Centre<T> face_at(const T* half, int axis, unsigned signs, int bit) {
  if (signs >> bit & 1) return {axis, -half[axis], -1};
  return {axis, half[axis], 1};
}

/// Around the corner given by `signs` (bit j: the side of axis j), over the axes 0 .. N-1.
template <std::size_t N, class T>
std::array<Centre<T>, N> corner(const T* half, unsigned signs) {
  std::array<Centre<T>, N> centre;
  for (std::size_t j = 0; j < N; ++j)
    centre[j] = face_at(half, static_cast<int>(j), signs, static_cast<int>(j));
  return centre;
}

template <class T, class Visitor>
auto visit_rounded_rectangle(const T* half, const T& radius, Visitor& v) {
  const T wide_x = half[0] + radius, wide_y = half[1] + radius;
  auto flat =
      v.any(v.all(v.slab(0, wide_x), v.slab(1, half[1])), v.all(v.slab(0, half[0]), v.slab(1, wide_y)));
  for (unsigned signs = 0; signs < 4; ++signs) flat = v.any(flat, v.ball(corner<2>(half, signs), radius));
  return flat;
}

template <class T, class Visitor>
auto visit_rounded_cuboid(const T* half, const T& radius, Visitor& v) {
  auto grown_along = [&](int axis) {
    auto met = v.slab(axis, T(half[axis] + radius));
    for (int j = 0; j < 3; ++j)
      if (j != axis) met = v.all(met, v.slab(j, half[j]));
    return met;
  };
  auto met = v.any(v.any(grown_along(0), grown_along(1)), grown_along(2));
  for (int along = 0; along < 3; ++along) {
    const int j = along == 0 ? 1 : 0, k = along == 2 ? 1 : 2;
    for (unsigned signs = 0; signs < 4; ++signs) {
      const std::array<Centre<T>, 2> edge{face_at(half, j, signs, 0), face_at(half, k, signs, 1)};
      met = v.any(met, v.all(v.slab(along, half[along]), v.ball(edge, radius)));
    }
  }
  for (unsigned signs = 0; signs < 8; ++signs) met = v.any(met, v.ball(corner<3>(half, signs), radius));
  return met;
}

}  // namespace foresee
