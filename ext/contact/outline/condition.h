// Conditions for contact of two convex pieces in the plane: each is a polynomial in time that is at most 0
// while it holds, written once for all number types.
//
// Two pieces touch while d is inside all edges of their Minkowski sum. Let R be the contact distance. If R is
// more than 0, d may also be beside an edge and at most R from its line, or at most R from a corner. The
// union of these sets is the sum grown by R.
#pragma once

#include "contact/outline/convex_sum.h"
#include "contact/pieces/time_expansion.h"
#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

struct Condition {
  enum class Kind : std::uint8_t {
    edge,    ///< d is inside the edge
    side,    ///< d is at most R from the edge's line
    foot,    ///< d is not before the start of the edge (sign -1) or not past its end (1)
    corner,  ///< d is at most R from the start of the edge
    height   ///< d is below the upper face across z (1) or above the lower (-1)
  };
  Kind kind = Kind::edge;
  int sign = 1;
  SumEdge edge = {};
};

/// The sizes of a pair, from its rows and the query: R, and how far b may be below and above a along z while
/// they touch. A window may lack one of these faces.
template <class T>
struct PairSizes {
  MovingSize<T> radius, below, above;
  bool has_below = true, has_above = true;

  bool has_face(int side) const { return side < 0 ? has_below : has_above; }
};

/// A size of the rule for one pair, from `now` on.
template <class T>
MovingSize<T> moving_size_of(const Setup& setup, const PairSize& size, const double* row_a,
                             const double* row_b) {
  MovingSize<T> sum{size_as_of_t<T>(size, row_a, row_b)};
  const PairRule& rule = setup.rule;
  if (!rule.grows) return sum;
  sum.moves = value_or(row_a, size.growth_a, 0) > 0 || value_or(row_b, size.growth_b, 0) > 0;
  if (!sum.moves) return sum;
  const TwoRows<T> rows{row_a, row_b};
  sum.value = sum.value + rows.growth({Length::From::growth, size.growth_a, size.growth_b, setup.horizon.now,
                                       true, rule.t_a, rule.t_b});
  sum.rate = rows.in_both(size.growth_a, size.growth_b);
  return sum;
}

template <class T>
PairSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b) {
  const PairRule& rule = setup.rule;
  PairSizes<T> sizes{moving_size_of<T>(setup, rule.radius, row_a, row_b), {}, {}};
  if (setup.a.layout.axes < 3) return sizes;
  if (!setup.window) {
    sizes.below = sizes.above = moving_size_of<T>(setup, rule.extent[2], row_a, row_b);
    return sizes;
  }
  const auto height = [&](double face) {
    PairSize height = rule.extent[2];
    height.limit = face;
    return moving_size_of<T>(setup, height, row_a, row_b);
  };
  const WindowFaces& faces = *setup.window;  // a is at the origin
  sizes.has_below = faces.has_lower(2), sizes.has_above = faces.has_upper(2);
  if (sizes.has_below) sizes.below = height(-faces.lower[2]);
  if (sizes.has_above) sizes.above = height(faces.upper[2]);
  return sizes;
}

template <class T>
PairSizes<T> expanded_at(const PairSizes<T>& sizes, double tau) {
  return {expanded_at(sizes.radius, tau), expanded_at(sizes.below, tau), expanded_at(sizes.above, tau),
          sizes.has_below, sizes.has_above};
}

/// The squared distance from the line or corner, minus R^2; for a line times the squared length of the edge's
/// direction. Requires: a condition of kind side or corner.
template <int K, class T>
Coefficients<T, 2 * K> round_polynomial(const Condition& condition, const Coefficients<T, K>* x,
                                        const MovingSize<T>& radius) {
  Coefficients<T, 2 * K> p{};
  if (condition.kind == Condition::Kind::side) {
    const Coefficients<T, K> line = beyond<K>(condition.edge, x);
    p[0] = square(line[0]);
    add_square_above<K>(p, line);
    subtract_square_multiple<2 * K>(p, radius, squared_length<T>(condition.edge));
    return p;
  }
  subtract_square_multiple<2 * K>(p, radius, Once{});
  for (int j = 0; j < 2; ++j) {
    Coefficients<T, K> gap = x[j];
    gap[0] = gap[0] - start_of<T>(condition.edge, j);
    p[0] = p[0] + square(gap[0]);
    add_square_above<K>(p, gap);
  }
  return p;
}

/// Calls `take` with the polynomial of a condition. `x` and `sizes`: by powers of the time after one instant.
template <int K, class T, std::size_t D, class Take>
auto with_polynomial(const Condition& condition, const std::array<Coefficients<T, K>, D>& x,
                     const PairSizes<T>& sizes, Take&& take) {
  switch (condition.kind) {
    case Condition::Kind::edge:
      return take(beyond<K>(condition.edge, x.data()));
    case Condition::Kind::foot:
      return take(past<K>(condition.edge, condition.sign, x.data()));
    case Condition::Kind::height: {
      Coefficients<T, K> p = x[D - 1];
      if (condition.sign < 0)
        for (T& c : p) c = -c;
      subtract_multiple<K>(p, condition.sign < 0 ? sizes.below : sizes.above, Once{});
      return take(p);
    }
    default:
      return take(round_polynomial<K>(condition, x.data(), sizes.radius));
  }
}

}  // namespace foresee
