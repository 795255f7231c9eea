// Beams (beam.h) in structure-of-arrays form, as vector instructions read and write them.
#pragma once

#include <cstddef>

#include "base/simd.h"

namespace foresee {

/// Beams and the input that they are computed from.
template <int D>
struct BeamLanes {
  static constexpr std::size_t width = 64;

  double lower[D][width] = {}, upper[D][width] = {}, travel[D][width] = {}, begin[width] = {},
         end[width] = {};

  // Input: motions, and extents below and above. Intermediate: the life as time since t, and `parts`, the
  // horizon as a multiple of the life: 0 if the life is too short, below 0 if it is empty.
  double x[D][width] = {}, v[D][width] = {}, a[D][width] = {};
  double below[D][width] = {}, above[D][width] = {};
  double t[width] = {}, until[width] = {};
  double from[width] = {}, to[width] = {}, reach[width] = {}, parts[width] = {};
};

/// The loops over lanes, compiled once per instruction set.
template <int D>
struct BeamKernels {
  /// Computes from, to, reach, parts, begin and end from t and until, as life_of() of swept_box.h does.
  void (*find_lives)(BeamLanes<D>& lanes, std::size_t count, double now, double h);
  /// Computes lower, upper and travel from lives and motions without acceleration.
  void (*find_beams)(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]);
  /// The same with acceleration.
  void (*find_bent_beams)(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]);
};

template <int D, Simd simd>
const BeamKernels<D>& beam_kernels();

}  // namespace foresee
