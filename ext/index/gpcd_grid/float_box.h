// Axis-aligned boxes in single precision, relative to a frame: twice as many fit a cache line and a register.
//
//   FloatFrame<2> frame = frame_of(sample);                   // origin and unit near where most objects are
//
// float_lanes.h converts beams into them. Guarantee: if two boxes meet, their float boxes meet. Coordinates
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

/// The numbers that a scene needs beside its boxes; others are neither stored nor computed.
struct Columns {
  bool travel = false;  ///< an object moves during the horizon
  bool life = false;    ///< an object exists for a part of the horizon only

  friend bool operator==(const Columns&, const Columns&) = default;
};

/// Maps x to (x - origin) * scale on each axis; scales are powers of two.
template <int D>
struct FloatFrame {
  double scale[D];
  double scaled_origin[D];

  /// False if the unit is so small that the padding of the time test would be larger than the boxes.
  bool resolves_time() const {
    return std::all_of(scale, scale + D, [](double s) { return s < 0x1p1000; });
  }
};

/// A frame whose origin is the median centre of the sample and whose unit is the typical distance from it. So
/// a few objects far away, or infinite boxes, do not move it. The result is correct for any sample; a typical
/// one makes the grid faster.
template <int D>
FloatFrame<D> frame_of(std::span<const Beam<D>> sample);

}  // namespace foresee::gpcd
