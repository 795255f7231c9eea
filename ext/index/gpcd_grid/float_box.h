// The grid's own boxes: single precision, relative to a frame, so that twice as many fit a cache line and a
// register.
//
//   Frame<2> frame = frame_of(sample);                   // origin and unit near where most objects are
//   FloatBox<2> small = frame.round_outward(beam, true);  // contains the beam's box
//
// Guarantee: two boxes that meet have float boxes that meet. Coordinates near 1e15 with extents near 1 keep
// their resolution, because the origin is subtracted in double precision first; what lies beyond the range of
// a float is moved to its end, which keeps the order. Cost: a few flops an axis.
//
// The room on both sides, 2^-20 of extent and travel, 2^-22 of the coordinate and 2^-40 of the frame's unit,
// is many times what conversion to float (2^-24) and the float arithmetic of the test of time (scan_kernel.h)
// can lose together.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "motion/beam.h"

namespace foresee::gpcd {

template <int D>
struct FloatBox {
  float lower[D];
  float upper[D];

  bool is_empty() const { return !(lower[0] <= upper[0]); }
  float extent(int axis) const { return upper[axis] - lower[axis]; }
};

/// Which numbers a scene needs beyond boxes; what it does not need is neither stored nor computed.
struct Columns {
  bool travel = false;  ///< something moves during the horizon
  bool life = false;    ///< some exist for a part of the horizon only

  friend bool operator==(const Columns&, const Columns&) = default;
};

/// Maps x to (x - origin) * scale on each axis; scales are powers of two.
template <int D>
struct Frame {
  double scale[D];
  double scaled_origin[D];

  /// False for units so small that the room for the test of time would swallow them.
  bool resolves_time() const {
    return std::all_of(scale, scale + D, [](double s) { return s < 0x1p1000; });
  }

  /// Contains the beam's box; with `travel` there is room for the test of time too.
  FloatBox<D> round_outward(const Beam<D>& beam, bool travel) const {
    const double relative = travel ? 0x1p-22 : 0x1p-23;
    FloatBox<D> out;
    for (int axis = 0; axis < D; ++axis) {
      const double lower = beam.box.lower[axis] * scale[axis] - scaled_origin[axis];
      const double upper = beam.box.upper[axis] * scale[axis] - scaled_origin[axis];
      const double path = std::abs(beam.travel[axis] * scale[axis]);
      const double room =
          travel && fits(lower, upper, path) ? (upper - lower + path) * 0x1p-20 + 0x1p-40 : 0x1p-126;
      out.lower[axis] = not_above(lower - (std::abs(lower) * relative + room));
      out.upper[axis] = not_below(upper + (std::abs(upper) * relative + room));
    }
    if (beam.box.is_empty()) out.lower[0] = std::numeric_limits<float>::infinity();
    return out;
  }

  /// NaN where the numbers of the beam are too large to compute with: every test of time then passes.
  float travel(const Beam<D>& beam, int axis) const {
    const double lower = beam.box.lower[axis] * scale[axis] - scaled_origin[axis];
    const double upper = beam.box.upper[axis] * scale[axis] - scaled_origin[axis];
    const double travel = beam.travel[axis] * scale[axis];
    if (!fits(lower, upper, std::abs(travel))) return std::numeric_limits<float>::quiet_NaN();
    return std::abs(travel) < 0x1p-40 ? 0 : static_cast<float>(travel);
  }

 private:
  static constexpr double end = std::numeric_limits<float>::max();
  static bool fits(double lower, double upper, double path) {
    return std::abs(lower) < 0x1p59 && std::abs(upper) < 0x1p59 && path < 0x1p59;
  }
  // The order of arguments decides what NaN becomes: the outer end.
  static float not_above(double x) { return static_cast<float>(std::min(std::max(-end, x), end)); }
  static float not_below(double x) { return static_cast<float>(std::max(std::min(end, x), -end)); }
};

/// A frame whose origin is the median centre of the sample and whose unit is the typical distance from it:
/// a few objects far away, or infinite boxes, do not move it. Any sample is right; a good one is faster.
template <int D>
Frame<D> frame_of(std::span<const Beam<D>> sample);

}  // namespace foresee::gpcd
