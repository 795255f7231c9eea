// Where along x is a giant while it crosses a stripe?
//
//   clip(giants, inside, from, to);        // giants.size numbers each
//
// What is fast sweeps a box over half of the scene, but in one stripe it is for a short time, and at that
// time in a short part of it. Seen from the boxes in the stripe that the giant's pairs are reported with, its
// beam (shape/beam.h) has their heights for a part of the horizon only; where it is along x meanwhile is all
// that a scan has to look at. Boxes that a giant meets begin before `to` and end after `from`; if it meets
// none, from > to.
//
// Rounding: y is widened by 2^-30 of all numbers in it, the part of the horizon by 2^-30, x by 2^-22 before
// it becomes float; all in double, from the beams' floats, which have room for their own rounding
// (float_lanes.kernel.cpp). Requires: columns of travel, none of life. Cost: some ten nanoseconds a giant
// and axis.
#pragma once

#include "index/gpcd_grid/scan.h"

namespace foresee::gpcd {

template <int D>
void clip(const LaneView<D>& giants, const LaneView<D>& inside, float* from, float* to);

}  // namespace foresee::gpcd
