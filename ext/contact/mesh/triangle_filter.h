// Filter in plain doubles for two moving triangles: a bound on when they touch, and the separating axes that
// matter for it.
//
//   const TriangleFilter passing = filter_triangles(a, b, x, radius, queried);
//   if (passing.is_apart() || passing.near.begin > by) return;      // else they may touch by then
//   SpaceHull(a, b).for_each(take, passing.axes);                   // the planes that matter
//
// For any direction n, the two touch only while n d is between the minimum and the maximum of n (p - q)
// over their corners. So rounding errors of n are harmless, and those of the products are far smaller than
// the slack. An accelerated d is replaced by its chord, with a bound on the distance between both
// (chord.h). An axis does not matter if n d stays inside its bounds by more than the slack and the
// rounding errors of n, while the other axes let the two touch. This filter comes before all tests with
// error bounds: it rejects most pairs, and spares the rest most planes. Cost: some hundred nanoseconds.
#pragma once

#include "contact/certified/root_bracketing.h"
#include "contact/certified/uncertain_interval.h"
#include "contact/mesh/space_constraint.h"

namespace foresee {

struct TriangleFilter {
  Interval<double> near;  ///< they touch at no time outside of this
  unsigned axes;  ///< a bit for each axis that may bound the time of contact, in the order of SpaceHull

  bool is_apart() const { return !(near.begin <= near.end); }
};

/// `x`: d by powers of the time after now. Requires: two triangles.
TriangleFilter filter_triangles(const SpacePiece& a, const SpacePiece& b,
                                const std::array<Coefficients<Bounded, 2>, 3>& x, const Bounded& radius,
                                const UncertainInterval& queried);

}  // namespace foresee
