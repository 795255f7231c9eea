// Roots of a quadratic with a positive discriminant, computed without cancellation.
#pragma once

#include <array>

namespace foresee {

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
