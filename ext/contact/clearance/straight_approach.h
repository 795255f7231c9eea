// Nearest approach of a straight path to a convex set, and the normal of a plane between them, in plain
// doubles.
//
//   const StraightApproach<2> approach = straight_approach(extents, x, v, 0, 600);
//   approach.gap > 0        // the path probably keeps clear; approach.normal is that of a separating plane
//
// The result is a guess that others prove. The distance from a convex set along a straight line is a convex
// function of time. A falling and a rising tangent bound it from below; the mixture of their normals at the
// crossing is perpendicular to the path. The crossing is the next time to evaluate (Kelley's cutting-plane
// method, 1960). A disc takes one evaluation, a box as many as it has edges on the path, and a sum of pieces
// that the path passes on one side takes none. A growing set takes some more: its distance is convex too, as the
// growth along a normal is.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/clearance/pair_extents.h"
#include "contact/clearance/trajectory_family.h"

namespace foresee {

/// The signed distance of a position from the set on the round axes: below 0 inside. `over`: its distance
/// beyond the half extents.
template <int D>
double signed_distance_in_round_axes(const PairExtents<D>& extents, const Vec<D>& over, const Vec<D>& place,
                                     Vec<D>& normal) {
  if constexpr (D > 1)
    if (extents.sum)
      return extents.sum->signed_distance(place[0], place[1], normal[0], normal[1]) - extents.radius;
  double square = 0, farthest = -std::numeric_limits<double>::infinity();
  int face = 0;
  for (int axis = 0; axis < extents.round_axes; ++axis) {
    if (over[axis] > 0) square += over[axis] * over[axis];
    if (over[axis] > farthest) farthest = over[axis], face = axis;
  }
  if (!(square > 0)) {
    normal[face] = std::copysign(1.0, place[face]);
    return farthest - extents.radius;
  }
  const double length = std::sqrt(square);
  for (int axis = 0; axis < extents.round_axes; ++axis)
    if (over[axis] > 0) normal[axis] = std::copysign(over[axis] / length, place[axis]);
  return length - extents.radius;
}

/// The signed distance of a position from the set: below 0 inside. `normal`: its gradient.
template <int D>
double signed_distance(const PairExtents<D>& extents, const Vec<D>& place, Vec<D>& normal) {
  const Vec<D> over = place.abs() - extents.half;
  normal = Vec<D>::zero();
  double outside = signed_distance_in_round_axes<D>(extents, over, place, normal);
  for (int axis = extents.round_axes; axis < D; ++axis)
    if (over[axis] > outside) {
      outside = over[axis];
      normal = Vec<D>::zero();
      normal[axis] = std::copysign(1.0, place[axis]);
    }
  return outside;
}

template <int D>
struct StraightApproach {
  double tau, gap;  ///< approximately the time of the nearest approach, and the signed distance then
  Vec<D> normal;
};

/// Of a line that passes the sum of two pieces on one side, nearest between begin and end: there the plane along the
/// line separates them. Else nothing.
inline std::optional<StraightApproach<2>> passing_line(const PairExtents<2>& extents, const Vec<2>& x,
                                                       const Vec<2>& v, double begin, double end) {
  const double square = (v * v).sum();
  if (!(square > 0)) return std::nullopt;
  const double speed = std::sqrt(square);
  Vec<2> normal{v[1] / speed, -v[0] / speed};
  double lateral = (x * normal).sum();
  if (lateral < 0) normal = -normal, lateral = -lateral;
  const Corner corner = extents.sum->farthest(normal[0], normal[1]);
  const double gap = lateral - (corner.x * normal[0] + corner.y * normal[1]);
  const double tau = ((corner.x - x[0]) * v[0] + (corner.y - x[1]) * v[1]) / square;
  if (gap > 0) {
    if (!(begin <= tau && tau <= end)) return std::nullopt;
    return StraightApproach<2>{tau, gap - extents.radius, normal};
  }
  const auto [from, to] = extents.sum->crossing(x[0], x[1], v[0], v[1], begin, end);
  if (!(from < to)) return std::nullopt;
  StraightApproach<2> middle;
  middle.tau = from + 0.5 * (to - from);
  middle.gap = signed_distance<2>(extents, x + middle.tau * v, middle.normal);
  return middle;
}

/// Of x + v tau during [begin, end]. Requires: begin <= end, both finite.
template <int D>
StraightApproach<D> straight_approach(const GrowingExtents<D>& extents, const Vec<D>& x, const Vec<D>& v,
                                      double begin, double end) {
  if constexpr (D == 2)
    if (extents.sum && !extents.grows)
      if (const auto passing = passing_line(extents.after(begin), x, v, begin, end)) return *passing;
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
  // Nearest to the centre and nearly to the set, as for a disc: the rest of the slope is rounding.
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
    const double lower_bound = fall.gap + fall.slope * step;
    const Vec<D> between = (rise.slope * fall.normal - fall.slope * rise.normal) / turn;
    const Tangent middle = at(fall.tau + step);
    best = {middle.tau, middle.gap, between};
    if (middle.gap - lower_bound <= 0.03 * std::abs(middle.gap)) break;
    if (!(middle.tau > fall.tau && middle.tau < rise.tau)) break;
    (middle.slope < 0 ? fall : rise) = middle;
  }
  return best;
}

/// Approximately the time during [begin, end] at which a bent path is deepest inside: the best of some
/// samples and `tau`, refined.
template <int D>
double deepest_time(const GrowingExtents<D>& extents, const TrajectoryEstimate<D>& path, double begin,
                    double end, double tau) {
  Vec<D> ignored;
  const auto distance = [&](double at) {
    return signed_distance<D>(extents.after(at), place_at<D>(path, at), ignored);
  };
  double best = tau, min_distance = distance(tau), step = (end - begin) / sampled_times;
  const auto evaluate_at = [&](double at) {
    const double here = distance(at);
    if (here < min_distance) best = at, min_distance = here;
  };
  for (int i = 0; i <= sampled_times; ++i) evaluate_at(std::min(begin + i * step, end));
  for (int evaluation = 0; evaluation < 12; ++evaluation) {
    step *= 0.5;
    const double middle = best;
    evaluate_at(std::max(begin, middle - step));
    evaluate_at(std::min(end, middle + step));
  }
  return best;
}

/// The time near tau at which a path passes a set without thickness: a step of Newton's method.
template <int D>
double passing_time(const GrowingExtents<D>& extents, const TrajectoryEstimate<D>& path, double tau) {
  for (int axis = 0; axis < D; ++axis) {
    if (!extents.is_thin(axis)) continue;
    const double speed = path.v[axis] + tau * path.a[axis];
    if (speed != 0) tau -= place_at<D>(path, tau)[axis] / speed;
  }
  return tau;
}

}  // namespace foresee
