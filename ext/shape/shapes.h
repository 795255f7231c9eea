// What must a shape say? Everything that the rooms ask of one stands in its file; here the shapes are listed,
// and a layout becomes one of them.
//
//   with_shape(layout.shape, [&](auto shape) { return shape.template extents<2>(row, at); });
//
// A shape is a type of static members: `shape`, its name in a layout; `sizes`, its columns in the order of a
// record, each a number >= 0 (of an outline or a mesh not all need be there); `extents`, the smallest box
// around it and its position, and `core`, a box within it, both seen from that position and as of t, from
// when on it may grow. What it is for contact says contact/make_contact.cpp, by pairs of shapes.
#pragma once

#include "base/error.h"
#include "shape/ball.h"
#include "shape/box.h"
#include "shape/cylinder.h"
#include "shape/mesh_shape.h"
#include "shape/outline_shape.h"
#include "shape/point.h"

namespace foresee {

/// use(the shape of this name).
template <class Use>
decltype(auto) with_shape(Shape shape, Use&& use) {
  switch (shape) {
    case Shape::point:
      return use(PointShape{});
    case Shape::box:
      return use(BoxShape{});
    case Shape::ball:
      return use(BallShape{});
    case Shape::cylinder:
      return use(CylinderShape{});
    case Shape::outline:
      return use(OutlineShape{});
    case Shape::mesh:
      return use(MeshShape{});
  }
  throw Error("a layout of a shape that this version does not know");
}

/// use(column) for each that holds a size of objects of this layout, or how fast they grow.
template <class Use>
void for_each_size(const Layout& layout, Use&& use) {
  with_shape(layout.shape, [&](auto shape) {
    for (const SizeColumn& column : shape.sizes)
      if (has_column(layout, column)) use(column);
  });
  if (layout.has_growth) use(growth_column);
  if (layout.has_growth_z) use(growth_z_column);
}

/// The box around an object as of t, from its record or its row, whichever `at` tells the places of.
template <int D>
Extents<D> extents_of(Shape shape, const double* numbers, const Offsets& at) {
  return with_shape(shape, [&](auto known) { return known.template extents<D>(numbers, at); });
}

/// Where a record or row says how fast the shape grows along an axis; absent where it does not.
constexpr int growth_place(Shape shape, const Offsets& at, int axis) {
  if (axis < 2) return at.growth;
  const bool upright = shape == Shape::cylinder || shape == Shape::outline;
  return at.growth_z != Offsets::absent || upright ? at.growth_z : at.growth;
}

/// How fast each side of the box around it moves outward from t on.
template <int D>
Vec<D> growth_of(Shape shape, const double* numbers, const Offsets& at) {
  Vec<D> growth = Vec<D>::Zero();
  if (at.growth == Offsets::absent && at.growth_z == Offsets::absent) return growth;
  for (int axis = 0; axis < D; ++axis) growth[axis] = value_or(numbers, growth_place(shape, at, axis), 0);
  return growth;
}

/// A box within it, from t on.
template <int D>
Extents<D> core_of(Shape shape, const double* numbers, const Offsets& at) {
  return with_shape(shape, [&](auto known) { return known.template core<D>(numbers, at); });
}

}  // namespace foresee
