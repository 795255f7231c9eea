// Conditions for contact of two convex pieces in space: each is a polynomial in time that is at most 0
// while it holds, written once for all number types.
//
// Two convex pieces touch while d is in their Minkowski sum A + (-B). Then d is on the inner side of all
// planes that touch the sum; each plane goes through a corner p of A minus a corner q of B. Let R be the
// contact distance. If R is more than 0, d may also be at most R from a plane, an edge or a corner of the
// sum, whichever is the nearest feature. The union of these sets is the sum grown by R (space_sum.h).
#pragma once

#include <optional>

#include "contact/mesh/space_pieces.h"
#include "contact/set/primitive.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// A direction in space, not 0: an edge vector u, the cross product of two, or that of such a product with a
/// third.
struct SpaceAxis {
  int factors;  ///< 1: u; 2: u x v; 3: (u x v) x w
  EdgeVector u = {}, v = {}, w = {};
};

struct SpaceCondition {
  enum class Kind : std::uint8_t {
    plane,  ///< d is not beyond the plane through p - q, along the axis (sign 1) or against it (-1)
    slab,   ///< d is at most R from that plane
    tube,   ///< d is at most R from the line through p - q along the axis, an edge vector
    ball    ///< d is at most R from p - q
  };
  Kind kind = Kind::plane;
  int sign = 1;
  SpaceAxis axis = {};
  const SpaceCorner *p, *q;
};

/// The sizes of a pair, from its rows and the query. They are constant.
template <class T>
struct SpaceSizes {
  T radius;  ///< the contact distance
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
Components<T> direction_of(const SpaceAxis& axis) {
  const Components<T> u = gap_between<T>(*axis.u.to, *axis.u.from);
  if (axis.factors == 1) return u;
  const Components<T> normal = cross_product<T>(u, gap_between<T>(*axis.v.to, *axis.v.from));
  if (axis.factors == 2) return normal;
  return cross_product<T>(normal, gap_between<T>(*axis.w.to, *axis.w.from));
}
/// The same in doubles, rounded from twice the digits. For nearly parallel edge vectors a product of doubles
/// would consist of errors alone.
Components<Bounded> close_direction_of(const SpaceAxis& axis);

template <class T>
T squared_length(const Components<T>& a) {
  return square(a[0]) + square(a[1]) + square(a[2]);
}

/// d - (p - q). `x`: d by powers of time.
template <int K, class T>
std::array<Coefficients<T, K>, 3> gap_from(const SpaceCondition& condition,
                                           const std::array<Coefficients<T, K>, 3>& x) {
  const Components<T> at = gap_between<T>(*condition.p, *condition.q);
  std::array<Coefficients<T, K>, 3> gap = x;
  for (std::size_t j = 0; j < 3; ++j) gap[j][0] = gap[j][0] - at[j];
  return gap;
}

/// The signed distance of d beyond the plane, times the length of `direction`.
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

/// The squared distance from the plane, line or corner, minus R^2, times the squared length of the direction.
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

/// Calls `take` with the polynomial of a condition. `x`: d by powers of the time after one instant.
template <int K, class T, class Take>
auto with_polynomial(const SpaceCondition& condition, const std::array<Coefficients<T, K>, 3>& x,
                     const SpaceSizes<T>& sizes, Take&& take) {
  if (condition.kind == SpaceCondition::Kind::plane)
    return take(beyond_plane<K>(condition, direction_of<T>(condition.axis), x));
  return take(round_polynomial<K>(condition, x, sizes.radius));
}

}  // namespace foresee
