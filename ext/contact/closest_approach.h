// When are two centres nearest, and how near? The least |x + v tau + a tau^2| while both objects exist in the
// horizon; the earliest moment on ties.
//
// Moment and distance are the exact ones, each rounded once. As with contact, doubles with error bounds and
// one step in DoubleDouble answer nearly always; a tie, a distance of exactly 0, numbers near the ends of a
// double's range or a moment that lies halfway between two doubles go to exact arithmetic. Cost: about a
// microsecond, tens of them in exact arithmetic.
#pragma once

#include "contact/contact.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// Requires: both objects exist together at some moment of the horizon.
template <int D>
ClosestApproach closest_approach_of(const Setup& setup, const double* row_a, const double* row_b);

}  // namespace foresee
