// At which places, seen from one object, does another touch it? For points, discs, balls, boxes, cylinders
// and their mixtures that is one convex set: a box, grown round by a radius on all axes or in x and y alone.
// For outlines and prisms it is one for each pair of their convex pieces, whose sum takes the place of the
// box in x and y (piece_sum.h).
//
//   const ExtentsRule rule(ships.layout, ships.layout, 926, std::nullopt);
//   const PairExtents<2> pair = rule.pair<2>(row_a, row_b, 600);  // half = {0, 0}, radius = r_a + r_b + 926
//
// The sets are those of the room's door (make_contact.cpp), with lengths rounded up: what does not touch this
// does not touch. Meshes have none.
#pragma once

#include <optional>

#include "contact/clearance/piece_sum.h"
#include "motion/motion.h"
#include "shape/layout.h"

namespace foresee {

/// Within `half` of the origin on every axis, and in `sum`, if there is one, in x and y, where half is 0
/// then; the first `round_axes` axes grown together by `radius`.
template <int D>
struct PairExtents {
  Vec<D> half;
  double radius;
  int round_axes;
  const PieceSum* sum = nullptr;

  void add(const PairExtents& more, double times = 1) {
    half += times * more.half, radius += times * more.radius;
  }

  /// How far it reaches along n, at least.
  double support(const Vec<D>& n) const {
    const Vec<D> size = n.abs();
    double square = 0;
    for (int axis = 0; axis < round_axes; ++axis) square += n[axis] * n[axis];
    double reach = (half * size).sum() + radius * std::sqrt(square);
    double magnitude = (half.abs() * size).sum() + std::abs(radius) * std::sqrt(square);
    if constexpr (D > 1)
      if (sum) {
        const double along = sum->support(n[0], n[1]);
        reach += along, magnitude += std::abs(along);
      }
    return reach + (magnitude * 0x1p-49 + 0x1p-1000);
  }

  /// How far from the origin on any axis, roughly.
  double size() const { return half.abs().maxCoeff() + std::abs(radius) + (sum ? sum->size() : 0); }
};

/// As of a moment, and how much larger it is a unit of time later. Before the two are there it may be less
/// than nothing.
template <int D>
struct GrowingExtents : PairExtents<D> {
  PairExtents<D> growth{Vec<D>::Zero(), 0, D};
  bool grows = false;

  PairExtents<D> after(double tau) const {
    PairExtents<D> extents = *this;
    if (grows) extents.add(growth, tau);
    return extents;
  }
};

class ExtentsRule {
 public:
  /// `within`, `within_z`: as for contact.
  ExtentsRule(const Layout& a, const Layout& b, double within, std::optional<double> within_z);

  /// As of a moment.
  template <int D>
  GrowingExtents<D> pair(const double* row_a, const double* row_b, double time) const;

 private:
  struct Side {
    Layout layout;
    Offsets at;
  };
  /// Of both, as `size` says: of which quantity (half, r, hz), along which axis.
  template <int D, class Size>
  PairExtents<D> composed(const Size& size, double within, double within_z) const;

  Side a_, b_;
  bool upright_ = false, round_ = false;
  bool pieces_ = false;  ///< boxes too are pieces, in x and y
  double within_, within_z_;
};

}  // namespace foresee
