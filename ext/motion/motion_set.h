// Where can an object be that changes its motion by any k of a range? All its changed motions together, asked
// one direction at a time: how far along n do places, velocities and accelerations reach at most?
//
//   const MotionSet<2> turns = motions_between<2>(base, change, -10, 10);
//   turns.velocity.support({0, 1})                               // no changed motion is faster northward
//
// Upper bounds, all rounding included: that of the stored numbers, 4 units in the last place of each
// component of the velocity beside it (turned: of the longest; what is 0 stays 0), and that of these lines.
// They are as tight as a convex set allows: a segment for speed, climb and accelerate, an arc for a turn; of
// a delay a segment too, with the bend of an accelerated path beside it. Cost: tens of nanoseconds.
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/manoeuvre.h"
#include "motion/motion.h"
#include "numbers/turned_vector.h"

namespace foresee {

/// Vectors `centre` + s `along`, |s| <= 1, or `centre` turned by an angle up to a half width; and beside each
/// `pad` on every axis.
template <int D>
struct VectorSet {
  Vec<D> centre = Vec<D>::Zero(), along = Vec<D>::Zero(), pad = Vec<D>::Zero();
  bool turns = false;
  double sine = 0, cosine = 1;  ///< of the half width of a turn
  bool whole_circle = false;
  double radius = 0;  ///< of the turn, at least

  /// An upper bound of n w over all w.
  double support(const Vec<D>& n) const {
    const Vec<D> size = n.abs();
    if (!turns) {
      const double straight = (n * centre).sum(), across = std::abs((n * along).sum());
      return straight + across + (size * (pad + 0x1p-49 * (centre.abs() + along.abs()))).sum();
    }
    return support_of_arc(n) + (size * pad).sum();
  }

  /// Its ends on one axis.
  double max(int axis) const { return support(unit(axis, 1)); }
  double min(int axis) const { return -support(unit(axis, -1)); }

 private:
  static Vec<D> unit(int axis, double length) {
    Vec<D> vector = Vec<D>::Zero();
    vector[axis] = length;
    return vector;
  }

  /// A cos f + B sin f over |f| <= the half width.
  double support_of_arc(const Vec<D>& n) const {
    if constexpr (D == 1) {
      return 0;  // nothing turns on one axis
    } else {
      const double a = n[0] * centre[0] + n[1] * centre[1], b = n[0] * centre[1] - n[1] * centre[0];
      const double all = std::sqrt(n[0] * n[0] + n[1] * n[1]) * radius;
      const bool inside = whole_circle || a >= cosine * all;
      double most = inside ? all : std::min(all, cosine * a + sine * std::abs(b));
      most += 0x1p-47 * all;
      if constexpr (D == 3) most += n[2] * centre[2] + 0x1p-49 * std::abs(n[2] * centre[2]);
      return most;
    }
  }
};

/// The changed motions as of the base's t: at tau seconds after it, all of them are at place + velocity tau +
/// acceleration tau^2 / 2, the place as seen from the base's own.
template <int D>
struct MotionSet {
  VectorSet<D> place, velocity, acceleration;
  double begin = 0, end = 0;  ///< none exists before or after, in seconds since the base's t
};

/// How near to each other two k in [p, q] may be before the pads of their motions tell more than they do: no
/// finer end can be proven.
double min_change(const OwnMotion& base, const Change& change, double p, double q);

/// Those of k in [p, q]. Requires: p <= q.
template <int D>
MotionSet<D> motions_between(const OwnMotion& base, const Change& change, double p, double q);

}  // namespace foresee
