// Constraints of contact: half spaces, slabs, tubes and balls. Each is a polynomial in time that is at most 0
// while the constraint holds, written once for all number types.
//
//   const Constraint<FlatFeature> beside{.kind = ConstraintKind::slab, .feature = {.edge = edge}};
//   with_polynomial<1>(beside, x, sizes, [&](const auto& p) { use(p); });    // x: d by powers of time
//
// Two convex pieces touch while the relative position d is in their Minkowski sum, which is an intersection
// of half spaces. Let R be the contact distance. If R is more than 0, d may also be at most R from a face, an
// edge or a corner of the sum. These sets are slabs, tubes and balls between half spaces; the union of all is
// the sum grown by R.
//
// A feature is that face, edge or corner. It has `axes`; direction<T>(), which is normal to a face or along
// an edge, of any length but 0; origin<T>(sign), a point of it; and product(), the multiplication of
// components. Sizes may grow linearly with time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "numbers/coefficients.h"

namespace foresee {

enum class ConstraintKind : std::uint8_t {
  half_space,  ///< linear: d is not beyond a plane or line, along its direction (sign 1) or against it (-1)
  slab,        ///< quadratic: d is at most R from that plane or line
  tube,        ///< quadratic, on three axes: d is at most R from the line along the direction
  ball         ///< quadratic: d is at most R from the origin of the feature
};

template <class Feature>
struct Constraint {
  ConstraintKind kind = ConstraintKind::half_space;
  int sign = 1;
  Feature feature = {};
};

// Unions of pieces.

/// One piece: the intersection in which the constraints `all` are at most 0. `around` and `beyond` save work;
/// they do not change the union. Where the piece holds, the constraints `around` it hold too. The piece may
/// be restricted to where `beyond` is at least 0, because another piece covers the rest. `ball` is a
/// quadratic constraint of `all` that no other piece has. Its roots are costly: the exact stage computes them
/// last, and only while the rest holds.
struct Conditions {
  std::vector<int> all, around = {}, beyond = {};
  int ball = -1;  ///< -1: no such constraint
};

/// A union of pieces, each the intersection of constraints, which are named by number: what the exact stage reads of
/// any contact set.
///
///   ConstraintUnion pieces;
///   pieces.add_piece({.all = {0, 1, 2}});                       // constraints 0, 1 and 2 hold
class ConstraintUnion {
 public:
  /// A range of the list of members.
  struct Part {
    std::uint32_t begin, end;
  };
  struct Piece {
    Part all, around, beyond;
    int ball;
  };

  void add_piece(const Conditions& conditions) {
    const Part all = add(conditions.all), around = add(conditions.around), beyond = add(conditions.beyond);
    pieces_.push_back({all, around, beyond, conditions.ball});
  }

  std::span<const Piece> pieces() const { return pieces_; }
  std::span<const int> members(const Part& part) const {
    return {members_.data() + part.begin, members_.data() + part.end};
  }

 protected:
  std::vector<Piece> pieces_;
  std::vector<int> members_;

 private:
  Part add(const std::vector<int>& members) {
    const auto begin = static_cast<std::uint32_t>(members_.size());
    members_.insert(members_.end(), members.begin(), members.end());
    return {begin, static_cast<std::uint32_t>(members_.size())};
  }
};

// Sizes.

/// value + rate tau, with rate >= 0.
template <class T>
struct MovingSize {
  T value = {}, rate = {};
  bool moves = false;
};

template <class T>
MovingSize<T> expanded_at(const MovingSize<T>& size, double tau) {
  if (!size.moves) return size;
  return {size.value + T{tau} * size.rate, size.rate, true};
}

/// The size at `end`, when it is largest.
inline Bounded largest(const MovingSize<Bounded>& size, double end) {
  return expanded_at(size, end).value;
}

/// Whether the size may be above 0.
inline bool is_of_size(const MovingSize<Bounded>& size) {
  return size.value.value > 0 || size.moves;
}

/// The factor 1, without a multiplication.
struct Once {
  template <class T>
  friend const T& operator*(const T& size, Once) {
    return size;
  }
};

/// Subtracts size * factor from a polynomial.
template <int K, class T, class Factor>
[[gnu::always_inline]] inline void subtract_multiple(Coefficients<T, K>& p, const MovingSize<T>& size,
                                                     const Factor& factor) {
  p[0] = p[0] - size.value * factor;
  if constexpr (K > 0)
    if (size.moves) p[1] = p[1] - size.rate * factor;
}

/// Subtracts size^2 * factor from a polynomial.
template <int K, class T, class Factor>
[[gnu::always_inline]] inline void subtract_square_multiple(Coefficients<T, K>& p, const MovingSize<T>& size,
                                                            const Factor& factor) {
  p[0] = p[0] - square(size.value) * factor;
  if constexpr (K > 1)
    if (size.moves) {
      p[1] = p[1] - twice(size.value * size.rate) * factor;
      p[2] = p[2] - square(size.rate) * factor;
    }
}

// Polynomials.

/// Adds the square of q to the coefficients of p, except for p[0].
template <int K, class T>
[[gnu::always_inline]] inline void add_square_above(Coefficients<T, 2 * K>& p, const Coefficients<T, K>& q) {
  if constexpr (K == 1) {
    p[1] = p[1] + twice(q[0] * q[1]);
    p[2] = p[2] + square(q[1]);
  }
  if constexpr (K == 2) {
    p[1] = p[1] + twice(q[0] * q[1]);
    p[2] = p[2] + (square(q[1]) + twice(q[0] * q[2]));
    p[3] = p[3] + twice(q[1] * q[2]);
    p[4] = p[4] + square(q[2]);
  }
}

/// The squared length of `gaps` minus R^2. `wanted` is called with the value at tau = 0. If it returns false,
/// then the other coefficients are unspecified.
template <int K, std::size_t N, class T, class Wanted>
[[gnu::always_inline]] inline Coefficients<T, 2 * K> ball_polynomial(
    const std::array<Coefficients<T, K>, N>& gaps, const MovingSize<T>& radius, Wanted&& wanted) {
  Coefficients<T, 2 * K> p{};
  p[0] = -square(radius.value);
  for (const Coefficients<T, K>& gap : gaps) p[0] = p[0] + square(gap[0]);
  if (K == 0 || !wanted(p[0])) return p;
  if constexpr (K > 0)
    if (radius.moves) {
      p[1] = -twice(radius.value * radius.rate);
      p[2] = -square(radius.rate);
    }
  for (const Coefficients<T, K>& gap : gaps) add_square_above<K>(p, gap);
  return p;
}

template <class T, std::size_t N>
T squared_length(const std::array<T, N>& a) {
  T sum = square(a[0]);
  for (std::size_t j = 1; j < N; ++j) sum = sum + square(a[j]);
  return sum;
}

/// d minus the origin of the feature. `x`: d by powers of time; it may have more axes.
template <int K, class Feature, class T, std::size_t D>
std::array<Coefficients<T, K>, Feature::axes> gap_from(const Constraint<Feature>& constraint,
                                                       const std::array<Coefficients<T, K>, D>& x) {
  const auto at = constraint.feature.template origin<T>(constraint.sign);
  std::array<Coefficients<T, K>, Feature::axes> gap;
  for (std::size_t j = 0; j < gap.size(); ++j) gap[j] = x[j], gap[j][0] = gap[j][0] - at[j];
  return gap;
}

/// The signed distance of d beyond the plane or line, times the length of `direction`.
template <int K, class Feature, class T, std::size_t D>
Coefficients<T, K> beyond(const Constraint<Feature>& constraint,
                          const std::array<T, Feature::axes>& direction,
                          const std::array<Coefficients<T, K>, D>& x) {
  const auto at = constraint.feature.template origin<T>(constraint.sign);
  Coefficients<T, K> p{};
  for (std::size_t k = 0; k <= K; ++k) {
    const auto along = [&](std::size_t j) {
      return Feature::product(direction[j], k == 0 ? x[j][0] - at[j] : x[j][k]);
    };
    T sum = along(0);
    for (std::size_t j = 1; j < at.size(); ++j) sum = sum + along(j);
    p[k] = constraint.sign < 0 ? -sum : sum;
  }
  return p;
}

/// beyond() along the direction of the feature.
template <int K, class Feature, class T, std::size_t D>
Coefficients<T, K> beyond(const Constraint<Feature>& constraint, const std::array<Coefficients<T, K>, D>& x) {
  return beyond<K>(constraint, constraint.feature.template direction<T>(), x);
}

/// The squared distance from the plane, line or point, minus R^2; for planes and lines times the squared
/// length of the direction. Requires: a quadratic constraint.
template <int K, class Feature, class T, std::size_t D>
Coefficients<T, 2 * K> round_polynomial(const Constraint<Feature>& constraint,
                                        const std::array<Coefficients<T, K>, D>& x,
                                        const MovingSize<T>& radius) {
  if (constraint.kind == ConstraintKind::ball)
    return ball_polynomial<K>(gap_from<K>(constraint, x), radius, [](const T&) { return true; });
  Coefficients<T, 2 * K> p{};
  const auto direction = constraint.feature.template direction<T>();
  const auto add = [&p](const Coefficients<T, K>& q) {
    p[0] = p[0] + square(q[0]);
    add_square_above<K>(p, q);
  };
  if (constraint.kind == ConstraintKind::slab) {
    add(beyond<K>(constraint, direction, x));
  } else if constexpr (Feature::axes == 3) {
    const auto gap = gap_from<K>(constraint, x);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t one = (j + 1) % 3, other = (j + 2) % 3;
      Coefficients<T, K> cross{};
      for (std::size_t k = 0; k <= K; ++k)
        cross[k] = gap[one][k] * direction[other] - gap[other][k] * direction[one];
      add(cross);
    }
  }
  subtract_square_multiple<2 * K>(p, radius, squared_length(direction));
  return p;
}

/// The polynomial of a half space. Features of prisms are also faces along the last axis, at the heights of
/// the sizes.
template <int K, class Feature, class T, std::size_t D, class Sizes>
Coefficients<T, K> half_space_polynomial(const Constraint<Feature>& constraint,
                                         const std::array<Coefficients<T, K>, D>& x, const Sizes& sizes) {
  if constexpr (requires { constraint.feature.is_face_along_z(); })
    if (constraint.feature.is_face_along_z()) {
      Coefficients<T, K> p = x[D - 1];
      if (constraint.sign < 0)
        for (T& c : p) c = -c;
      subtract_multiple<K>(p, constraint.sign < 0 ? sizes.below : sizes.above, Once{});
      return p;
    }
  return beyond<K>(constraint, x);
}

/// Calls `take` with the polynomial of a constraint: of degree K if it is linear, else 2 K. `x` and `sizes`:
/// by powers of the time after one instant. `sizes.radius` is R.
template <int K, class Feature, class T, std::size_t D, class Sizes, class Take>
auto with_polynomial(const Constraint<Feature>& constraint, const std::array<Coefficients<T, K>, D>& x,
                     const Sizes& sizes, Take&& take) {
  if (constraint.kind == ConstraintKind::half_space)
    return take(half_space_polynomial<K>(constraint, x, sizes));
  return take(round_polynomial<K>(constraint, x, sizes.radius));
}

}  // namespace foresee
