// Which beams of a stripe could touch? GPCD steps 4, 5a and 5c: the scan kernel, from left to right.
//
//   const ScanKernel<2> run = scan_kernel<2>();
//   Scan<2> scan = scan_within(lanes);
//   while (!scan.done()) written += run(scan, pairs + written, room - written, steps);
//
// Each row is compared with the boxes that begin before it ends, as many at a time as a vector register
// holds: first the boxes (space), then, where something moves, the beams (time). A scan can pause after any
// step. Every instruction set gives the same pairs in the same order (scan.kernel.cpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/pair.h"
#include "base/simd.h"
#include "index/gpcd_grid/object_rows.h"

namespace foresee::gpcd {

/// The most lanes that one step looks at; behind the last lane stand so many sentinels that begin at
/// infinity.
inline constexpr std::size_t lanes_max = 16;
/// The class of a sentinel: it is never reported.
inline constexpr std::uint32_t sentinel = 4;

/// Beams as contiguous arrays, sorted by lower[0].
template <int D>
struct LaneView {
  const float *lower[D] = {}, *upper[D] = {};
  const float* travel[D] = {};                   ///< null where nothing moves, and so are the next two
  const float *centre[D] = {}, *extent[D] = {};  ///< of what moves, at half the horizon; centre times two
  const float *begin = nullptr, *end = nullptr;  ///< null where all exist throughout
  const float *from = nullptr, *to = nullptr;  ///< of rows: which lanes count (lanes.cpp); null: lower, upper
  const float *core_lower[D] = {}, *core_upper[D] = {};  ///< of rows (giants.h); null where none has a core
  const std::uint32_t *classes = nullptr, *ids = nullptr;
  ObjectRows objects;
  std::size_t size = 0;
  double longest = 0;  ///< no box is longer along x; rounded up
};

/// Which pairs a scan reports. A lane is covered by a row if it lies in the row's core when the horizon
/// begins.
enum class Keep : std::uint8_t { all, covered, others };

/// Requires: both views have the same columns; rows with cores, unless `keep` is all.
template <int D>
struct Scan {
  const LaneView<D>* rows = nullptr;
  const LaneView<D>* lanes = nullptr;  ///< the same as rows: each pair among them once
  bool swap = false;                   ///< report {lane, row} in place of {row, lane}
  Keep keep = Keep::all;
  std::size_t row = 0;
  std::size_t lane = 0;  ///< where the row goes on, once it has begun
  std::size_t left = 0;  ///< lanes before this one end before the row, and every later row, begins
  bool begun = false;    ///< the row

  bool done() const { return row >= rows->size; }
};

/// Each pair among `lanes` once.
template <int D>
Scan<D> scan_within(const LaneView<D>& lanes) {
  return {&lanes, &lanes};
}

/// Each pair of one of `rows` and one of `lanes`.
template <int D>
Scan<D> scan_between(const LaneView<D>& rows, const LaneView<D>& lanes, bool swap, Keep keep = Keep::all) {
  return {&rows, &lanes, swap, keep};
}

/// Goes on with a scan until it is done, `room` has fewer than lanes_max places left, or `steps` is used up;
/// writes the pairs to `out` and answers how many. Of the pairs that share no class it writes each, once,
/// that `keep` asks for and whose beams meet (boxes, where nothing moves); others only by rounding. A step is
/// a row begun, or lanes_max boxes looked at.
template <int D>
using ScanKernel = std::size_t (*)(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps);

template <int D, Simd simd>
ScanKernel<D> scan_kernel();

/// Of the widest instructions in use.
template <int D>
ScanKernel<D> scan_kernel() {
  return with_simd_in_use([]<Simd simd>(Level<simd>) { return scan_kernel<D, simd>(); });
}

}  // namespace foresee::gpcd
