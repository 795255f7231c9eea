// What the paper's tests know of an object: its motion as seen from `now`, its box, and how far it sweeps.
//
// At tau seconds after `now`, for tau in `span`, the centre is at x + v tau + a tau^2 / 2 and the object lies
// within `room` of it on every axis. `span` contains every moment of the horizon at which the object exists.
// `room` holds the half extents, the margin, and all that x, v and a have lost by rounding (swept_box.cpp
// says how much that is), so a test that takes the numbers as exact and rounds outward itself loses no pair.
// Where no double holds a number it is infinite or no number at all, and every test then says "may be".
#pragma once

#include "index/tpr_tree/moving_box.h"
#include "shape/swept_boxes.h"

namespace foresee {

template <int D>
struct Trajectory {
  Box<D> swept;
  Vec<D> x, v, a, room;
  SharedInterval span;
};

/// Of object i, grown by `margin` on every side. Cost: some tens of nanoseconds.
template <int D>
Trajectory<D> trajectory_of(const Bodies& bodies, std::size_t i, const Horizon& horizon,
                            const Vec<D>& margin);

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

template <int D>
bool regions_may_meet(const Trajectory<D>& a, const Trajectory<D>& b);

}  // namespace foresee
