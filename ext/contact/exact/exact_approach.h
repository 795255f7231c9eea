// The closest approach in exact arithmetic: the last word where doubles cannot tell.
//
// The squared distance is a polynomial of degree at most four. Its least value lies at an end of the moments
// asked about or where the slope changes from falling to rising; there are never more than two such places.
// They are compared by exact signs, a tie goes to the earlier, and moment and distance are each rounded once.
// Cost: tens of microseconds.
#pragma once

#include "contact/exact/exact_contact.h"

namespace foresee {

/// |x + v tau + a tau^2|^2 by powers of tau.
using SquaredDistance = std::array<Dyadic, Polynomial::max_degree + 1>;

template <int D>
SquaredDistance squared_distance(const RelativeMotion<Dyadic, D>& relative) {
  SquaredDistance sum;
  for (int j = 0; j < D; ++j) {
    const Dyadic &x = relative.x[j], &v = relative.v[j], &a = relative.a[j];
    sum[0] = sum[0] + x * x;
    sum[1] = sum[1] + (x * v).scaled(1);
    sum[2] = sum[2] + v * v + (x * a).scaled(1);
    sum[3] = sum[3] + (v * a).scaled(1);
    sum[4] = sum[4] + a * a;
  }
  return sum;
}

/// Requires: moments.begin <= moments.end.
ClosestApproach exact_approach(const SquaredDistance& square, const ExactLifetime& lifetime);

}  // namespace foresee
