// The sign of a polynomial at a root of a quadratic (or linear) one, exactly and without any root.
//
// At r = (-b + which sqrt D) / 2a every polynomial is alpha + beta sqrt D, up to a positive factor: its
// remainder on division by the quadratic is linear. The signs of alpha and beta, and if they differ that of
// alpha^2 - beta^2 D, decide. Cost: about twenty products, no loop that converges.
#pragma once

#include "numbers/polynomial.h"

namespace foresee {

/// p's roots are told apart by `which`: -1 the lesser, 1 the greater, 0 the only one.
/// Requires: p has degree 1 or 2 and has that root.
int sign_at_root(const Polynomial& q, const Polynomial& p, int which);

}  // namespace foresee
