// The paper's trajectory intersection test: do the regions that two objects sweep meet at all, whenever?
//
// A region is the object's box carried along its arc. The arc lies beside its chord, by no more than the
// sagitta a L^2 / 8 and on one side of it. Along a direction n the region covers an interval; if the
// intervals of two regions are apart for some n, so are the regions. The directions that can part two boxes
// carried along chords are those perpendicular to a chord: in the plane one for each chord, in space the
// products of the chords with each other and with the axes. (The axes themselves are the projection overlap.)
//
// Guarantee: never false for regions that meet. Any direction is a fair one to look along, so only the
// intervals are rounded outward. On one axis a region is its projection: always true.
#pragma once

#include "index/paper_grid/trajectory.h"

namespace foresee {

template <int D>
bool regions_may_meet(const Trajectory<D>& a, const Trajectory<D>& b);

}  // namespace foresee
