// The loops of BoxKernel that settle pairs of boxes, for box_lanes.kernel.cpp. Everything here is local to
// the file that includes it.
//
// Error bounds
// ------------
// Let M = |x| + H + s (|v| + s |a|) and u = 2^-53. Each value computed here from the motion at times up to s
// has at most 20 roundings, of terms whose magnitudes M counts. The error of the motion itself adds ex + s
// ev. The total error is at most ex + s ev + 32u M. Underflow adds less than 2^-900, because times are below
// 2^40.
#pragma once

#include "base/lane_math.h"
#include "base/registers.h"
#include "contact/boxes/box_lanes.h"
#include "numbers/crossed_root.h"

namespace foresee {
namespace {

using foresee::greater, foresee::lesser;  // next to the overloads of base/doubles.h, which would hide them

constexpr double huge = 0x1p1000, never = __builtin_inf(), underflow = 0x1p-900;
constexpr double near = 0x1p-34;  // relative distance from the approximate root at which signs are certified

/// An approximation of the first root of c + w t + k t^2, where c > 0; `never` if it has no root.
template <int Degree>
double first_root(double c, double w, double k) {
  if constexpr (Degree < 2) {
    return w < 0 ? c / -w : never;
  } else {
    const double discriminant = w * w - 4 * k * c;
    const double root = __builtin_sqrt(greater(discriminant, 0));
    const bool leaving = w > 0;
    const double time = (leaving ? w + root : 2 * c) / (leaving ? -2 * k : root - w);
    return discriminant >= 0 && time >= 0 ? time : never;
  }
}

/// x + v s + a s^2; without the last term for degree 1.
template <int Degree>
double place_at(double x, double v, double a, double s) {
  if constexpr (Degree < 2)
    return x + s * v;
  else
    return x + s * (v + s * a);
}

/// The minimum of c + w s + k s^2; -inf if k <= 0. If the minimum is above 0, then w^2 / 4k is below c, and
/// its roundings are counted in M. An overflow gives -inf.
inline double bottom(double c, double w, double k) {
  return k > 0 ? c - w * (0.25 * (w / k)) : -never;
}

/// A lower bound of c + w s + k s^2 on [0, length], where `last` is the value at `length`. A line is lowest
/// at an end.
template <int Degree>
double floor_of(double c, double w, double k, double length, double last) {
  if constexpr (Degree < 2)
    return lesser(c, last);
  else
    return lesser(lesser(c, greater(c + 0.5 * length * w, bottom(c, w, k))), last);
}

/// Bound on the error of a position, from the error of the motion and the magnitudes M.
inline double error_bound(double of_motion, double size) {
  return of_motion + 0x1p-48 * size + underflow;
}

template <int D, int Degree>
void settle_here(BoxLanes<D, Degree>& lanes) {
  for (int l = 0; l < lanes.width; ++l) {
    const double end = lanes.end[l];
    const auto magnitude = [&lanes, l](int j, double s) {
      return place_at<Degree>(absolute(lanes.x[j][l]) + lanes.half[j][l], absolute(lanes.v[j][l]),
                              absolute(lanes.a[j][l]), s);
    };
    const auto error = [&lanes, l](int j, double s, double size) {
      return error_bound(lanes.ex[j][l] + s * lanes.ev[j][l], size);
    };
    const auto place = [&lanes, l](int j, double s) {
      return place_at<Degree>(lanes.x[j][l], lanes.v[j][l], lanes.a[j][l], s);
    };

    // The approximation: the axis that is entered last, and its quadratic.
    double time = 0, axis = 0, from_side = 1, gap = 0, slope = 0, bend = 0, size = 0, lost = 0,
           lost_slope = 0;
    double inside_now = never, all = 0;
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      const double x = lanes.x[j][l], side = x < 0 ? -1 : 1;
      const double c = absolute(x) - lanes.half[j][l], w = side * lanes.v[j][l], k = side * lanes.a[j][l];
      const double entry = c > 0 ? first_root<Degree>(c, w, k) : 0;
      const bool later = entry > time;
      time = later ? entry : time;
      axis = later ? j : axis;
      from_side = later ? side : from_side;
      gap = later ? c : gap, slope = later ? w : slope, bend = later ? k : bend;
      size = later ? absolute(x) + lanes.half[j][l] : size;
      lost = later ? lanes.ex[j][l] : lost, lost_slope = later ? lanes.ev[j][l] : lost_slope;
      inside_now = lesser(inside_now, -c - error(j, 0, absolute(x) + lanes.half[j][l]));
      all += magnitude(j, end) + lanes.ex[j][l] + end * lanes.ev[j][l];
    }

    const double before = lesser(time * (1 - near), end), after = lesser(time * (1 + near), end);
    const double reach = place_at<Degree>(size, absolute(slope), absolute(bend), before);
    const double lost_before = error_bound(lost + before * lost_slope, reach);
    const double at_before = place_at<Degree>(gap, slope, bend, before);
    const double apart_before = floor_of<Degree>(gap, slope, bend, before, at_before) - lost_before;

    double inside_after = never, apart_after = -never;
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      const double half = lanes.half[j][l], v = lanes.v[j][l], a = lanes.a[j][l];
      const double size_after = magnitude(j, after);
      const double error_after = error(j, after, size_after);
      // Between `before` and `after` an axis moves by less than 2^-32 of its magnitudes.
      const double moves = axis == j ? 0 : 0x1p-31 * size_after + error_after;
      inside_after = lesser(inside_after, half - absolute(place(j, after)) - error_after - moves);
      const double here = place(j, before), side = here < 0 ? -1 : 1;
      const double first = side * here - half, last = side * place(j, end) - half;
      const double speed = side * (Degree < 2 ? v : v + 2 * before * a);
      const double lowest = floor_of<Degree>(first, speed, side * a, end - before, last);
      const double apart = lowest - error(j, end, magnitude(j, end));
      apart_after = greater(apart_after, apart);
    }

    // Nothing is certain if numbers or error bounds are so large that they may overflow, or NaN: lesser()
    // passes on a second argument that is NaN.
    const double fits = huge - all, end_inside = end * (1 - 0x1p-50);
    const double meets = lesser(end_inside < after ? -1 : inside_after, fits);
    lanes.touches_now[l] = lesser(inside_now, fits);
    lanes.misses[l] = lesser(lesser(apart_before, before < end ? apart_after : never), fits);
    lanes.meets[l] = meets;
    lanes.meets_first[l] = lesser(apart_before, meets);
    lanes.time[l] = time, lanes.before[l] = before, lanes.after[l] = after;
    lanes.axis[l] = axis, lanes.side[l] = from_side, lanes.room[l] = after - before;
  }
}

/// Reads D columns from `place` on into the lanes of `out`; reads nothing if `place` is below 0.
template <int D>
void take_columns(const double* const* rows, int place, double (&out)[D][lanes_width]) {
  if (place < 0) return;
  for (int lane = 0; lane < lanes_width; lane += register_width)
    for (int j = 0; j < D; ++j) store(&out[j][lane], column(rows + lane, place + j));
}

template <int D>
void take_boxes(typename RowLanes<D>::Side& side) {
  take_columns(side.rows, side.at_x, side.x);
  take_columns(side.rows, side.at_half, side.half);
}

template <int D, int Degree>
void take_motion(typename RowLanes<D>::Side& side) {
  take_columns(side.rows, side.at_v, side.v);
  if constexpr (Degree == 2) take_columns(side.rows, side.at_a, side.a);
}

template <int D, int Degree>
bool settle_rows_here(RowLanes<D>& rows, bool motions_wanted, BoxLanes<D, Degree>& lanes) {
  take_boxes<D>(rows.a);
  take_boxes<D>(rows.b);
  Register touching = Register{} + 1;
  for (int j = 0; j < D; ++j)
    for (int l = 0; l < lanes_width; l += register_width) {
      const Register x = load(rows.b.x[j] + l) - load(rows.a.x[j] + l);
      const Register half = load(rows.a.half[j] + l) + load(rows.b.half[j] + l) + rows.within;
      store(lanes.x[j] + l, x);
      store(lanes.half[j] + l, half);
      // The test of settle_here() for touches_now. False if half extents may overflow, or for NaN.
      const Register size = x < 0.0 ? -x : x, room = half - size - 0x1p-48 * (size + half) - underflow;
      touching = half < huge ? touching : -1.0 + Register{};
      touching = room > 0.0 ? touching : -1.0 + Register{};
    }
  double all = 1;
  for (int l = 0; l < register_width; ++l) all = lesser(all, touching[l]);
  if (all > 0 && !motions_wanted) return true;
  take_motion<D, Degree>(rows.a);
  take_motion<D, Degree>(rows.b);
  for (int j = 0; j < D; ++j)
    for (int l = 0; l < lanes_width; l += register_width) {
      store(lanes.v[j] + l, load(rows.b.v[j] + l) - load(rows.a.v[j] + l));
      if constexpr (Degree == 2) store(lanes.a[j] + l, 0.5 * (load(rows.b.a[j] + l) - load(rows.a.a[j] + l)));
      store(lanes.ev[j] + l, Register{});
      store(lanes.ex[j] + l, Register{});
    }
  settle_here(lanes);
  return false;
}

/// Selects for each lane, from a column per axis, the value on the axis of that lane.
template <int D>
inline void on_axis(const double (&axis)[lanes_width], const double (&columns)[D][lanes_width],
                    double (&out)[lanes_width]) {
  for (int l = 0; l < lanes_width; l += register_width) {
    Register value = load(columns[0] + l);
    for (int j = 1; j < D; ++j)
      value = load(axis + l) == static_cast<double>(j) ? load(columns[j] + l) : value;
    store(out + l, value);
  }
}

/// `From` is BoxLanes or EndLanes.
template <int D, int Degree, class From>
void take_crossings(const RowLanes<D>& rows, const From& from, MeetingLanes& __restrict meetings) {
  alignas(64) double x[2][lanes_width], v[2][lanes_width], a[2][lanes_width], half[2][lanes_width];
  for (int side = 0; side < 2; ++side) {
    const typename RowLanes<D>::Side& body = side == 0 ? rows.a : rows.b;
    on_axis(from.axis, body.x, x[side]);
    on_axis(from.axis, body.v, v[side]);
    if constexpr (Degree == 2) on_axis(from.axis, body.a, a[side]);
    on_axis(from.axis, body.half, half[side]);
  }
  for (int l = 0; l < lanes_width; ++l) {
    const DoubleDouble place = difference(x[1][l], x[0][l]), speed = difference(v[1][l], v[0][l]);
    const DoubleDouble size = sum(half[0][l], half[1][l]) + DoubleDouble{rows.within, 0};
    meetings.x[l] = place.high, meetings.x_low[l] = place.low;
    meetings.v[l] = speed.high, meetings.v_low[l] = speed.low;
    meetings.half[l] = size.high, meetings.half_low[l] = size.low;
    meetings.ex[l] = meetings.ev[l] = 0;
    meetings.side[l] = from.side[l], meetings.time[l] = from.time[l], meetings.room[l] = from.room[l];
  }
  if constexpr (Degree == 2)
    for (int l = 0; l < lanes_width; ++l) {
      const DoubleDouble turn = half_of(difference(a[1][l], a[0][l]));
      meetings.a[l] = turn.high, meetings.a_low[l] = turn.low;
    }
}

template <CrossingDirection direction, int Degree>
void find_crossings(MeetingLanes& lanes, double now) {
  for (int l = 0; l < lanes.width; ++l) {
    const double tau = lanes.time[l], side = lanes.side[l];
    const DoubleDouble t{tau, 0}, x{lanes.x[l], lanes.x_low[l]}, half{lanes.half[l], lanes.half_low[l]};
    DoubleDouble chord{lanes.v[l], lanes.v_low[l]};
    double half_turn = 0, bend = 0;
    if constexpr (Degree > 1) {
      chord = chord + t * DoubleDouble{lanes.a[l], lanes.a_low[l]};
      half_turn = tau * lanes.a[l], bend = 2 * absolute(lanes.a[l]);
    }
    const double speed = absolute(lanes.v[l]) + absolute(half_turn);
    const double error =
        error_bound(lanes.ex[l] + tau * lanes.ev[l], absolute(lanes.x[l]) + lanes.half[l] + tau * speed);
    const DoubleDouble place = x + t * chord;
    const DoubleDouble value = DoubleDouble{side * place.high, side * place.low} - half;
    // The error of DoubleDouble is at most 2^-97 of the magnitudes that the bound for doubles counts in
    // 2^-53.
    const Crossed crossed{value, error * 0x1p-44 + underflow, side * (lanes.v[l] + 2 * half_turn),
                          lanes.ev[l] + 0x1p-49 * speed + underflow, bend + underflow};
    const Instant meeting = root_of<direction>(crossed, now, tau, lanes.room[l]);
    lanes.dt[l] = meeting.dt, lanes.t[l] = meeting.t;
  }
}

}  // namespace
}  // namespace foresee
