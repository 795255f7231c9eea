// What must hold while two pieces touch: each condition a polynomial in time that is at most 0 then, written
// once for every number type.
#pragma once

#include "contact/outline/convex_sum.h"
#include "contact/set/relative_motion.h"

namespace foresee::contact {

/// d is inside of an edge of the sum, or below a face across z.
struct Condition {
  SumEdge edge = {};
  int along_z = 0;  ///< not 0: the face on this side of z, and no edge
};

/// Where an object's half height stands in its row: that of a prism, cylinder or box.
inline int place_of_half_height(const Offsets& at) {
  return at.hz != Offsets::absent || at.half == Offsets::absent ? at.hz : at.half + 2;
}

/// How far apart two centres are along z that just touch.
template <class T>
T half_height_of(const Setup& setup, const double* row_a, const double* row_b) {
  using E = Exactly<T>;
  return E::number(value_or(row_a, place_of_half_height(setup.a.at), 0)) +
         E::number(value_or(row_b, place_of_half_height(setup.b.at), 0)) + E::number(setup.within_z);
}

/// `x`: d by powers of the time after some moment.
template <int K, int D, class T>
Powers<T, K> polynomial_of(const Condition& condition, const Powers<T, K> (&x)[D], const T& half_height) {
  if (condition.along_z == 0) return beyond<K>(condition.edge, x);
  Powers<T, K> p = x[D - 1];
  if (condition.along_z < 0)
    for (T& c : p) c = -c;
  p[0] = p[0] - half_height;
  return p;
}

}  // namespace foresee::contact
