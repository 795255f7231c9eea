// What must hold while two pieces touch: each condition a polynomial in time that is at most 0 then, written
// once for every number type.
//
// Two pieces touch while d is inside of all edges of their sum. If R is how near counts as touching, it may
// also be beside an edge and at most R from its line, or at most R from a corner: the sum grown by R is the
// union of these.
#pragma once

#include "contact/outline/convex_sum.h"
#include "contact/pieces/moving_size.h"
#include "contact/set/minkowski_sum.h"
#include "contact/set/relative_motion.h"

namespace foresee {

struct Condition {
  enum class Kind : std::uint8_t {
    edge,    ///< inside of it
    side,    ///< at most R from its line
    foot,    ///< beside it, seen from its begin (sign -1) or its end (1)
    corner,  ///< at most R from its begin
    height   ///< between the faces across z, below the upper (1) or above the lower (-1)
  };
  Kind kind = Kind::edge;
  int sign = 1;
  SumEdge edge = {};
};

/// What the rows of a pair say beside the pieces, and the question: R, and how far b may lie below and above
/// a along z that just touches it. A window need not have both faces there.
template <class T>
struct PairSizes {
  MovingSize<T> radius, below, above;
  bool has_below = true, has_above = true;

  bool has_face(int side) const { return side < 0 ? has_below : has_above; }
};

/// Where an object's half height stands in its row: that of a prism, cylinder or box.
inline int place_of_half_height(const Offsets& at) {
  return at.hz != Offsets::absent || at.half == Offsets::absent ? at.hz : at.half + 2;
}

template <class T>
PairSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b) {
  const TwoRows<T> rows{row_a, row_b};
  const bool any_grows = grows(setup.a.layout) || grows(setup.b.layout);
  const auto sum = [&](int place_a, int place_b, int axis, double more) {
    MovingSize<T> size{rows.in_both(place_a, place_b) + Exactly<T>::number(more)};
    if (!any_grows) return size;
    const Length growth = growth_of_both(setup, axis);
    size.moves = value_or(row_a, growth.a, 0) > 0 || value_or(row_b, growth.b, 0) > 0;
    if (size.moves)
      size.value = size.value + rows.growth(growth), size.rate = rows.in_both(growth.a, growth.b);
    return size;
  };
  const auto height = [&](double more) {
    return sum(place_of_half_height(setup.a.at), place_of_half_height(setup.b.at), 2, more);
  };
  PairSizes<T> sizes{sum(setup.a.at.r, setup.b.at.r, 0, setup.within), {}, {}};
  if (setup.a.layout.axes < 3) return sizes;
  if (!setup.window) {
    sizes.below = sizes.above = height(setup.within_z);
    return sizes;
  }
  const WindowFaces& faces = *setup.window;  // a is where the axes meet
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

/// The square of its line, or of the gap to its corner, minus that of R. Requires: of kind side or corner.
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

/// Gives `take` the polynomial of a condition. `x`: d by powers of the time after some moment, of which the
/// sizes are too.
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
