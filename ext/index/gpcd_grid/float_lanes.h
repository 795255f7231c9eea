// Float boxes side by side, on their way from beams into the grid: rounded outward, and told which stripes
// they meet.
//
//   FloatLanes<2> lanes;
//   const FloatKernels<2>& kernels = float_kernels<2>();
//   kernels.round_outward(beams, count, frame, columns, lanes);   // contain the beams' boxes
//   kernels.find_stripes(lanes, count, partition);                // lanes.first[7], lanes.more_y[7], …
//
// Guarantee: two boxes that meet have float boxes that meet, and share a stripe unless one of them is a
// giant. With `columns.travel` there is room for the test of time too (scan.kernel.cpp). All instruction sets
// give the same bits. Cost: a few nanoseconds a box.
#pragma once

#include <vector>

#include "index/gpcd_grid/cell_size.h"
#include "motion/beam_lanes.h"

namespace foresee {
template <int D>
struct Box;
}

namespace foresee::gpcd {

constexpr double too_large = 0x1p59;  ///< for the test of time

template <int D>
struct FloatLanes {
  static constexpr std::size_t width = BeamLanes<D>::width;

  float lower[D][width] = {}, upper[D][width] = {};
  /// Where the columns have it; NaN if the numbers of the beam are too large to compute with: every test of
  /// time then passes.
  float travel[D][width] = {};
  /// Where the columns have it: within [-1, 1], the middle of the horizon being 0.
  float begin[width] = {}, end[width] = {};

  // What find_stripes() finds.
  std::uint32_t first[width] = {};  ///< number of the first stripe: that along y, that along z
  std::uint32_t more_y[width] = {}, more_z[width] = {};  ///< stripes beside the first, along each axis
  std::uint32_t inside[width] = {};                      ///< 1, or 0 if it enters no stripe
  std::uint32_t giant[width] = {};                       ///< 1 if that is because it is too large
  std::uint32_t order[width] = {};                       ///< grows with the lower end along x

  FloatBox<D> box(std::size_t l) const {
    FloatBox<D> box;
    for (int k = 0; k < D; ++k) box.lower[k] = lower[k][l], box.upper[k] = upper[k][l];
    return box;
  }
};

/// The loops over the first `count` lanes, compiled for one level of instructions each; what is behind those
/// lanes has no meaning.
template <int D>
struct FloatKernels {
  /// Boxes that contain those of the beams, with room for the test of time; travel and life where `columns`
  /// has them.
  void (*round_outward)(const BeamLanes<D>& beams, std::size_t count, const Frame<D>& frame, Columns columns,
                        FloatLanes<D>& out);
  /// Which stripes each box meets, or that it is a giant, or empty. Requires: partition.stripes() < 2^32.
  void (*find_stripes)(FloatLanes<D>& lanes, std::size_t count, const Partition<D>& partition);
};

template <int D, Simd simd>
const FloatKernels<D>& float_kernels();

/// Of the widest instructions in use.
template <int D>
const FloatKernels<D>& float_kernels() {
  return with_simd_in_use(
      []<Simd simd>(Level<simd>) -> const FloatKernels<D>& { return float_kernels<D, simd>(); });
}

/// A few beams, rounded outward.
template <int D>
std::vector<FloatBox<D>> boxes_of(std::span<const Beam<D>> beams, const Frame<D>& frame, Columns columns);

/// A float box that lies within `box` by 2^-18 of its coordinates; empty if none does, or if the test of time
/// could not compute with it.
template <int D>
FloatBox<D> round_inward(const Box<D>& box, const Frame<D>& frame);

}  // namespace foresee::gpcd
