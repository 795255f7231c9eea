// The shapes of objects: point, box, ball, cylinder, outline and mesh, each with its columns and its extents.
//
//   with_shape(layout.shape, [&](auto shape) { return shape.template extents<2>(row, at); });
//
// A shape is a type of static members. `shape` is its enumerator in a layout. `sizes` are its columns in the
// order of a record, each a number >= 0; an outline or a mesh need not have all. `extents` is the bounding box
// of the shape and its position, relative to the position and as of t, from when on the shape may grow.
// contact/make_contact.cpp selects contact by pairs of shapes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/error.h"
#include "motion/axis_aligned_box.h"
#include "shape/row_layout.h"

namespace foresee {

// Extents of a shape with stored bounds: those of the rotated outline or mesh, not yet inflated by r.
//
//   extents_of_bounds<3, 2>(row, at)          // x and y of an outline that is a prism; along z none
//
// Extents include the position, which may lie outside the shape, so that they serve queries about positions
// too.

/// The sum, rounded outward: away from `bound`, in the direction of `more`.
inline double sum_outward(double bound, double more) {
  if (more == 0) return bound;
  const double sum = bound + more;
  return sum + std::copysign(std::abs(sum) * 0x1p-52, more);
}

/// `Bounded`: the number of axes with stored bounds.
template <int D, int Bounded>
Extents<D> extents_of_bounds(const double* numbers, const Offsets& at) {
  Extents<D> around = Extents<D>::none();
  const double r = value_or(numbers, at.r, 0);
  for (int axis = 0; axis < std::min(D, Bounded); ++axis) {
    around.lower[axis] = std::min(0.0, sum_outward(numbers[at.bounds + axis], -r));
    around.upper[axis] = std::max(0.0, sum_outward(numbers[at.bounds + Bounded + axis], r));
  }
  return around;
}

/// The extents of an empty box.
template <int D>
Extents<D> no_extents() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {Vec<D>::constant(inf), Vec<D>::constant(-inf)};
}

// The columns that hold the size of a shape.

/// One quantity of a shape's size: "r", or "h" on every axis for hx, hy, hz.
struct SizeColumn {
  const char* name;
  bool on_all_axes;
  int Offsets::*place;        ///< offset of its numbers in a record or row
  const char* when_negative;  ///< what is wrong with a stored number below 0
};

constexpr SizeColumn half_extent_columns{"h", true, &Offsets::half, "a half extent is negative"};
constexpr SizeColumn half_height_column{"hz", false, &Offsets::hz, "a half extent is negative"};
constexpr SizeColumn radius_column{"r", false, &Offsets::r, "a radius is negative"};
constexpr SizeColumn growth_column{"growth", false, &Offsets::growth, "a growth is negative"};
constexpr SizeColumn growth_z_column{"growth_z", false, &Offsets::growth_z, "a growth is negative"};

/// Whether a layout has this column of its shape. Exceptions are outlines and meshes, whose columns depend on
/// the number of axes and on the declaration, and shapes that start as a point.
constexpr bool has_column(const Layout& layout, const SizeColumn& column) {
  if (!is_stored_apart(layout.shape)) return !layout.starts_as_point;
  return column.place == &Offsets::r ? layout.has_radius : layout.axes == 3;
}

// A point: no size.
struct PointShape {
  static constexpr Shape shape = Shape::point;
  static constexpr std::span<const SizeColumn> sizes = {};

  template <int D>
  static Extents<D> extents(const double* /*numbers*/, const Offsets& /*at*/) {
    return Extents<D>::none();
  }
};

// A box along the axes: half extents hx, hy, hz.
struct BoxShape {
  static constexpr Shape shape = Shape::box;
  static constexpr SizeColumn sizes[] = {half_extent_columns};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return symmetric<D>(Vec<D>::at(numbers + at.half));
  }
};

// An interval, a disc or a ball, by the number of axes: a radius r, or radius 0 at first if it grows.
struct BallShape {
  static constexpr Shape shape = Shape::ball;
  static constexpr SizeColumn sizes[] = {radius_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return symmetric<D>(Vec<D>::constant(value_or(numbers, at.r, 0)));
  }
};

// An upright cylinder, on three axes only: a radius r in x and y, a half height hz, or neither at first if it
// grows.
struct CylinderShape {
  static constexpr Shape shape = Shape::cylinder;
  static constexpr SizeColumn sizes[] = {radius_column, half_height_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    Vec<D> half = Vec<D>::constant(value_or(numbers, at.r, 0));
    half[D - 1] = value_or(numbers, at.hz, 0);
    return symmetric<D>(half);
  }
};

// A flat outline, or the upright prism over it of half height hz; r inflates it in x and y. An object without
// an outline is a point, a disc, or an upright cylinder, as its other columns say.
//
// A row has the number of its outline and the bounding box of the rotated outline
// (outline/outline_rotation.h), so that box tests need no look-up of outlines.
struct OutlineShape {
  static constexpr Shape shape = Shape::outline;
  static constexpr SizeColumn sizes[] = {radius_column, half_height_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    Extents<D> around = extents_of_bounds<D, 2>(numbers, at);
    if constexpr (D == 3) around.lower[2] = -numbers[at.hz], around.upper[2] = numbers[at.hz];
    return around;
  }
};

// A mesh of triangles in space, a surface or a solid; r inflates it on all sides. An object without a mesh is
// a point or a ball of its radius.
//
// A row has the number of its mesh and the bounding box of the rotated mesh (mesh/mesh.h), so that box
// tests need no look-up of meshes.
struct MeshShape {
  static constexpr Shape shape = Shape::mesh;
  static constexpr SizeColumn sizes[] = {radius_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return extents_of_bounds<D, 3>(numbers, at);
  }
};

/// Calls use() with the type of this shape.
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

/// Calls use(column) for each column that holds a size, or a rate of growth, of objects of this layout.
template <class Use>
void for_each_size(const Layout& layout, Use&& use) {
  with_shape(layout.shape, [&](auto shape) {
    for (const SizeColumn& column : shape.sizes)
      if (has_column(layout, column)) use(column);
  });
  if (layout.has_growth) use(growth_column);
  if (layout.has_growth_z) use(growth_z_column);
}

/// The extents of an object as of t, from its record or its row, whose offsets `at` has.
template <int D>
Extents<D> extents_of(Shape shape, const double* numbers, const Offsets& at) {
  return with_shape(shape, [&](auto known) { return known.template extents<D>(numbers, at); });
}

/// Offset of the rate of growth along an axis in a record or row; absent if there is no such column.
constexpr int growth_place(Shape shape, const Offsets& at, int axis) {
  if (axis < 2) return at.growth;
  const bool upright = shape == Shape::cylinder || shape == Shape::outline;
  return at.growth_z != Offsets::absent || upright ? at.growth_z : at.growth;
}

/// The speed at which each side of the bounding box moves outward from t on.
template <int D>
Vec<D> growth_of(Shape shape, const double* numbers, const Offsets& at) {
  Vec<D> growth = Vec<D>::zero();
  if (at.growth == Offsets::absent && at.growth_z == Offsets::absent) return growth;
  for (int axis = 0; axis < D; ++axis) growth[axis] = value_or(numbers, growth_place(shape, at, axis), 0);
  return growth;
}

/// Half the side of the square or cube inscribed in a disc or ball of radius 1, by the number of axes,
/// rounded down.
constexpr double inscribed[] = {1, 1, 0.7071, 0.5773};

/// A box within the shape, from t on; empty for shapes that need not contain a box. A point within the box around an
/// outline may lie in a hole.
template <int D>
Extents<D> core_of(Shape shape, const double* numbers, const Offsets& at) {
  const int round = shape == Shape::ball ? D : shape == Shape::cylinder ? 2 : 0;
  if (round == 0 && shape != Shape::point && shape != Shape::box) return no_extents<D>();
  Extents<D> core = extents_of<D>(shape, numbers, at);
  for (int axis = 0; axis < round; ++axis)
    core.lower[axis] *= inscribed[round], core.upper[axis] *= inscribed[round];
  return core;
}

}  // namespace foresee
