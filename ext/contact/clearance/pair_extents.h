// The set of relative positions at which two objects touch, and its support function.
//
//   const PairRule rule(ships.layout, ships.layout, 926);
//   const PairExtents<2> pair = extents_of_both<2>(rule, row_a, row_b, 600);  // radius = r_a + r_b + 926
//
// Points, discs, balls, boxes, cylinders and their mixtures give one convex set: a box, grown by a radius on
// all axes or in x and y alone. Outlines and prisms give one set per pair of convex pieces, whose Minkowski
// sum replaces the box in x and y (piece_sum.h). Meshes have none. The sets are those of contact, by the same
// rule (pair_rule.h), with lengths rounded up: a point outside does not touch.
#pragma once

#include "contact/clearance/piece_sum.h"
#include "contact/pair_rule.h"
#include "motion/motion.h"

namespace foresee {

/// A box of half extents `half` around the origin, whose first `round_axes` axes are grown together by
/// `radius`. A `sum`, if not null, replaces the box in x and y, where half is 0 then.
template <int D>
struct PairExtents {
  Vec<D> half;
  double radius;
  int round_axes;
  const PieceSum* sum = nullptr;

  void add(const PairExtents& more, double times = 1) {
    half += times * more.half;
    radius += times * more.radius;
  }

  /// Upper bound of the support function along n.
  double support(const Vec<D>& n) const {
    double along = 0;
    if constexpr (D > 1)
      if (sum) along = sum->support(n[0], n[1]);
    return support_with(n, along);
  }
  /// support(n), where that of the sum is `along`.
  double support_with(const Vec<D>& n, double along) const {
    const Vec<D> size = n.abs();
    double square = 0;
    for (int axis = 0; axis < round_axes; ++axis) square += n[axis] * n[axis];
    const double reach = (half * size).sum() + radius * std::sqrt(square) + along;
    const double magnitude =
        (half.abs() * size).sum() + std::abs(radius) * std::sqrt(square) + std::abs(along);
    return reach + (magnitude * 0x1p-49 + 0x1p-1000);
  }

  /// Approximate upper bound of the distance from the origin on each axis.
  double size() const { return half.abs().largest() + std::abs(radius) + (sum ? sum->size() : 0); }
};

/// The extents at a time, and their growth per unit of time. Before both objects exist, sizes may be
/// negative.
template <int D>
struct GrowingExtents : PairExtents<D> {
  PairExtents<D> growth{Vec<D>::zero(), 0, D};
  bool grows = false;

  /// Whether what passes along this axis, or along any, is in contact for an instant only.
  bool is_thin(int axis) const { return !grows && !this->sum && this->half[axis] == 0 && this->radius == 0; }
  bool is_thin() const {
    bool thin = false;
    for (int axis = 0; axis < D; ++axis) thin = thin || is_thin(axis);
    return thin;
  }
  PairExtents<D> after(double tau) const {
    PairExtents<D> extents = *this;
    if (grows) extents.add(growth, tau);
    return extents;
  }
};

}  // namespace foresee
