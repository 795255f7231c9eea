// Exact sign of a polynomial at a root of a quadratic or linear one, without computing the root.
//
// At r = (-b + which sqrt D) / 2a every polynomial is alpha + beta sqrt D, up to a positive factor: its
// remainder after division by the quadratic is linear. The signs of alpha and beta decide; if they differ,
// that of alpha^2 - beta^2 D does. Cost: about twenty products, no iteration.
#pragma once

#include <array>

#include "numbers/polynomial.h"

namespace foresee {

/// The sign of q at a root of p. `which`: -1 the lesser root, 1 the greater, 0 the only one.
/// Requires: p has degree 1 or 2 and has that root.
int sign_at_root(const Polynomial& q, const Polynomial& p, int which);

// Roots of a quadratic with a positive discriminant, computed without cancellation.

/// Returns c2 times one root, which is c0 divided by the other. `d` = c1^2 - 4 c0 c2; its sign and that of c1
/// are known.
template <class N, std::size_t Size>
N product_of_root(const std::array<N, Size>& c, const N& d) {
  // -b and the root of D have the same sign: nothing cancels.
  const N root = sqrt(d);
  return half_of(c[1].sign() >= 0 ? -c[1] - root : root - c[1]);
}

/// The lesser root (which -1) or the greater (1). Requires: the signs of c1 and c2 are known, c2 not 0.
template <class N, std::size_t Size>
N root_of_quadratic(const std::array<N, Size>& c, const N& product, int which) {
  const int first = (c[1].sign() >= 0) == (c[2].sign() > 0) ? -1 : 1;
  return which == first ? product / c[2] : c[0] / product;
}

}  // namespace foresee
