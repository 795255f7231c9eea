// Vector kernels of float_lanes.h (base/simd.h): loops without branches, so that compilers use vector
// instructions.
//
// The padding on both sides is 2^-20 of extent and travel, 2^-22 of the coordinate and 2^-40 of the frame's
// unit. Conversion to float (2^-24) and the float arithmetic of the time test (scan.kernel.cpp) together lose
// far less. A value beyond the range of a float is clamped to that range, which keeps the order.
#include "index/gpcd_grid/float_lanes.h"

#include "base/lane_math.h"

namespace foresee::gpcd {
namespace {

constexpr std::size_t block = 16;           // lanes per iteration: the floats of the widest register
constexpr double largest = 0x1.fffffep127;  // the largest finite float
constexpr double never = __builtin_inf(), no_number = __builtin_nan("");

/// The beams' boxes in the frame's units, padded as described above; travel if `moves`.
template <int D, bool moves>
void round_boxes(const BeamLanes<D>& beams, std::size_t count, const FloatFrame<D>& frame,
                 FloatLanes<D>& out) {
  constexpr double relative = moves ? 0x1p-22 : 0x1p-23;
  for (int k = 0; k < D; ++k) {
    const double scale = frame.scale[k], origin = frame.scaled_origin[k];
    for (std::size_t first = 0; first < count; first += block) {
      double low[block], high[block], travels[block];
      for (std::size_t i = 0; i < block; ++i) {
        const std::size_t l = first + i;
        const double lower = beams.lower[k][l] * scale - origin, upper = beams.upper[k][l] * scale - origin;
        const double travel = moves ? beams.travel[k][l] * scale : 0, path = absolute(travel);
        const bool fits = greater(greater(-lower, upper), path) < too_large;
        const double for_time = (upper - lower + path) * 0x1p-20 + 0x1p-40;
        const double room = moves && fits ? for_time : 0x1p-126;
        // NaN becomes the outer end.
        const double low_end = greater(lower - (absolute(lower) * relative + room), -largest);
        const double high_end = lesser(upper + (absolute(upper) * relative + room), largest);
        const bool empty = k == 0 && beams.lower[0][l] > beams.upper[0][l];
        low[i] = empty ? never : lesser(low_end, largest);
        high[i] = greater(high_end, -largest);
        travels[i] = fits ? path < 0x1p-40 ? 0 : travel : no_number;
      }
      for (std::size_t i = 0; i < block; ++i) {
        out.lower[k][first + i] = static_cast<float>(low[i]);
        out.upper[k][first + i] = static_cast<float>(high[i]);
        if (moves) out.travel[k][first + i] = static_cast<float>(travels[i]);
      }
    }
  }
}

/// Maps fractions of the horizon to [-1, 1], rounded outward.
template <int D>
void round_lives(const BeamLanes<D>& beams, std::size_t count, FloatLanes<D>& out) {
  for (std::size_t first = 0; first < count; first += block)
    for (std::size_t l = first; l < first + block; ++l) {
      out.begin[l] = static_cast<float>(2 * beams.begin[l] - 1 - 0x1p-22);
      out.end[l] = static_cast<float>(2 * beams.end[l] - 1 + 0x1p-22);
    }
}

template <int D>
void round_outward_all(const BeamLanes<D>& beams, std::size_t count, const FloatFrame<D>& frame,
                       Columns columns, FloatLanes<D>& out) {
  columns.travel ? round_boxes<D, true>(beams, count, frame, out)
                 : round_boxes<D, false>(beams, count, frame, out);
  if (columns.life) round_lives(beams, count, out);
}

/// Cuts::index(), for numbers of parts that a float distinguishes.
inline std::int32_t index_of(float x, float from, float per_unit, float last) {
  return static_cast<std::int32_t>(lesser(greater((x - from) * per_unit, 0.0f), last));
}

template <int D>
void find_stripes_all(FloatLanes<D>& lanes, std::size_t count, const Partition<D>& partition) {
  float from[D], per_unit[D], last[D], large[D];
  for (int k = 0; k < D; ++k) {
    from[k] = partition.axis[k].from, per_unit[k] = partition.axis[k].per_unit;
    last[k] = static_cast<float>(partition.axis[k].count - 1), large[k] = partition.largest_inside[k];
  }
  const auto across = static_cast<std::uint32_t>(D > 2 ? partition.axis[D - 1].count : 1);
  for (std::size_t begin = 0; begin < count; begin += block)
    for (std::size_t l = begin; l < begin + block; ++l) {
      std::int32_t giant = 0, low[D], high[D];
#pragma GCC unroll 3
      for (int k = 0; k < D; ++k) {
        const float lower = lanes.lower[k][l], upper = lanes.upper[k][l];
        giant |= upper - lower > large[k];
        low[k] = k == 0 ? 0 : index_of(lower, from[k], per_unit[k], last[k]);
        high[k] = k == 0 ? 0 : index_of(upper, from[k], per_unit[k], last[k]);
      }
      const std::int32_t there = lanes.lower[0][l] <= lanes.upper[0][l], inside = there & ~giant;
      const std::uint32_t y = D > 1 ? low[D > 1] : 0, z = D > 2 ? low[D - 1] : 0;
      lanes.first[l] = y * across + z;
      lanes.more_y[l] = D > 1 && inside ? high[D > 1] - low[D > 1] : 0;
      lanes.more_z[l] = D > 2 && inside ? high[D - 1] - low[D - 1] : 0;
      lanes.inside[l] = inside;
      lanes.giant[l] = there & giant;
      std::uint32_t bits;
      __builtin_memcpy(&bits, &lanes.lower[0][l], sizeof bits);
      lanes.order[l] =
          bits ^ (static_cast<std::uint32_t>(-static_cast<std::int32_t>(bits >> 31)) | 0x80000000u);
    }
}

}  // namespace

template <int D, Simd simd>
const FloatKernels<D>& float_kernels() {
  static constexpr FloatKernels<D> kernels{round_outward_all<D>, find_stripes_all<D>};
  return kernels;
}

template const FloatKernels<1>& float_kernels<1, Simd::FORESEE_SIMD>();
template const FloatKernels<2>& float_kernels<2, Simd::FORESEE_SIMD>();
template const FloatKernels<3>& float_kernels<3, Simd::FORESEE_SIMD>();

}  // namespace foresee::gpcd
