// Exact position and velocity of an intruder at the change, for encounters whose verdict depends on the last
// bits.
//
//   if (needs_exact_state(encounter, false))
//     take_exact_state(encounter, exact.initial_state(record, intruder), false);
#pragma once

#include "contact/clearance/departure.h"
#include "query/avoid/exact_avoidance.h"

namespace foresee {

/// Whether the error of any number may decide its sign.
template <int D>
bool seem_zero(const Vec<D>& numbers, const Vec<D>& errors) {
  return (errors > 0 && numbers.abs() <= 0x1p30 * errors).any();
}

template <int D>
bool needs_exact_state(const Encounter<D>& encounter, bool touches) {
  return is_beside(encounter) &&
         (!touches || seem_zero<D>(encounter.x, encounter.ex) || seem_zero<D>(encounter.v, encounter.ev));
}

/// For a delay, and for an intruder that does not exist yet, only the gap is valid.
template <int D>
void take_exact_state(Encounter<D>& encounter, const ExactAvoidance::InitialState& exact, bool delayed) {
  encounter.square_gap = exact.square_gap;
  if (delayed || encounter.begin > 0) return;
  for (int axis = 0; axis < D; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    encounter.x[axis] = exact.x[j], encounter.ex[axis] = exact.ex[j];
    encounter.v[axis] = exact.v[j], encounter.ev[axis] = exact.ev[j];
  }
}

}  // namespace foresee
