// Kernel (base/simd.h) that computes beams (beam.h): loops without branches, which compilers vectorize.
//
// Error analysis of the bounds
// ----------------------------
// As in swept_box.cpp: with S = reach and M = |x| + |v| S + |a| S^2, the computed ends of the chord are off
// by at most 5u M, and so is every place of the path that they stand for. The sagitta |a| T^2 / 8 is computed
// with four roundings from a T that is itself off by 4u S: this adds 2u M at most. Adding it to the
// chord and rounding the travel lose u M each, the last sum u (M + size), the three sums before it 3u size:
// 10u M + 4u size in all. 24u (M + size) + (S + 4) 2^-1020 is more than twice that, underflow and the
// roundings of the bound itself included. An object at rest is off by the same sums only: u |x| + 4u size.
//
// If an object exists for only a part of the horizon, its travel has the roundings of a quotient of at most
// 64. The moving box is then wrong by at most a relative 2^-40 of the travel, which is added.
//
// Any overflow makes M infinite or NaN, and with it the extent of the box: then both ends are infinite. If
// the second argument of lesser() or greater() is NaN, they return it.
#include "base/lane_math.h"
#include "base/simd.h"
#include "motion/beam_lanes.h"

namespace foresee {
namespace {

constexpr double u = 0x1p-53, unbounded = __builtin_inf();
constexpr double shortest_part = 1.0 / 64;  // of the horizon; the box of a shorter life does not move
constexpr std::size_t block = 8;            // lanes per step: those of the widest register

/// Computes from, to, reach, parts, begin and end from t and until, as life_of() of swept_box.h does.
template <int D>
void find_lives(BeamLanes<D>& lanes, std::size_t count, double now, double h) {
  const double unit = h > 0 ? h : 1, min_end = h > 0 ? 0 : 1;
  for (std::size_t first = 0; first < count; first += block)
    for (std::size_t l = first; l < first + block; ++l) {
      const double t = lanes.t[l], until = lanes.until[l], since = now - t;
      lanes.from[l] = greater(since, 0);
      lanes.to[l] = lesser(since + h, until - t);
      lanes.reach[l] = absolute(since) + h;
      // Rounding keeps order: if t - now, rounded, exceeds the double h, then so does the exact difference.
      const bool none = (t - now > h) | (until < now);
      const double begin = lesser(greater(t - now, 0) / unit, 1);
      const double end = greater(lesser(until - now, h) / unit, min_end), part = end - begin;
      const double parts = part >= shortest_part ? 1 / part : 0;
      lanes.begin[l] = none ? 0 : begin;
      lanes.end[l] = none ? 1 : end;
      lanes.parts[l] = none ? -1 : parts;
    }
}

/// Computes lower, upper and travel from motions and lives; `bent`: with acceleration.
template <int D, bool bent>
void find_beams(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]) {
  for (int k = 0; k < D; ++k)
    for (std::size_t first = 0; first < count; first += block)
      for (std::size_t l = first; l < first + block; ++l) {
        const double x = lanes.x[k][l], v = lanes.v[k][l], a = bent ? lanes.a[k][l] : 0;
        const double from = lanes.from[l], to = lanes.to[l], reach = lanes.reach[l], parts = lanes.parts[l];
        const double below = lanes.below[k][l] + margin[k], above = lanes.above[k][l] + margin[k];
        const double time = to - from;
        const bool still = (v == 0) & (a == 0);  // also where a time is infinite
        const double starts = x + from * (bent ? v + a * from * 0.5 : v);
        const double ends = x + to * (bent ? v + a * to * 0.5 : v);
        const double begin = still ? x : starts, end = still ? x : ends;
        const double bow = still ? 0 : bent ? a * time * time * 0.125 : 0;
        const double travel = (end - begin) * parts;
        const double speed = bent ? absolute(v) + absolute(a) * reach : absolute(v);
        const double weight = absolute(x) + greater(absolute(below), absolute(above));
        const double moving_error = 24 * u * (weight + reach * speed) + (reach + 4) * 0x1p-1020;
        const double error = still ? 8 * u * weight + 0x1p-1020 : moving_error;
        const double lost = parts == 1 ? 0 : 0x1p-40 * absolute(travel);
        const double lower = (lesser(begin, end) + lesser(-bow, 0)) - (below + error + lost);
        const double upper = (greater(begin, end) + greater(-bow, 0)) + (above + error + lost);
        const bool sound = upper - lower < unbounded, none = parts < 0;
        lanes.lower[k][l] = none ? unbounded : sound ? lower : -unbounded;
        lanes.upper[k][l] = none ? -unbounded : sound ? upper : unbounded;
        lanes.travel[k][l] = none ? 0 : travel;
      }
}

}  // namespace

template <int D, Simd simd>
const BeamKernels<D>& beam_kernels() {
  static constexpr BeamKernels<D> kernels{find_lives<D>, find_beams<D, false>, find_beams<D, true>};
  return kernels;
}

template const BeamKernels<1>& beam_kernels<1, Simd::FORESEE_SIMD>();
template const BeamKernels<2>& beam_kernels<2, Simd::FORESEE_SIMD>();
template const BeamKernels<3>& beam_kernels<3, Simd::FORESEE_SIMD>();

}  // namespace foresee
