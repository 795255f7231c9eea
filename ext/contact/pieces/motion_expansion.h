// The relative motion of a pair as it is seen from a moment.
#pragma once

#include <array>

#include "contact/certain/certain_axis_motion.h"
#include "numbers/coefficients.h"

namespace foresee {

/// By powers of the time after tau.
template <int Degree, int D>
std::array<Coefficients<Bounded, Degree>, D> expanded_at(const CertainMotion<D>& relative, double tau) {
  std::array<Coefficients<Bounded, Degree>, D> x;
  for (std::size_t j = 0; j < D; ++j) {
    const AxisView<> view = view_from<Degree>(relative.axis[j], tau, relative.underflow);
    x[j][0] = {view.p, view.ep}, x[j][1] = {view.q, view.eq};
    if constexpr (Degree > 1) x[j][2] = {view.a, view.ea};
  }
  return x;
}

}  // namespace foresee
