// When are two centres nearest, and how near? The least |x + v tau + a tau^2| while both objects exist in the
// horizon; the earliest moment on ties.
//
// Computed in DoubleDouble with the moment carried beyond a double's precision, so that a near miss of fast
// objects keeps its digits. A distance that is smaller than what DoubleDouble can tell from nothing is 0.
// Cost: about a microsecond with acceleration, half of it without.
#pragma once

#include "contact/pair_source.h"

namespace foresee {

/// Requires: both objects exist together at some moment of the horizon.
template <int D>
ClosestApproach closest_approach_of(const Setup& setup, const double* row_a, const double* row_b);

}  // namespace foresee
