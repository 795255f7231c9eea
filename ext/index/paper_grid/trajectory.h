// Trajectory of an object relative to `now`, with its swept box and error bound: the input of the paper's
// tests.
//
// At tau seconds after `now`, for tau in `span`, the centre is at x + v tau + a tau^2 / 2. The object is
// within `room` of the centre on every axis. `span` contains every time of the horizon at which the object
// exists. `room` is the sum of the half extents, the margin, and the rounding error of x, v and a
// (swept_box.cpp derives it). So a test that treats the numbers as exact, and rounds outward itself, loses no
// pair. A number that no double holds is infinite or NaN, and then every test passes.
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

/// The trajectory of object i, grown by `margin` on every side. Cost: some tens of nanoseconds.
template <int D>
Trajectory<D> trajectory_of(const Bodies& bodies, std::size_t i, const Horizon& horizon,
                            const Vec<D>& margin);

// The paper's trajectory intersection test: whether the regions that two objects sweep intersect, at any
// times.
//
// A region is the object's box moved along its arc. The arc is on one side of its chord, at most the sagitta
// a L^2 / 8 away. Along a direction n the region covers an interval. If the intervals of two regions are
// disjoint for some n, the regions are disjoint. Boxes that move along chords can be separated by the
// directions perpendicular to a chord. In the plane that is one direction per chord; in space, the cross
// products of the chords with each other and with the axes. (The axes themselves are the projection overlap.)
//
// Guarantee: never false for regions that intersect. Any direction is valid, so only the intervals are
// rounded outward. On one axis a region is its projection: always true.
template <int D>
bool regions_may_meet(const Trajectory<D>& a, const Trajectory<D>& b);

// The paper's time interval test: two objects can touch only while each is inside the other's swept box.
//
// If two objects touch at a time, each is inside the other's swept box at that time. On one axis, "inside"
// means two quadratic inequalities in time. Each of them holds during at most two intervals. The test
// intersects all intervals of both objects and is false if the result is empty.
//
// Guarantee: never false for objects that touch while both exist. Roots are rounded outward. If double
// arithmetic cannot separate the roots of an inequality, it counts as always true.

template <int D>
bool times_may_overlap(const Trajectory<D>& a, const Trajectory<D>& b);

}  // namespace foresee
