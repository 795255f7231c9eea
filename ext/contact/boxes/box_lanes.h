// Boxes against boxes, sixteen pairs at once: whether they touch and about when, from one guess a pair that
// is then certified.
//
//   const BoxKernel<2, 1>& kernel = box_kernel<2, 1>();   // of this CPU
//   rows.a.rows[l] = …, rows.b.rows[l] = …; lanes.end[l] = h;        // pair number l of at most `width`
//   kernel.settle_rows(rows, true, lanes);                // with motions, as ends are asked for too
//   lanes.misses[l] > 0, lanes.meets_first[l] > 0;        // or neither
//
// The guess is a textbook's: on every axis on which the boxes are apart, the first root of a quadratic; the
// latest of those moments is when they meet. What makes it certain are signs with error bounds, away from the
// guess by a relative 2^-34: apart until shortly before it, inside on every axis shortly after it. A stretch
// without a root is certified by its three Bernstein coefficients being positive, or by its lowest point.
// Where that fails (grazes, several axes at one moment, extreme numbers) no answer is given, and an
// Advancement must find it.
//
// One loop over the lanes, without branches, which compilers turn into the vector instructions of the CPU;
// all give the same bits. Cost: some ten nanoseconds a pair. Source for the coefficients: Farouki, "The
// Bernstein polynomial basis: a centennial retrospective" (2012), section 5.
#pragma once

#include "base/simd.h"

namespace foresee {

constexpr int lanes_width = 16;  // two of the widest registers: one computes while the other waits

/// The pairs whose reference time is `now`, by their rows.
template <int D>
struct RowLanes {
  struct Side {
    const double* rows[lanes_width];
    int at_x, at_v, at_a, at_half;  ///< where columns begin in a row; below 0: not there, all 0
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

  // What settle() finds: a statement is certain where its number is above 0.
  double misses[width];       ///< they never touch
  double touches_now[width];  ///< they touch at 0
  double meets[width];        ///< they touch at `after`
  double
      meets_first[width];  ///< between `before` and `after` for the first time, entering each other on `axis`
  double time[width], before[width], after[width], axis[width];
  double side[width], room[width];  ///< 1 or -1: where x comes from; after - before
};

/// When? The motion and the half extents, in DoubleDouble, on the axis on which the boxes of each lane meet.
struct MeetingLanes {
  static constexpr int width = lanes_width;

  alignas(64) double x[width] = {};
  double v[width] = {}, a[width] = {}, half[width] = {};
  double x_low[width] = {}, v_low[width] = {}, a_low[width] = {}, half_low[width] = {};
  double ex[width] = {}, ev[width] = {};                        ///< as in BoxLanes
  double side[width] = {}, time[width] = {}, room[width] = {};  ///< as in BoxLanes or EndLanes

  double dt[width], t[width];  ///< each rounded once; NaN where find_meetings() cannot tell
};

/// Where contacts end that BoxLanes have found.
struct EndLanes {
  alignas(64) double from[lanes_width] = {};  ///< the boxes certainly touch then

  // What settle_ends() finds, as in BoxLanes.
  double lasts[lanes_width];   ///< they touch until `end`
  double leaves[lanes_width];  ///< the contact ends about `time`, on `axis` and `side`
  double time[lanes_width], room[lanes_width], axis[lanes_width], side[lanes_width];
};

/// The loops over lanes, compiled for one kind of CPU.
template <int D, int Degree>
struct BoxKernel {
  /// Fills in what is found.
  void (*settle)(BoxLanes<D, Degree>& lanes);
  /// The same for pairs whose reference time is `now`; lanes.end is given. True if all lanes touch now and no
  /// motions are wanted: nothing else is then found.
  bool (*settle_rows)(RowLanes<D>& rows, bool motions_wanted, BoxLanes<D, Degree>& lanes);
  /// Takes the motions of lanes that settle_rows() has settled.
  void (*take_meetings)(const RowLanes<D>& rows, const BoxLanes<D, Degree>& lanes, MeetingLanes& meetings);
  /// Fills in dt and t.
  void (*find_meetings)(MeetingLanes& lanes, double now);
  /// The same three for ends, of lanes that settle_rows() has settled.
  void (*settle_ends)(const BoxLanes<D, Degree>& lanes, EndLanes& ends);
  void (*take_ends)(const RowLanes<D>& rows, const EndLanes& ends, MeetingLanes& meetings);
  void (*find_ends)(MeetingLanes& lanes, double now);
};

template <int D, int Degree, Simd simd>
const BoxKernel<D, Degree>& box_kernel();

/// Of the widest instructions in use.
template <int D, int Degree>
const BoxKernel<D, Degree>& box_kernel() {
  return with_simd_in_use(
      []<Simd simd>(Level<simd>) -> const BoxKernel<D, Degree>& { return box_kernel<D, Degree, simd>(); });
}

}  // namespace foresee
