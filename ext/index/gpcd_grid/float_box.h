// The grid's own boxes: single precision, relative to a frame, so that twice as many fit a cache line and a
// register.
//
//   Frame<2> frame = frame_of(sample);                   // origin and unit near where most objects are
//
// float_lanes.h turns beams into them. Guarantee: two boxes that meet have float boxes that meet. Coordinates
// near 1e15 with extents near 1 keep their resolution, because the origin is subtracted in double precision
// first.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace foresee {
template <int D>
struct Beam;
}

namespace foresee::gpcd {

template <int D>
struct FloatBox {
  float lower[D];
  float upper[D];

  static FloatBox empty() {
    constexpr float inf = std::numeric_limits<float>::infinity();
    FloatBox box;
    std::fill_n(box.lower, D, inf), std::fill_n(box.upper, D, -inf);
    return box;
  }
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
};

/// A frame whose origin is the median centre of the sample and whose unit is the typical distance from it:
/// a few objects far away, or infinite boxes, do not move it. Any sample is right; a good one is faster.
template <int D>
Frame<D> frame_of(std::span<const Beam<D>> sample);

}  // namespace foresee::gpcd
