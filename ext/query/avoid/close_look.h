// What exact numbers say of an intruder at the moment of the change, where the last bits decide.
//
//   if (needs_close_look(met, false)) look_closely(met, touched.first(record, intruder), false);
#pragma once

#include "contact/growing/departure.h"
#include "query/avoid/touched.h"

namespace foresee::query {

/// Numbers of which an error may decide the sign.
template <int D>
bool seem_zero(const Vec<D>& numbers, const Vec<D>& errors) {
  return (errors > 0 && numbers.abs() <= 0x1p30 * errors).any();
}

template <int D>
bool needs_close_look(const Encounter<D>& met, bool touches) {
  return is_beside(met) && (!touches || seem_zero<D>(met.x, met.ex) || seem_zero<D>(met.v, met.ev));
}

/// Of a delay, and of who is not there yet, nothing is known but how far apart the two are.
template <int D>
void look_closely(Encounter<D>& met, const Touched::First& first, bool delayed) {
  met.square_gap = first.square_gap;
  if (delayed || met.begin > 0) return;
  for (int axis = 0; axis < D; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    met.x[axis] = first.x[j], met.ex[axis] = first.ex[j];
    met.v[axis] = first.v[j], met.ev[axis] = first.ev[j];
  }
}

}  // namespace foresee::query
