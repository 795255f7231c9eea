// The constraints of two convex pieces in the plane (constraint/constraint.h), and the sizes of their pair.
//
// Two pieces touch while d is inside all edges of their Minkowski sum: half spaces. If the contact distance R
// is more than 0, d may also be beside an edge and at most R from its line: a slab between the half spaces of
// its ends. Or it is at most R from a corner: a ball. Prisms are also bounded along z.
#pragma once

#include "contact/constraint/constraint.h"
#include "contact/minkowski/contact_set.h"
#include "contact/outline/object_pieces.h"
#include "contact/setup.h"

namespace foresee {

/// An edge of the sum, or its start for a ball; or a face of a prism.
struct FlatFeature {
  static constexpr int axes = 2;

  enum class Direction : std::uint8_t {
    outward,  ///< normal to the edge, to the right of it
    along,    ///< that of the edge, from its start (sign -1) or its end (1)
    up        ///< along z: of half spaces alone, below the upper face (sign 1) or above the lower one (-1)
  };
  Direction towards = Direction::outward;
  SumEdge edge = {};

  bool is_face_along_z() const { return towards == Direction::up; }
  /// The direction of an edge may be longer than the edge. Always inlined, because each constraint of a pair needs
  /// it.
  template <class T>
  [[gnu::always_inline]] std::array<T, 2> direction() const {
    const std::array<T, 2> run = gap_between<T>(*edge.to, *edge.from);
    return towards == Direction::along ? run : std::array<T, 2>{run[1], -run[0]};
  }
  template <class T>
  std::array<T, 2> origin(int sign) const {
    if (towards == Direction::along && sign > 0) return gap_between<T>(*edge.p_end, *edge.q_end);
    return gap_between<T>(*edge.p, *edge.q);
  }
  template <class T>
  static T product(const T& a, const T& b) {
    return a * b;
  }
};

using FlatConstraint = Constraint<FlatFeature>;

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

}  // namespace foresee
