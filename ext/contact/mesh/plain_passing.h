// What do plain doubles tell of two triangles that pass each other? The first question about a pair of them,
// which lets most go, and saves the rest most of what is asked with error bounds.
//
//   const PlainPassing passing = plain_passing(a, b, x, radius, asked);
//   if (passing.is_apart() || passing.near.begin > by) return;      // else they may touch by then
//   SpaceHull(a, b).for_each(take, passing.axes);                   // the planes that matter
//
// Whatever direction n is, the two touch only while n d lies between the least and the greatest of n (p - q)
// over their corners. So the roundings of n do no harm, and those of the products are far less than the slack
// that all of it is given. Where d is bent its chord stands for it, and how far it can be beside that
// (chord.h). What lies between both by more than the slack, and the roundings of n, as long as the other axes
// let them touch has no say in when they do. Cost: some hundred nanoseconds.
#pragma once

#include "contact/certain/certified.h"
#include "contact/mesh/space_condition.h"
#include "contact/pieces/stays.h"

namespace foresee {

struct PlainPassing {
  Period<double> near;  ///< they touch at no other moments
  unsigned axes;        ///< a bit for each that may say when they touch: numbered as SpaceHull has them

  bool is_apart() const { return !(near.begin <= near.end); }
};

/// `x`: d by powers of the time from now on. Requires: two triangles.
PlainPassing plain_passing(const SpacePiece& a, const SpacePiece& b,
                           const std::array<Powers<Bounded, 2>, 3>& x, const Bounded& radius,
                           const Stay& asked);

}  // namespace foresee
