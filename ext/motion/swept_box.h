// Where can an object be during the horizon? The smallest box we can vouch for: it contains the shape at
// every moment of [now, now + h] at which the object exists, turning points of accelerated motion included
// (GPCD step 1).
//
// And where is it for certain, at one moment? core_box(), rounded inward.
//
// Bounds are rounded outward, so an index that compares swept boxes never loses a pair. An object that does
// not exist during the horizon has the empty box (lower = +inf, upper = -inf), which meets nothing. Bounds
// that no double holds are infinite. Cost: some tens of flops per axis.
#pragma once

#include <cstdint>
#include <vector>

#include "motion/bodies.h"
#include "motion/error.h"

namespace foresee {

template <int D>
struct Box {
  Vec<D> lower;
  Vec<D> upper;

  static Box empty() {
    const double inf = std::numeric_limits<double>::infinity();
    return {Vec<D>::Constant(inf), Vec<D>::Constant(-inf)};
  }
  bool is_empty() const { return !(lower <= upper).all(); }
  /// Closed: boxes that touch meet.
  bool meets(const Box& other) const { return (lower <= other.upper).all() && (other.lower <= upper).all(); }
};

/// The swept box of object i, grown by `margin` (>= 0) on both sides of every axis.
template <int D>
Box<D> swept_box(const Bodies& bodies, std::size_t i, const Horizon& horizon, const Vec<D>& margin);

/// A box that lies within the shape of object i at the moment `now`: what is in it touches the object. Empty
/// where the object does not exist then, and where no double vouches for one.
template <int D>
Box<D> core_box(const Bodies& bodies, std::size_t i, double now);

/// The swept boxes of all bodies, in row order.
template <int D>
std::vector<Box<D>> swept_boxes(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                Interrupt& interrupt);

}  // namespace foresee
