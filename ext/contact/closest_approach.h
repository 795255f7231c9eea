// The closest approach of two centres: the minimum of |x + v tau + a tau^2| while both objects exist in the
// horizon, and its time; the earliest one on ties.
//
// Time and distance are the exact ones, each rounded once. As for contact, doubles with error bounds and one
// step in DoubleDouble decide nearly all pairs. Exact arithmetic decides a tie, a distance of exactly 0,
// numbers near the ends of the range of doubles, and times halfway between two doubles. Cost: about a
// microsecond; tens of them in exact arithmetic.
#pragma once

#include "contact/contact.h"
#include "contact/minkowski/relative_motion.h"

namespace foresee {

/// Requires: both objects exist together at some time of the horizon.
template <int D>
ClosestApproach closest_approach_of(const Setup& setup, const double* row_a, const double* row_b);

}  // namespace foresee
