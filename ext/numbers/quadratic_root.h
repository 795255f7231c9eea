// Exact sign of a polynomial at a root of a quadratic or linear one, without computing the root.
//
// At r = (-b + which sqrt D) / 2a every polynomial is alpha + beta sqrt D, up to a positive factor: its
// remainder after division by the quadratic is linear. The signs of alpha and beta decide; if they differ,
// that of alpha^2 - beta^2 D does. Cost: about twenty products, no iteration.
#pragma once

#include "numbers/polynomial.h"

namespace foresee {

/// The sign of q at a root of p. `which`: -1 the lesser root, 1 the greater, 0 the only one.
/// Requires: p has degree 1 or 2 and has that root.
int sign_at_root(const Polynomial& q, const Polynomial& p, int which);

}  // namespace foresee
