// Convex pieces of one object in space, their constraints (constraint/constraint.h), and the sizes of a pair.
//
//   SpacePieces pieces;
//   pieces.take_row(drones, drones.meshes, 7);        // or take(triangles), take_box(box), take_point()
//   if (pieces.is_leaf(node)) test(pieces.piece(pieces.item(node)));
//
// Two convex pieces touch while d is in their Minkowski sum A + (-B). Then d is on the inner side of all
// planes that touch the sum. Each plane goes through a corner p of A minus a corner q of B. The parts of the
// sum grown by the contact distance are those of its features (space_sum.h).
#pragma once

#include <array>
#include <optional>

#include "contact/certified/form_pieces.h"
#include "contact/constraint/constraint.h"
#include "contact/setup.h"
#include "shape/mesh/triangle_tree.h"

namespace foresee {

/// The vector from one corner to another, not 0.
struct EdgeVector {
  const SpaceCorner *from, *to;
};

/// A triangle, or a box along the axes.
class SpacePiece {
 public:
  SpacePiece(const TriangleTree& triangles, std::size_t triangle);
  /// `corners`: all eight; corner i has the upper coordinate on each axis whose bit in i is set.
  explicit SpacePiece(const SpaceCorner* corners);

  bool is_box() const { return !triangles_; }
  int corner_count() const { return is_box() ? 8 : 3; }
  int edge_count() const { return is_box() ? 12 : 3; }
  const SpaceCorner& corner(int i) const { return is_box() ? box_[i] : triangles_->corner(triangle_, i); }
  /// The numbers of the corners at both ends of an edge.
  std::array<int, 2> edge(int i) const;
  /// The direction of edge i, also in a box without width.
  const EdgeVector& vector_of_edge(int i) const { return edge_vectors_[is_box() ? i / 4 : i]; }
  /// All directions of edges.
  const std::array<EdgeVector, 3>& edge_vectors() const { return edge_vectors_; }
  /// A corner or edge that several triangles share belongs to one of them. Of those that coincide in a box
  /// without width, one belongs to it.
  bool owns_corner(int i) const {
    return is_box() ? (i & flat_) == 0 : triangles_->owns_corner(triangle_, i);
  }
  bool owns_edge(int i) const {
    return is_box() ? ((edge(i)[0] | 1 << i / 4) & flat_) == 0 : triangles_->owns_edge(triangle_, i);
  }
  /// For a box, a bit for each axis along which it has no width.
  int flat() const { return flat_; }
  bool is_point() const { return flat_ == 7; }

 private:
  const TriangleTree* triangles_ = nullptr;
  std::size_t triangle_ = 0;
  const SpaceCorner* box_ = nullptr;
  int flat_ = 0;
  std::array<EdgeVector, 3> edge_vectors_;
};

/// The triangles of an object's mesh, or one box (certified/form_pieces.h).
class SpacePieces : public FormPieces<SpacePieces, 3, TriangleTree> {
 public:
  void take_box(const Box<3>& box);
  void take_point() { take_box({Vec<3>::zero(), Vec<3>::zero()}); }

  /// About as many: a triangle takes as long as a box.
  static std::size_t corner_count(std::size_t) { return 4; }
  SpacePiece piece(std::size_t i) const {
    return form_ ? SpacePiece(*form_, i) : SpacePiece(corners_.data());
  }
  /// Null if the object is a box.
  const TriangleTree* triangles() const { return form_; }
  bool is_mesh() const { return form_ != nullptr; }
  /// The triangles if they enclose a solid, whose inside has no pieces; else null.
  const TriangleTree* solid() const { return form_ && form_->is_solid() ? form_ : nullptr; }
  /// Connected components of the surface, each represented by one corner.
  std::size_t parts() const { return form_ ? form_->parts() : 1; }
  const SpaceCorner& part_corner(std::size_t part) const {
    return form_ ? form_->part_corner(part) : corners_[0];
  }

 private:
  std::array<SpaceCorner, 8> corners_;
};

/// A direction in space, not 0: an edge vector u, the cross product of two, or that of such a product with a
/// third.
struct SpaceAxis {
  int factors;  ///< 1: u; 2: u x v; 3: (u x v) x w
  EdgeVector u = {}, v = {}, w = {};
};

/// The sizes of a pair, from its rows and the query. They are constant.
template <class T>
struct SpaceSizes {
  MovingSize<T> radius;  ///< the contact distance
  /// The component of d along each axis, if it is constant and a double. With it, doubles decide that an
  /// object slides along a floor or a wall.
  std::array<std::optional<double>, 3> steady = {};
};

/// The sizes themselves, as they are constant.
template <class T>
const SpaceSizes<T>& expanded_at(const SpaceSizes<T>& sizes, double /*tau*/) {
  return sizes;
}

std::array<std::optional<double>, 3> steady_axes_of(const Setup& setup, const double* row_a,
                                                    const double* row_b);

template <class T>
using Components = std::array<T, 3>;

/// a - b
template <class T>
Components<T> gap_between(const SpaceCorner& a, const SpaceCorner& b) {
  using E = Exactly<T>;
  return {E::difference_of(a.x, b.x), E::difference_of(a.y, b.y), E::difference_of(a.z, b.z)};
}

template <>
inline Components<Bounded> gap_between(const SpaceCorner& a, const SpaceCorner& b) {
  const auto gap = [](double to, double from) {
    const DoubleDouble exactly = difference(to, from);
    return Bounded{exactly.high, std::abs(exactly.low)};
  };
  return {gap(a.x, b.x), gap(a.y, b.y), gap(a.z, b.z)};
}

template <class T>
Components<T> components_of(const SpaceCorner& corner) {
  using E = Exactly<T>;
  return {E::number(corner.x), E::number(corner.y), E::number(corner.z)};
}

template <class T>
Components<T> difference_of(const Components<T>& a, const Components<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class T>
Components<T> cross_product(const Components<T>& a, const Components<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A product that counts its own underflow, as a later factor may be large. A product with an exact 0 is an
/// exact 0.
template <class T>
T safe_product(const T& a, const T& b) {
  return a * b;
}
template <>
inline Bounded safe_product(const Bounded& a, const Bounded& b) {
  Bounded product = a * b;
  if (std::abs(product.value) < 0x1p-960 && (a.value != 0 || a.error != 0) && (b.value != 0 || b.error != 0))
    product.error += 0x1p-1060;
  return product;
}
template <>
inline Components<Bounded> cross_product(const Components<Bounded>& a, const Components<Bounded>& b) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return safe_product(a[i], b[j]) - safe_product(a[j], b[i]);
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

template <class T>
T dot(const Components<T>& a, const Components<T>& b) {
  return safe_product(a[0], b[0]) + safe_product(a[1], b[1]) + safe_product(a[2], b[2]);
}

template <class T>
Components<T> direction_of(const SpaceAxis& axis) {
  const Components<T> u = gap_between<T>(*axis.u.to, *axis.u.from);
  if (axis.factors == 1) return u;
  const Components<T> normal = cross_product<T>(u, gap_between<T>(*axis.v.to, *axis.v.from));
  if (axis.factors == 2) return normal;
  return cross_product<T>(normal, gap_between<T>(*axis.w.to, *axis.w.from));
}
/// direction_of() in doubles, rounded from twice the digits. For nearly parallel edge vectors a product of doubles
/// would consist of errors alone.
Components<Bounded> close_direction_of(const SpaceAxis& axis);

/// The plane perpendicular to an axis through p - q, the line along it, or p - q itself.
struct SpaceFeature {
  static constexpr int axes = 3;

  SpaceAxis axis = {};
  const SpaceCorner *p = nullptr, *q = nullptr;

  template <class T>
  Components<T> direction() const {
    return direction_of<T>(axis);
  }
  template <class T>
  Components<T> origin(int /*sign*/) const {
    return gap_between<T>(*p, *q);
  }
  template <class T>
  static T product(const T& a, const T& b) {
    return safe_product(a, b);
  }
};

using SpaceConstraint = Constraint<SpaceFeature>;

}  // namespace foresee
