// Sweep over one stripe from left to right, which reports pairs of overlapping beams (GPCD steps 4, 5a and
// 5c).
//
//   const ScanKernel<2> run = scan_kernel<2>();
//   Scan<2> scan = scan_within(lanes);
//   while (!scan.done()) written += run(scan, pairs + written, room - written, steps);
//
// The rows of a scan are its left-hand beams, the lanes its right-hand ones. Each row is compared with the
// lanes that start before it ends, as many at a time as a vector register holds. The boxes are compared first
// (space), then, if objects move, the beams (time). A scan can pause after any step. All instruction sets give
// the same pairs in the same order (scan.kernel.cpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/pair.h"
#include "base/simd.h"
#include "index/gpcd_grid/object_rows.h"

namespace foresee::gpcd {

/// The max number of lanes per step. As many sentinels, which start at infinity, follow the last lane.
inline constexpr std::size_t lanes_max = 16;
/// The class of a sentinel, which is never reported.
inline constexpr std::uint32_t sentinel = 4;

/// Beams as contiguous arrays, sorted by lower[0].
template <int D>
struct LaneView {
  const float *lower[D] = {}, *upper[D] = {};
  const float* travel[D] = {};                   ///< null if nothing moves, like the next two
  const float *centre[D] = {}, *extent[D] = {};  ///< of the moving box at half the horizon; centre times two
  const float *begin = nullptr, *end = nullptr;  ///< null if all objects exist throughout
  const float *from = nullptr,
              *to = nullptr;  ///< of rows: range of lanes (clip() in giants.h); null: lower, upper
  const float *core_lower[D] = {}, *core_upper[D] = {};  ///< of rows (giants.h); null if no row has a core
  const std::uint32_t *classes = nullptr, *ids = nullptr;
  const std::uint32_t *categories = nullptr, *masks = nullptr;  ///< null: all may meet (shape/kinds.h)
  ObjectRows objects;
  std::size_t size = 0;
  double longest = 0;  ///< an upper bound of the boxes' lengths along x
};

/// The pairs that a scan reports. A row covers a lane if the lane is inside the row's core at the start of
/// the horizon.
enum class Keep : std::uint8_t { all, covered, others };

/// Requires: both views have the same columns; rows have cores, unless `keep` is all.
template <int D>
struct Scan {
  const LaneView<D>* rows = nullptr;
  const LaneView<D>* lanes = nullptr;  ///< if it equals rows, each pair of rows is reported once
  bool swap = false;                   ///< report {lane, row} instead of {row, lane}
  Keep keep = Keep::all;
  std::size_t row = 0;
  std::size_t lane = 0;          ///< the next lane of the row, once the row has started
  std::size_t passed_lanes = 0;  ///< so many first lanes end before the row, and every later row, starts
  bool started = false;          ///< true in the middle of a row

  bool done() const { return row >= rows->size; }
};

/// A scan of each pair among `lanes`, once.
template <int D>
Scan<D> scan_within(const LaneView<D>& lanes) {
  return {&lanes, &lanes};
}

/// A scan of each pair of one of `rows` and one of `lanes`.
template <int D>
Scan<D> scan_between(const LaneView<D>& rows, const LaneView<D>& lanes, bool swap, Keep keep = Keep::all) {
  return {&rows, &lanes, swap, keep};
}

/// Continues a scan until it is done, fewer than lanes_max places are left in `room`, or `steps` is used up.
/// Writes pairs to `out` and returns their number. A pair is written, once, if it shares no class bit, its kinds
/// may meet, it is as `keep` says, and its beams meet (its boxes, if nothing moves). Other pairs are written
/// only because of rounding. A step is the start of a row, or a comparison with lanes_max boxes.
template <int D>
using ScanKernel = std::size_t (*)(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps);

template <int D, Simd simd>
ScanKernel<D> scan_kernel();

/// The kernel for the widest instructions in use.
template <int D>
ScanKernel<D> scan_kernel() {
  return with_simd_in_use([]<Simd simd>(Level<simd>) { return scan_kernel<D, simd>(); });
}

}  // namespace foresee::gpcd
