// What must hold while two pieces in space touch: each condition a polynomial in time that is at most 0 then,
// written once for every number type.
//
// Two convex pieces touch while d lies in their Minkowski sum A + (-B): on the inner side of all planes that
// touch it, each of which goes through a corner p of A minus a corner q of B. If R is how near counts as
// touching, d may also be at most R from a plane, from the line of an edge or from a corner of the sum, where
// that is what is nearest: the sum grown by R is the union of these (round_parts.h).
#pragma once

#include <array>
#include <optional>

#include "contact/set/primitive.h"
#include "contact/set/relative_motion.h"
#include "shape/mesh/triangle_tree.h"
#include "shape/scratch_pieces.h"

namespace foresee {

// What does an object look like to contact in space? Convex pieces under a tree of boxes: the triangles of
// its mesh, or the one box that its half extents make; a point is a box of no size.
//
//   SpacePieces pieces;
//   pieces.take(*meshes.triangles(row, pieces.own()));  // or take_box(box), take_point()
//   if (pieces.is_leaf(node)) test(pieces.piece(pieces.item(node)));

/// From one corner to another: never of no length.
struct EdgeVector {
  const SpaceCorner *from, *to;
};

/// A triangle, or a box along the axes.
class SpacePiece {
 public:
  SpacePiece(const TriangleTree& triangles, std::size_t triangle);
  /// `corners`: all eight; number i has the upper coordinate on the axes of the bits in i.
  explicit SpacePiece(const SpaceCorner* corners);

  bool is_box() const { return !triangles_; }
  int corner_count() const { return is_box() ? 8 : 3; }
  int edge_count() const { return is_box() ? 12 : 3; }
  const SpaceCorner& corner(int i) const { return is_box() ? box_[i] : triangles_->corner(triangle_, i); }
  /// The corners at both ends of an edge.
  std::array<int, 2> edge(int i) const;
  /// Which way edge i runs, also where a box has no width.
  const EdgeVector& vector_of_edge(int i) const { return edge_vectors_[is_box() ? i / 4 : i]; }
  /// All ways that edges run.
  const std::array<EdgeVector, 3>& edge_vectors() const { return edge_vectors_; }
  /// Corners and edges that several triangles share belong to one of them; of those that coincide in a box
  /// without width, one counts.
  bool owns_corner(int i) const {
    return is_box() ? (i & flat_) == 0 : triangles_->owns_corner(triangle_, i);
  }
  bool owns_edge(int i) const {
    return is_box() ? ((edge(i)[0] | 1 << i / 4) & flat_) == 0 : triangles_->owns_edge(triangle_, i);
  }
  /// Of a box, a bit for each axis along which it has no width.
  int flat() const { return flat_; }
  bool is_point() const { return flat_ == 7; }

 private:
  const TriangleTree* triangles_ = nullptr;
  std::size_t triangle_ = 0;
  const SpaceCorner* box_ = nullptr;
  int flat_ = 0;
  std::array<EdgeVector, 3> edge_vectors_;
};

/// Of one object at a time; what was taken must outlive its use.
class SpacePieces {
 public:
  static constexpr int axes = 3;
  using Node = BoxTree<3>::Node;
  static constexpr Node root = BoxTree<3>::root;

  void take(const TriangleTree& triangles) { triangles_ = &triangles; }
  /// For triangles that nobody else keeps.
  ScratchPieces<TriangleTree>& own() { return own_; }
  void take_box(const Box<3>& box);
  void take_point() { take_box({Vec<3>::Zero(), Vec<3>::Zero()}); }

  std::size_t count() const { return triangles_ ? triangles_->count() : 1; }
  SpacePiece piece(std::size_t i) const {
    return triangles_ ? SpacePiece(*triangles_, i) : SpacePiece(corners_.data());
  }
  const Box<3>& box(Node node) const { return triangles_ ? triangles_->tree().box(node) : box_; }
  bool is_leaf(Node node) const { return !triangles_ || triangles_->tree().is_leaf(node); }
  std::size_t item(Node leaf) const { return triangles_ ? triangles_->tree().item(leaf) : 0; }
  static Node left(Node node) { return 2 * node + 1; }
  static Node right(Node node) { return 2 * node + 2; }

  /// None: it is a box.
  const TriangleTree* triangles() const { return triangles_; }
  bool is_mesh() const { return triangles_ != nullptr; }
  /// Its triangles, if they enclose it: what its pieces leave out is the inside of these.
  const TriangleTree* solid() const { return triangles_ && triangles_->is_solid() ? triangles_ : nullptr; }
  /// A corner of each part that hangs together.
  std::size_t parts() const { return triangles_ ? triangles_->parts() : 1; }
  const SpaceCorner& part_corner(std::size_t part) const {
    return triangles_ ? triangles_->part_corner(part) : corners_[0];
  }

 private:
  const TriangleTree* triangles_ = nullptr;  ///< none: the box
  std::array<SpaceCorner, 8> corners_;
  Box<3> box_;
  ScratchPieces<TriangleTree> own_;
};

/// A direction in space, not 0: that of a run, square to two runs, or square to such a one and a third run.
struct SpaceAxis {
  int factors;  ///< 1: u; 2: u x v; 3: (u x v) x w
  EdgeVector u = {}, v = {}, w = {};
};

struct SpaceCondition {
  enum class Kind : std::uint8_t {
    plane,  ///< not beyond the plane through p - q, along the axis (sign 1) or against it (-1)
    slab,   ///< at most R from that plane
    tube,   ///< at most R from the line through p - q along the axis, which is a run
    ball    ///< at most R from p - q
  };
  Kind kind = Kind::plane;
  int sign = 1;
  SpaceAxis axis = {};
  const SpaceCorner *p, *q;
};

/// What the rows of a pair say beside the pieces, and the question.
template <class T>
struct SpaceSizes {
  T radius;  ///< how near counts as touching
  /// d along each axis, where it never changes and a double holds it: so that doubles tell of what slides
  /// along a floor or a wall that it does.
  std::array<std::optional<double>, 3> steady = {};
};

/// They do not change.
template <class T>
const SpaceSizes<T>& expanded_at(const SpaceSizes<T>& sizes, double /*tau*/) {
  return sizes;
}

std::array<std::optional<double>, 3> steady_axes_of(const Setup& setup, const double* row_a,
                                                    const double* row_b);

template <class T>
T radius_of(const Setup& setup, const double* row_a, const double* row_b) {
  using E = Exactly<T>;
  return E::number(value_or(row_a, setup.a.at.r, 0)) + E::number(value_or(row_b, setup.b.at.r, 0)) +
         E::number(setup.within);
}

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
Components<T> cross_product(const Components<T>& a, const Components<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A product whose underflow is counted where it happens: what it is multiplied with later may be large, and
/// what is 0 without an error is 0.
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
Components<T> direction_of(const SpaceAxis& axis) {
  const Components<T> u = gap_between<T>(*axis.u.to, *axis.u.from);
  if (axis.factors == 1) return u;
  const Components<T> normal = cross_product<T>(u, gap_between<T>(*axis.v.to, *axis.v.from));
  if (axis.factors == 2) return normal;
  return cross_product<T>(normal, gap_between<T>(*axis.w.to, *axis.w.from));
}
/// The same in double as if computed with twice the digits: of runs that are parallel but for roundings
/// nothing else would be left than errors.
Components<Bounded> close_direction_of(const SpaceAxis& axis);

template <class T>
T squared_length(const Components<T>& a) {
  return square(a[0]) + square(a[1]) + square(a[2]);
}

/// d as seen from p - q. `x`: d by powers of time.
template <int K, class T>
std::array<Coefficients<T, K>, 3> gap_from(const SpaceCondition& condition,
                                           const std::array<Coefficients<T, K>, 3>& x) {
  const Components<T> at = gap_between<T>(*condition.p, *condition.q);
  std::array<Coefficients<T, K>, 3> gap = x;
  for (std::size_t j = 0; j < 3; ++j) gap[j][0] = gap[j][0] - at[j];
  return gap;
}

/// How far d is beyond the plane, in lengths of `direction`.
template <int K, class T>
Coefficients<T, K> beyond_plane(const SpaceCondition& condition, const Components<T>& direction,
                                const std::array<Coefficients<T, K>, 3>& x) {
  const auto gap = gap_from<K>(condition, x);
  Coefficients<T, K> p{};
  for (std::size_t k = 0; k <= K; ++k) {
    const T sum = safe_product(direction[0], gap[0][k]) + safe_product(direction[1], gap[1][k]) +
                  safe_product(direction[2], gap[2][k]);
    p[k] = condition.sign < 0 ? -sum : sum;
  }
  return p;
}

/// The square of the distance from plane, line or corner, minus that of R, times that of the direction's
/// length.
template <int K, class T>
Coefficients<T, 2 * K> round_polynomial(const SpaceCondition& condition,
                                        const std::array<Coefficients<T, K>, 3>& x, const T& radius) {
  Coefficients<T, 2 * K> p{};
  const auto add = [&p](const Coefficients<T, K>& q) {
    p[0] = p[0] + square(q[0]);
    add_square_above<K>(p, q);
  };
  if (condition.kind == SpaceCondition::Kind::ball) {
    p[0] = -square(radius);
    for (const Coefficients<T, K>& gap : gap_from<K>(condition, x)) add(gap);
    return p;
  }
  const Components<T> direction = direction_of<T>(condition.axis);
  p[0] = -(square(radius) * squared_length(direction));
  if (condition.kind == SpaceCondition::Kind::slab) {
    add(beyond_plane<K>(condition, direction, x));
    return p;
  }
  const auto gap = gap_from<K>(condition, x);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t one = (j + 1) % 3, other = (j + 2) % 3;
    Coefficients<T, K> cross{};
    for (std::size_t k = 0; k <= K; ++k)
      cross[k] = gap[one][k] * direction[other] - gap[other][k] * direction[one];
    add(cross);
  }
  return p;
}

/// Gives `take` the polynomial of a condition. `x`: d by powers of the time after some moment.
template <int K, class T, class Take>
auto with_polynomial(const SpaceCondition& condition, const std::array<Coefficients<T, K>, 3>& x,
                     const SpaceSizes<T>& sizes, Take&& take) {
  if (condition.kind == SpaceCondition::Kind::plane)
    return take(beyond_plane<K>(condition, direction_of<T>(condition.axis), x));
  return take(round_polynomial<K>(condition, x, sizes.radius));
}

}  // namespace foresee
