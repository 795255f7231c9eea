// What must a shape say? Everything that the rooms ask of one stands in its file; here the shapes are listed,
// and a layout becomes one of them.
//
//   with_shape(layout.shape, [&](auto shape) { return shape.template extents<2>(row, at); });
//
// A shape is a type of static members: `shape`, its name in a layout; `sizes`, its columns in the order of a
// record, each a number >= 0 (of an outline or a mesh not all need be there); `extents`, the smallest box
// around it and its position, and `core`, a box within it, both seen from that position. What it is for
// contact says contact/make_contact.cpp, by pairs of shapes.
#pragma once

#include "base/error.h"
#include "shape/ball.h"
#include "shape/box.h"
#include "shape/cylinder.h"
#include "shape/mesh_shape.h"
#include "shape/outline_shape.h"
#include "shape/point.h"

namespace foresee::shape {

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

/// The box around an object, from its record or its row, whichever `at` tells the places of.
template <int D>
Extents<D> extents_of(Shape shape, const double* numbers, const Offsets& at) {
  return with_shape(shape, [&](auto known) { return known.template extents<D>(numbers, at); });
}

/// A box within it.
template <int D>
Extents<D> core_of(Shape shape, const double* numbers, const Offsets& at) {
  return with_shape(shape, [&](auto known) { return known.template core<D>(numbers, at); });
}

}  // namespace foresee::shape
