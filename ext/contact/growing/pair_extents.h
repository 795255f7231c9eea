// At which places, seen from one object, does another touch it? For points, discs, balls, boxes, cylinders
// and their mixtures that is one convex set: a box, grown round by a radius on all axes or in x and y alone.
//
//   const ExtentsRule rule(ships.layout, ships.layout, 926, std::nullopt);
//   const PairExtents<2> pair = rule.pair<2>(row_a, row_b);       // half = {0, 0}, radius = r_a + r_b + 926
//
// The sets are those of the room's door (make_contact.cpp), with lengths rounded up: what does not touch this
// does not touch. Outlines and meshes have none.
#pragma once

#include <optional>

#include "motion/vec.h"
#include "shape/layout.h"

namespace foresee::contact {

/// Within `half` of the origin on every axis; the first `round_axes` axes grown together by `radius`.
template <int D>
struct PairExtents {
  Vec<D> half;
  double radius;
  int round_axes;

  /// How far it reaches along n, at least.
  double most(const Vec<D>& n) const {
    const Vec<D> size = n.abs();
    double square = 0;
    for (int axis = 0; axis < round_axes; ++axis) square += n[axis] * n[axis];
    return ((half * size).sum() + radius * std::sqrt(square)) * (1 + 0x1p-49) + 0x1p-1000;
  }
};

class ExtentsRule {
 public:
  /// `within`, `within_z`: as for contact.
  ExtentsRule(const Layout& a, const Layout& b, double within, std::optional<double> within_z);

  template <int D>
  PairExtents<D> pair(const double* row_a, const double* row_b) const;

 private:
  Offsets a_, b_;
  bool upright_ = false, round_ = false;
  double within_, within_z_;
};

}  // namespace foresee::contact
