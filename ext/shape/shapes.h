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

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/error.h"
#include "motion/box.h"
#include "shape/layout.h"

namespace foresee {

// Which box is around a shape of which a row knows the bounds? They are those of the outline or mesh as it
// lies, not yet grown by r.
//
//   extents_of_bounds<3, 2>(row, at)          // x and y of an outline that is a prism; along z none
//
// Extents reach to the position too, which may lie outside: so they are of use for questions about positions.

/// The sum, and what rounding may have lost of it.
inline double sum_outward(double bound, double more) {
  if (more == 0) return bound;
  const double sum = bound + more;
  return sum + std::copysign(std::abs(sum) * 0x1p-52, more);
}

/// `Bounded`: in how many axes the shape has bounds.
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

/// Those of a box in which nothing is.
template <int D>
Extents<D> no_extents() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {Vec<D>::Constant(inf), Vec<D>::Constant(-inf)};
}

// Which columns hold the size of a shape?

/// One quantity of a shape's size: "r", or "h" on every axis for hx, hy, hz.
struct SizeColumn {
  const char* name;
  bool on_all_axes;
  int Offsets::*place;        ///< where its numbers stand in a record or row
  const char* when_negative;  ///< what is wrong with a stored number below 0
};

constexpr SizeColumn half_extent_columns{"h", true, &Offsets::half, "a half extent is negative"};
constexpr SizeColumn half_height_column{"hz", false, &Offsets::hz, "a half extent is negative"};
constexpr SizeColumn radius_column{"r", false, &Offsets::r, "a radius is negative"};
constexpr SizeColumn growth_column{"growth", false, &Offsets::growth, "a growth is negative"};
constexpr SizeColumn growth_z_column{"growth_z", false, &Offsets::growth_z, "a growth is negative"};

/// Of the columns of a layout's shape: whether it is there. Each is, but for outlines and meshes, which say
/// with the number of axes and apart which of them they have, and for what starts as a point.
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
  template <int D>
  static Extents<D> core(const double* numbers, const Offsets& at) {
    return extents<D>(numbers, at);
  }
};

// A box along the axes: half extents hx, hy, hz.

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

// An interval, a disc or a ball, by the number of axes: a radius r, or none at first where it grows.

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

// An upright cylinder, of three axes only: a radius r in x and y, a half height hz, or neither at first where
// it grows.

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

// An outline of its own, flat, or the upright prism over it of half height hz; with r it is grown on all
// sides in x and y. What has no outline is what its other columns say: a point, a disc, or an upright
// cylinder.
//
// A row knows the number of its outline and the smallest box around it as it lies (outline/outline_rotation.h), so that
// who only needs boxes looks no outline up.

struct OutlineShape {
  static constexpr Shape shape = Shape::outline;
  static constexpr SizeColumn sizes[] = {radius_column, half_height_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    Extents<D> around = extents_of_bounds<D, 2>(numbers, at);
    if constexpr (D == 3) around.lower[2] = -numbers[at.hz], around.upper[2] = numbers[at.hz];
    return around;
  }
  /// None: what lies within the box may lie in a hole.
  template <int D>
  static Extents<D> core(const double* /*numbers*/, const Offsets& /*at*/) {
    return no_extents<D>();
  }
};

// A mesh of its own: triangles in space, a surface or a solid; with r it is grown on all sides. What has no
// mesh is what its radius says: a point or a ball.
//
// A row knows the number of its mesh and the smallest box around it as it lies (mesh/turned_mesh.h), so that
// who only needs boxes looks no mesh up.

struct MeshShape {
  static constexpr Shape shape = Shape::mesh;
  static constexpr SizeColumn sizes[] = {radius_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return extents_of_bounds<D, 3>(numbers, at);
  }
  /// None: nothing need be inside a surface.
  template <int D>
  static Extents<D> core(const double* /*numbers*/, const Offsets& /*at*/) {
    return no_extents<D>();
  }
};

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
