// Where can the objects of a scene be during the horizon, and what do they cover for certain at one moment?
// motion/swept_box.h, asked about rows.
#pragma once

#include <vector>

#include "base/error.h"
#include "motion/swept_box.h"
#include "shape/bodies.h"
#include "shape/shapes.h"

namespace foresee::shape {

/// The box around object i, seen from its position.
template <int D>
Extents<D> extents_of(const Bodies& bodies, std::size_t i) {
  return extents_of<D>(bodies.layout.shape, bodies.row(i), bodies.at);
}

/// The swept box of object i, grown by `margin` (>= 0) on both sides of every axis.
template <int D>
Box<D> swept_box(const Bodies& bodies, std::size_t i, const Horizon& horizon, const Vec<D>& margin) {
  return swept_box<D>(motion_of<D>(bodies, i), horizon, grown(extents_of<D>(bodies, i), margin));
}

/// A box that lies within the shape of object i at the moment `now`: what is in it touches the object. Empty
/// where the object does not exist then, and where no double vouches for one.
template <int D>
Box<D> core_box(const Bodies& bodies, std::size_t i, double now) {
  return core_box<D>(motion_of<D>(bodies, i), now, core_of<D>(bodies.layout.shape, bodies.row(i), bodies.at));
}

/// The swept boxes of all bodies, in row order.
template <int D>
std::vector<Box<D>> swept_boxes(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                Interrupt& interrupt);

}  // namespace foresee::shape
