// Swept boxes of the rows of a scene over a horizon, and core boxes at one time (motion/swept_box.h).
#pragma once

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "motion/swept_box.h"
#include "shape/bodies.h"
#include "shape/shapes.h"

namespace foresee {

// Tests whether all objects that exist during the horizon exist at its start, or throughout it: then no tests
// of single lives are needed.
//
//   all_exist_at_start(ships, {.now = 600, .h = 300}, interrupt)
//
// Cost: one pass over the rows, up to the first body that does not; none if the layout has no t and no until.

/// Whether every body that exists during the horizon exists at its start.
bool all_exist_at_start(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt);

/// Whether every body that exists during the horizon exists during all of it.
bool all_exist_throughout(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt);

/// The extents of object i as of t, relative to its position.
template <int D>
Extents<D> extents_of(const Bodies& bodies, std::size_t i) {
  return extents_of<D>(bodies.layout.shape, bodies.row(i), bodies.at);
}

/// extents_of() the object at its last time within the horizon, when it is largest; rounded outward.
template <int D>
Extents<D> largest_extents(const Bodies& bodies, std::size_t i, const Horizon& horizon) {
  const Extents<D> extents = extents_of<D>(bodies, i);
  if (!grows(bodies.layout)) return extents;
  const double* const row = bodies.row(i);
  const double until = value_or(row, bodies.at.until, std::numeric_limits<double>::infinity());
  const LifeInterval life = life_of(value_or(row, bodies.at.t, 0), until, horizon);
  const double age = std::max(0.0, life.end) + life.reach * 0x1p-51;
  const Vec<D> growth = growth_of<D>(bodies.layout.shape, row, bodies.at);
  return grown<D>(extents, growth * (age * (1 + 0x1p-50)) + 0x1p-1000);
}

/// The swept box of object i, grown by `margin` (>= 0) on both sides of every axis.
template <int D>
Box<D> swept_box(const Bodies& bodies, std::size_t i, const Horizon& horizon, const Vec<D>& margin) {
  const Motion<D> motion = motion_of<D>(bodies, i);
  const Extents<D> extents = grown(extents_of<D>(bodies, i), margin);
  if (!grows(bodies.layout)) return swept_box<D>(motion, horizon, extents);
  return swept_box<D>(motion, horizon, extents, growth_of<D>(bodies.layout.shape, bodies.row(i), bodies.at));
}

/// A box inside object i at time `now`: every point of the box touches the object. Empty if the object does
/// not exist then, or if rounding leaves no such box.
template <int D>
Box<D> core_box(const Bodies& bodies, std::size_t i, double now) {
  return core_box<D>(motion_of<D>(bodies, i), now, core_of<D>(bodies.layout.shape, bodies.row(i), bodies.at));
}

/// The swept boxes of all bodies, in row order.
template <int D>
std::vector<Box<D>> swept_boxes(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                Interrupt& interrupt);

}  // namespace foresee
