// Which boxes of a stripe overlap? GPCD steps 4 and 5a: the scan kernel, from left to right.
//
//   Scan<2> scan = scan_within(members);
//   while (!scan.done()) written += run(scan, pairs + written, room - written, steps);
//
// Each row is compared with the boxes that begin before it ends, lanes_per_step at a time; the loop is
// written so that compilers turn it into vector instructions, and hits are stored without a branch. A scan
// can pause after any step. All the time of a dense join is spent here, so the file has no other purpose: a
// kernel for another instruction set replaces run() and nothing else.
#pragma once

#include <cstddef>

#include "index/gpcd_grid/lanes.h"
#include "motion/bodies.h"

namespace foresee::gpcd {

template <int D>
struct Scan {
  const Lanes<D>* rows = nullptr;
  const Lanes<D>* lanes = nullptr;  ///< the same as rows: each pair among them once
  bool swap = false;                ///< report {lane, row} in place of {row, lane}
  std::size_t row = 0;
  std::size_t lane = 0;  ///< where the row goes on, once it has begun
  std::size_t left = 0;  ///< lanes before this one end before the row, and every later row, begins
  bool begun = false;    ///< the row

  bool done() const { return row >= rows->size; }
};

/// Each pair among `lanes` once.
template <int D>
Scan<D> scan_within(const Lanes<D>& lanes) {
  return {&lanes, &lanes};
}

/// Each pair of one of `rows` and one of `lanes`.
template <int D>
Scan<D> scan_between(const Lanes<D>& rows, const Lanes<D>& lanes, bool swap) {
  return {&rows, &lanes, swap};
}

/// Goes on with a scan until it is done, `room` has fewer than lanes_per_step places left, or `steps` is used
/// up; writes the pairs to `out` and answers how many. Every row costs a step, every lanes_per_step boxes
/// another.
template <int D>
std::size_t run(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps);

}  // namespace foresee::gpcd
