// Structure-of-arrays form of float boxes: beams rounded outward to single precision, and the stripes that
// each box meets.
//
//   FloatLanes<2> lanes;
//   const FloatKernels<2>& kernels = float_kernels<2>();
//   kernels.round_outward(beams, count, frame, columns, lanes);   // contain the beams' boxes
//   kernels.find_stripes(lanes, count, partition);                // lanes.first[7], lanes.more_y[7], …
//
// Guarantee: if two boxes meet, their float boxes meet and share a stripe, unless one of them is a giant.
// With `columns.travel` the boxes are also padded for the time test (scan.kernel.cpp). All instruction sets
// give the same bits. Cost: a few nanoseconds per box.
#pragma once

#include <vector>

#include "index/gpcd_grid/cell_size.h"
#include "motion/beam_lanes.h"

namespace foresee {
template <int D>
struct Box;
}

namespace foresee::gpcd {

constexpr double too_large = 0x1p59;  ///< for the time test

template <int D>
struct FloatLanes {
  static constexpr std::size_t width = BeamLanes<D>::width;

  float lower[D][width] = {}, upper[D][width] = {};
  /// Set if `columns` has it. NaN if the numbers of the beam are too large to compute with: then every time
  /// test passes.
  float travel[D][width] = {};
  /// Set if `columns` has it: in [-1, 1], where 0 is half the horizon.
  float begin[width] = {}, end[width] = {};

  // Results of find_stripes().
  std::uint32_t first[width] = {};                       ///< number of the first stripe, along y and along z
  std::uint32_t more_y[width] = {}, more_z[width] = {};  ///< number of further stripes along each axis
  std::uint32_t inside[width] = {};                      ///< 1, or 0 if the box is entered into no stripe
  std::uint32_t giant[width] = {};                       ///< 1 if that is because the box is too large
  std::uint32_t order[width] = {};                       ///< increases with the lower end along x

  FloatBox<D> box(std::size_t l) const {
    FloatBox<D> box;
    for (int k = 0; k < D; ++k) box.lower[k] = lower[k][l], box.upper[k] = upper[k][l];
    return box;
  }
};

/// The loops over the first `count` lanes, compiled once per instruction set. Values behind those lanes are
/// unspecified.
template <int D>
struct FloatKernels {
  /// Computes boxes that contain those of the beams, padded for the time test; travel and life if `columns`
  /// has them.
  void (*round_outward)(const BeamLanes<D>& beams, std::size_t count, const FloatFrame<D>& frame,
                        Columns columns, FloatLanes<D>& out);
  /// Computes the stripes that each box meets, or that it is a giant or empty. Requires: partition.stripes()
  /// < 2^32.
  void (*find_stripes)(FloatLanes<D>& lanes, std::size_t count, const Partition<D>& partition);
};

template <int D, Simd simd>
const FloatKernels<D>& float_kernels();

/// The kernels for the widest instructions in use.
template <int D>
const FloatKernels<D>& float_kernels() {
  return with_simd_in_use(
      []<Simd simd>(Level<simd>) -> const FloatKernels<D>& { return float_kernels<D, simd>(); });
}

/// The outward-rounded boxes of a few beams.
template <int D>
std::vector<FloatBox<D>> boxes_of(std::span<const Beam<D>> beams, const FloatFrame<D>& frame,
                                  Columns columns);

/// A float box inside `box` by 2^-18 of its coordinates. It is empty if no such box exists, or if the time
/// test could not compute with it.
template <int D>
FloatBox<D> round_inward(const Box<D>& box, const FloatFrame<D>& frame);

}  // namespace foresee::gpcd
