// The paper's time interval test: are the times at which each of two objects is inside the other's swept box
// common to both?
//
// Two objects that touch at some moment are there, each inside the other's swept box, at that moment. On one
// axis "inside" is two quadratic inequalities in time, each true during at most two intervals; the test
// intersects all of them over both objects and says whether anything is left.
//
// Guarantee: never false for objects that touch while both exist. Roots are rounded outward, and an
// inequality whose roots double arithmetic cannot tell apart counts as true for ever.
#pragma once

#include "index/paper_grid/trajectory.h"

namespace foresee {

template <int D>
bool times_may_overlap(const Trajectory<D>& a, const Trajectory<D>& b);

}  // namespace foresee
