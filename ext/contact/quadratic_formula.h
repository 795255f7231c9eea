// Both roots of a quadratic whose discriminant is positive, without cancellation.
#pragma once

#include <array>

namespace foresee {

/// The lesser and the greater. `d` = c1^2 - 4 c0 c2; the signs of c1, c2 and d are known, c2 not 0.
template <class N, std::size_t Size>
std::array<N, 2> roots_of_quadratic(const std::array<N, Size>& c, const N& d) {
  // -b and the root of D with one sign: nothing cancels. That is the lesser root if b / a > 0.
  const N root = sqrt(d);
  const bool positive = c[1].sign() >= 0;
  const N sum = half_of(positive ? -c[1] - root : root - c[1]);
  const N one = sum / c[2], other = c[0] / sum;
  if (positive == (c[2].sign() > 0)) return {one, other};
  return {other, one};
}

}  // namespace foresee
