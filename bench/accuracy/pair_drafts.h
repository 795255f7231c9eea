// Drafts of pairs: one function for each numerical difficulty of families.h. A draft does not have reference
// times and scale yet (families.cpp).
//
//   Random random(7);
//   Maker maker(random, 8);             // within a horizon of 8
//   const Draft draft = graze(maker);   // the numbers of a, and of b relative to a
#pragma once

#include <cmath>
#include <cstdint>

#include "scenes.h"

namespace foresee::bench {

using testing::Random;

/// A draft of a pair: the numbers of a and those of b relative to a. Relative numbers on a lattice of
/// sixteenths stay exact when they are added to those of a.
struct Draft {
  double x[3] = {}, v[3] = {}, a[3] = {};                 ///< of a
  double to_x[3] = {}, to_v[3] = {}, to_a[3] = {};        ///< of b, minus those of a
  double half[2][3] = {{1, 1, 1}, {1, 1, 1}}, r[2] = {};  ///< r of balls
};

/// Random numbers, and places on a lattice where sums and small products are exact.
class Maker {
 public:
  Maker(Random& random, double h) : random(random), h(h) {}

  double lattice(double range) { return std::floor(random.in(-16 * range, 16 * range)) / 16; }
  bool chance(std::uint64_t in) { return random.below(in) == 0; }

  Draft anything(double places, double speeds, double turns) {
    Draft d;
    for (int j = 0; j < 3; ++j) {
      d.x[j] = random.in(-places, places), d.to_x[j] = random.in(-places, places);
      d.v[j] = random.in(-speeds, speeds), d.to_v[j] = random.in(-speeds, speeds);
      d.a[j] = random.in(-turns, turns), d.to_a[j] = random.in(-turns, turns);
      d.half[0][j] = random.in(0.25, 1), d.half[1][j] = random.in(0.25, 1);
    }
    d.r[0] = random.in(0.25, 1), d.r[1] = random.in(0.25, 1);
    return d;
  }

  /// On the lattice: sums and small products are exact.
  Draft plain(double places = 8) {
    Draft d;
    for (int j = 0; j < 3; ++j) {
      d.x[j] = lattice(places), d.v[j] = lattice(3), d.a[j] = lattice(1);
      d.half[0][j] = 0.5 + std::abs(lattice(1)), d.half[1][j] = 0.5 + std::abs(lattice(1));
    }
    return d;
  }

  /// The time of the exact event: strictly inside the horizon.
  double time() { return (1 + static_cast<double>(random.below(14))) / 16 * h; }

  /// Places b at `place` on axis j at time t0, with relative speed v and acceleration a at that time.
  void pass(Draft& d, int j, double place, double t0, double v, double a) {
    d.to_x[j] = place - v * t0 + a * t0 * t0 / 2;
    d.to_v[j] = v - a * t0;
    d.to_a[j] = a;
  }

  Random& random;
  double h;
};

// The families of families.h, by its names; sparse, dense and accelerated have no difficulty.
Draft sparse(Maker& m);
Draft dense(Maker& m);
Draft accelerated(Maker& m);
Draft graze(Maker& m);
Draft simultaneous(Maker& m);
Draft near_parallel(Maker& m);
Draft far_away(Maker& m);
Draft still(Maker& m);
Draft meeting_points(Maker& m);
Draft cancelling(Maker& m);
Draft mixed(Maker& m);
Draft unix_times(Maker& m);
Draft in_out_in(Maker& m);
Draft tangent(Maker& m);

}  // namespace foresee::bench
