// Where can the objects of a scene be during the horizon, and what do they cover for certain at one moment?
// motion/swept_box.h, asked about rows.
#pragma once

#include <vector>

#include "base/error.h"
#include "motion/swept_box.h"
#include "shape/extents.h"

namespace foresee {

/// The swept box of object i, grown by `margin` (>= 0) on both sides of every axis.
template <int D>
Box<D> swept_box(const Bodies& bodies, std::size_t i, const Horizon& horizon, const Vec<D>& margin) {
  const Vec<D> half = half_extents_of<D>(bodies, i) + margin;
  return swept_box<D>(motion_of<D>(bodies, i), horizon, {-half, half});
}

/// A box that lies within the shape of object i at the moment `now`: what is in it touches the object. Empty
/// where the object does not exist then, and where no double vouches for one.
template <int D>
Box<D> core_box(const Bodies& bodies, std::size_t i, double now) {
  const Vec<D> half = inner_half_extents_of<D>(bodies, i);
  return core_box<D>(motion_of<D>(bodies, i), now, {-half, half});
}

/// The swept boxes of all bodies, in row order.
template <int D>
std::vector<Box<D>> swept_boxes(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                Interrupt& interrupt);

}  // namespace foresee
