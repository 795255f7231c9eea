// Beams side by side (beam.h says what they are), as vector instructions read and write them.
#pragma once

#include <cstddef>

#include "base/simd.h"

namespace foresee {

/// Beams, and what they are computed from.
template <int D>
struct BeamLanes {
  static constexpr std::size_t width = 64;

  double lower[D][width] = {}, upper[D][width] = {}, travel[D][width] = {}, begin[width] = {},
         end[width] = {};

  // Motions, and how far there is something below and above; when they hold, as time since t; how often
  // the life fits into the horizon: 0 if that is too short to say, below 0 for none.
  double x[D][width] = {}, v[D][width] = {}, a[D][width] = {};
  double below[D][width] = {}, above[D][width] = {};
  double t[width] = {}, until[width] = {};
  double from[width] = {}, to[width] = {}, reach[width] = {}, parts[width] = {};
};

/// The loops over lanes, compiled for one level of instructions each.
template <int D>
struct BeamKernels {
  /// from, to, reach, parts, begin and end of what has t and until; life_of() of life_interval.h, side by side.
  void (*find_lives)(BeamLanes<D>& lanes, std::size_t count, double now, double h);
  /// lower, upper and travel, from motions without acceleration and lives.
  void (*find_beams)(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]);
  /// The same with acceleration.
  void (*find_bent_beams)(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]);
};

template <int D, Simd simd>
const BeamKernels<D>& beam_kernels();

}  // namespace foresee
