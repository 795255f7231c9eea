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
  TimeSpan span;
};

/// Of object i, grown by `margin` on every side. Cost: some tens of nanoseconds.
template <int D>
Trajectory<D> trajectory_of(const Bodies& bodies, std::size_t i, const Horizon& horizon,
                            const Vec<D>& margin);

}  // namespace foresee
