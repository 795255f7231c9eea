// Contact of boxes, sixteen pairs at a time in vector lanes: whether a pair touches, and about when. Each
// answer is one approximate root per pair, certified by signs with error bounds.
//
//   const BoxKernel<2, 1>& kernel = box_kernel<2, 1>();   // for this CPU
//   rows.a.rows[l] = …, rows.b.rows[l] = …; lanes.end[l] = h;        // pair number l of at most `width`
//   kernel.settle_rows(rows, true, lanes);                // with motions, because ends are requested too
//   lanes.misses[l] > 0, lanes.meets_first[l] > 0;        // or neither
//
// The approximation: on every axis on which the boxes are apart, the first root of a quadratic; the boxes
// meet at the latest of these times. Signs at a relative distance of 2^-34 from it certify the answer: the
// boxes are apart until shortly before, and overlap on every axis shortly after. An interval without a root
// is certified by three positive Bernstein coefficients, or by the minimum of the quadratic. Where that fails
// (grazes, several axes at one time, extreme numbers) the lane gives no answer, and UnionContact decides
// the pair.
//
// One loop over the lanes without branches, which compilers turn into the vector instructions of the CPU; all
// give the same bits. Cost: some ten nanoseconds per pair. Source for the coefficients: Farouki, "The
// Bernstein polynomial basis: a centennial retrospective" (2012), section 5.
#pragma once

#include "base/simd.h"
#include "contact/certified/certain_axis_motion.h"

namespace foresee {

constexpr int lanes_width = 16;  // two of the widest registers: one computes during the latency of the other

/// Pairs whose reference time is `now`, by their rows.
template <int D>
struct RowLanes {
  struct Side {
    const double* rows[lanes_width];
    int at_x, at_v, at_a, at_half;  ///< where columns start in a row; below 0: not there, all 0
    alignas(64) double x[D][lanes_width] = {};
    double v[D][lanes_width] = {}, a[D][lanes_width] = {}, half[D][lanes_width] = {};
  } a, b;
  double within, now;
};

template <int D, int Degree>
struct BoxLanes {
  static constexpr int width = lanes_width;

  /// Motion from 0 to `end` (rounded up, at most 2^40) and half extents on each axis. Errors of x and v are
  /// at most ex + 4u|x| and ev + 4u|v|, those of a and half 4u.
  alignas(64) double x[D][width] = {};
  double v[D][width] = {}, a[D][width] = {}, half[D][width] = {};
  double ex[D][width] = {}, ev[D][width] = {};
  double end[width] = {};

  // The results of settle(): a statement is certain if its number is above 0.
  double misses[width];       ///< the boxes never touch
  double touches_now[width];  ///< they touch at time 0
  double meets[width];        ///< they touch at `after`
  double meets_first[width];  ///< their first contact, on `axis`, is between `before` and `after`
  double time[width], before[width], after[width], axis[width];
  double side[width], room[width];  ///< 1 or -1: the side that x comes from; after - before
};

/// The times of crossings: motion and half extents, in DoubleDouble, on the axis on which the boxes of each
/// lane meet.
struct MeetingLanes {
  static constexpr int width = lanes_width;

  alignas(64) double x[width] = {};
  double v[width] = {}, a[width] = {}, half[width] = {};
  double x_low[width] = {}, v_low[width] = {}, a_low[width] = {}, half_low[width] = {};
  double ex[width] = {}, ev[width] = {};                        ///< as in BoxLanes
  double side[width] = {}, time[width] = {}, room[width] = {};  ///< as in BoxLanes or EndLanes

  double dt[width], t[width];  ///< each rounded once; NaN where find_meetings() finds no answer
};

/// The ends of contacts that BoxLanes have found.
struct EndLanes {
  alignas(64) double from[lanes_width] = {};  ///< a time at which the boxes certainly touch

  // The results of settle_ends(), as in BoxLanes.
  double lasts[lanes_width];   ///< they touch until `end`
  double leaves[lanes_width];  ///< the contact ends at about `time`, on `axis` and `side`
  double time[lanes_width], room[lanes_width], axis[lanes_width], side[lanes_width];
};

/// The loops over lanes, compiled for one set of vector instructions.
template <int D, int Degree>
struct BoxKernel {
  /// Fills in the results.
  void (*settle)(BoxLanes<D, Degree>& lanes);
  /// settle() of pairs whose reference time is `now`, from their rows; lanes.end is given. True if all lanes touch now
  /// and no motions are requested: then no other result is filled in.
  bool (*settle_rows)(RowLanes<D>& rows, bool motions_wanted, BoxLanes<D, Degree>& lanes);
  /// Takes the motions of lanes that settle_rows() has settled.
  void (*take_meetings)(const RowLanes<D>& rows, const BoxLanes<D, Degree>& lanes, MeetingLanes& meetings);
  /// Fills in dt and t.
  void (*find_meetings)(MeetingLanes& lanes, double now);
  /// As settle(), take_meetings() and find_meetings(), for ends of lanes that settle_rows() has settled.
  void (*settle_ends)(const BoxLanes<D, Degree>& lanes, EndLanes& ends);
  void (*take_ends)(const RowLanes<D>& rows, const EndLanes& ends, MeetingLanes& meetings);
  void (*find_ends)(MeetingLanes& lanes, double now);
};

template <int D, int Degree, Simd simd>
const BoxKernel<D, Degree>& box_kernel();

/// The kernel of the widest instructions in use.
template <int D, int Degree>
const BoxKernel<D, Degree>& box_kernel() {
  return with_simd_in_use(
      []<Simd simd>(Level<simd>) -> const BoxKernel<D, Degree>& { return box_kernel<D, Degree, simd>(); });
}

/// Fills lane l with a pair that exists from now to `end` (rounded up). Requires: times are below 2^40.
template <int D, int Degree>
void put_motion(BoxLanes<D, Degree>& lanes, int l, const CertainMotion<D>& relative, const double (&half)[D],
                double end) {
  for (int j = 0; j < D; ++j) {
    const CertainAxisMotion<double>& r = relative.axis[j];
    lanes.x[j][l] = r.x, lanes.v[j][l] = r.v, lanes.half[j][l] = half[j];
    lanes.ex[j][l] = r.ex, lanes.ev[j][l] = r.ev;
    if constexpr (Degree == 2) lanes.a[j][l] = r.a;
  }
  lanes.end[l] = end;
}

}  // namespace foresee
