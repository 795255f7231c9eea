// Do two triangles pass each other, as plain doubles tell? The first question about a pair of them, which
// lets most go.
//
//   if (are_plainly_apart(a, b, x, radius, asked)) return;      // they never touch; false: they may
//
// Whatever direction n is, the two touch only while n d lies between the least and the greatest of n (p - q)
// over their corners. So the roundings of n do no harm, and those of the products are far less than the slack
// that all of it is given. Where d is bent its chord stands for it, and how far it can be beside that
// (chord.h). Cost: some hundred nanoseconds.
#pragma once

#include "contact/mesh/space_condition.h"
#include "contact/pieces/stays.h"

namespace foresee::contact {

/// `x`: d by powers of the time from now on. Requires: two triangles.
bool are_plainly_apart(const SpacePiece& a, const SpacePiece& b, const std::array<Powers<Bounded, 2>, 3>& x,
                       const Bounded& radius, const Stay& asked);

}  // namespace foresee::contact
