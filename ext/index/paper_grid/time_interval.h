// The paper's time interval test: two objects can touch only while each is inside the other's swept box.
//
// If two objects touch at a time, each is inside the other's swept box at that time. On one axis, "inside"
// means two quadratic inequalities in time. Each of them holds during at most two intervals. The test
// intersects all intervals of both objects and is false if the result is empty.
//
// Guarantee: never false for objects that touch while both exist. Roots are rounded outward. If double
// arithmetic cannot separate the roots of an inequality, it counts as always true.
#pragma once

#include "index/paper_grid/trajectory.h"

namespace foresee {

template <int D>
bool times_may_overlap(const Trajectory<D>& a, const Trajectory<D>& b);

}  // namespace foresee
