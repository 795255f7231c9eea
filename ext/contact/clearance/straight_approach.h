// Where is a straight path nearest to a convex set, and which plane stands between them? Found in plain
// doubles: a guess that others prove.
//
//   const StraightApproach<2> near = straight_approach(extents, x, v, 0, 600);
//   near.gap > 0                 // the path probably keeps clear; near.normal is a separating plane's
//
// The distance from a convex set along a straight line is a convex function of time. Two tangents of it, one
// falling and one rising, bound it from below where they cross; that mixture of their normals is square to
// the path. The crossing is the next place to look (Kelley's method of cutting planes, 1960). A disc takes
// one look, a box as many as it has edges in the way. A set that grows takes some looks more: the distance
// from it is convex too, as what it grows by along a normal is.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/clearance/pair_extents.h"

namespace foresee {

/// How far outside the set a place is in the axes that are round together: below 0 within. `over`: beyond
/// half extents.
template <int D>
double signed_distance_in_round_axes(const PairExtents<D>& extents, const Vec<D>& over, const Vec<D>& place,
                                     Vec<D>& normal) {
  if constexpr (D > 1)
    if (extents.sum)
      return extents.sum->signed_distance(place[0], place[1], normal[0], normal[1]) - extents.radius;
  double square = 0, most = -std::numeric_limits<double>::infinity();
  int face = 0;
  for (int axis = 0; axis < extents.round_axes; ++axis) {
    if (over[axis] > 0) square += over[axis] * over[axis];
    if (over[axis] > most) most = over[axis], face = axis;
  }
  if (!(square > 0)) {
    normal[face] = std::copysign(1.0, place[face]);
    return most - extents.radius;
  }
  const double length = std::sqrt(square);
  for (int axis = 0; axis < extents.round_axes; ++axis)
    if (over[axis] > 0) normal[axis] = std::copysign(over[axis] / length, place[axis]);
  return length - extents.radius;
}

/// How far outside the set a place is: below 0 within. `normal`: which way it grows.
template <int D>
double signed_distance(const PairExtents<D>& extents, const Vec<D>& place, Vec<D>& normal) {
  const Vec<D> over = place.abs() - extents.half;
  normal.setZero();
  double outside = signed_distance_in_round_axes<D>(extents, over, place, normal);
  for (int axis = extents.round_axes; axis < D; ++axis)
    if (over[axis] > outside) {
      outside = over[axis];
      normal.setZero();
      normal[axis] = std::copysign(1.0, place[axis]);
    }
  return outside;
}

template <int D>
struct StraightApproach {
  double tau, gap;  ///< the nearest moment, nearly; how far outside it is then
  Vec<D> normal;
};

/// Of x + v tau during [begin, end]. Requires: begin <= end, both finite.
template <int D>
StraightApproach<D> straight_approach(const GrowingExtents<D>& extents, const Vec<D>& x, const Vec<D>& v,
                                      double begin, double end) {
  struct Tangent {
    double tau, gap, slope;
    Vec<D> normal;
  };
  const auto at = [&](double tau) {
    Tangent tangent;
    tangent.tau = tau;
    tangent.gap = signed_distance<D>(extents.after(tau), x + tau * v, tangent.normal);
    tangent.slope = (tangent.normal * v).sum();
    if (extents.grows) tangent.slope -= extents.growth.support(tangent.normal);
    return tangent;
  };
  const auto answer = [](const Tangent& t) { return StraightApproach<D>{t.tau, t.gap, t.normal}; };
  const double square = (v * v).sum(), nearest = square > 0 ? -(x * v).sum() / square : begin;
  Tangent first = at(std::clamp(nearest, begin, end));
  const double level = 0x1p-50 * (first.normal * v).abs().sum();
  if (std::abs(first.slope) <= level) return answer(first);
  // Nearest to the middle and nearly to the set, as of a disc: what is left of the slope is rounding.
  if (!extents.grows && first.tau == nearest && std::abs(first.slope) <= 0x1p20 * level) {
    first.normal -= (first.slope / square) * v;
    return answer(first);
  }
  Tangent fall = first, rise = first;
  if (first.slope > 0) {
    if (first.tau > begin) fall = at(begin);
    if (fall.slope >= 0) return answer(fall);
  } else {
    if (first.tau < end) rise = at(end);
    if (rise.slope <= 0) return answer(rise);
  }
  StraightApproach<D> best{};
  for (int evaluation = 0; evaluation < 40; ++evaluation) {
    const double span = rise.tau - fall.tau, turn = rise.slope - fall.slope;
    const double step = std::clamp((fall.gap - rise.gap + rise.slope * span) / turn, 0.0, span);
    const double least = fall.gap + fall.slope * step;
    const Vec<D> between = (rise.slope * fall.normal - fall.slope * rise.normal) / turn;
    const Tangent middle = at(fall.tau + step);
    best = {middle.tau, middle.gap, between};
    if (middle.gap - least <= 0.03 * std::abs(middle.gap)) break;
    if (!(middle.tau > fall.tau && middle.tau < rise.tau)) break;
    (middle.slope < 0 ? fall : rise) = middle;
  }
  return best;
}

}  // namespace foresee
