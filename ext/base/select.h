// Choices without branches, in code that is written once for one double and for several at once
// (base/doubles.h).
#pragma once

#include "base/rooms.h"

namespace foresee::base {

inline double select(bool chosen, double a, double b) {
  return chosen ? a : b;
}

/// Passes on a second argument that is NaN.
template <class Real>
Real lesser(const Real& a, const Real& b) {
  return select(a < b, a, b);
}
template <class Real>
Real greater(const Real& a, const Real& b) {
  return select(a > b, a, b);
}

}  // namespace foresee::base
