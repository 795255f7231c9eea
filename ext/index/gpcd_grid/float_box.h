// The grid's own boxes: single precision, relative to a frame, so that twice as many fit a cache line and a
// register.
//
//   Frame<2> frame = frame_of(sample);                   // origin and unit near where most objects are
//   FloatBox<2> small = frame.round_outward(box);         // contains the box
//
// Guarantee: two boxes that meet have float boxes that meet. Coordinates near 1e15 with extents near 1 keep
// their resolution, because the origin is subtracted in double precision first; what lies beyond the range of
// a float is moved to its end, which keeps the order. Cost: a few flops an axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "motion/swept_box.h"

namespace foresee::gpcd {

template <int D>
struct FloatBox {
  float lower[D];
  float upper[D];

  bool is_empty() const { return !(lower[0] <= upper[0]); }
  float extent(int axis) const { return upper[axis] - lower[axis]; }
};

/// Maps x to (x - origin) * scale on each axis; scales are powers of two.
template <int D>
struct Frame {
  double scale[D];
  double scaled_origin[D];

  FloatBox<D> round_outward(const Box<D>& box) const {
    FloatBox<D> out;
    for (int axis = 0; axis < D; ++axis) {
      // The subtraction and the conversion err by less than 2^-23 relatively, or 2^-126 near zero.
      const double lower = box.lower[axis] * scale[axis] - scaled_origin[axis];
      const double upper = box.upper[axis] * scale[axis] - scaled_origin[axis];
      out.lower[axis] = not_above(lower - (std::abs(lower) * 0x1p-23 + 0x1p-126));
      out.upper[axis] = not_below(upper + (std::abs(upper) * 0x1p-23 + 0x1p-126));
    }
    if (box.is_empty()) out.lower[0] = std::numeric_limits<float>::infinity();
    return out;
  }

 private:
  static constexpr double end = std::numeric_limits<float>::max();
  // The order of arguments decides what infinity minus infinity becomes: the outer end.
  static float not_above(double x) { return static_cast<float>(std::min(std::max(-end, x), end)); }
  static float not_below(double x) { return static_cast<float>(std::max(std::min(end, x), -end)); }
};

/// A frame whose origin is the median centre of the sample and whose unit is the typical distance from it:
/// a few objects far away, or infinite boxes, do not move it. Any sample is right; a good one is faster.
template <int D>
Frame<D> frame_of(std::span<const Box<D>> sample);

}  // namespace foresee::gpcd
