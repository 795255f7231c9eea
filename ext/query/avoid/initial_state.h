// What exact numbers say of an intruder at the moment of the change, where the last bits decide.
//
//   if (needs_close_look(encounter, false)) look_closely(encounter, touched.first(record, intruder), false);
#pragma once

#include "contact/clearance/departure.h"
#include "query/avoid/exact_avoidance.h"

namespace foresee {

/// Numbers of which an error may decide the sign.
template <int D>
bool seem_zero(const Vec<D>& numbers, const Vec<D>& errors) {
  return (errors > 0 && numbers.abs() <= 0x1p30 * errors).any();
}

template <int D>
bool needs_close_look(const Encounter<D>& encounter, bool touches) {
  return is_beside(encounter) &&
         (!touches || seem_zero<D>(encounter.x, encounter.ex) || seem_zero<D>(encounter.v, encounter.ev));
}

/// Of a delay, and of who is not there yet, nothing is known but how far apart the two are.
template <int D>
void look_closely(Encounter<D>& encounter, const ExactAvoidance::First& first, bool delayed) {
  encounter.square_gap = first.square_gap;
  if (delayed || encounter.begin > 0) return;
  for (int axis = 0; axis < D; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    encounter.x[axis] = first.x[j], encounter.ex[axis] = first.ex[j];
    encounter.v[axis] = first.v[j], encounter.ev[axis] = first.ev[j];
  }
}

}  // namespace foresee
