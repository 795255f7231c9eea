// Sets of motions, described by support functions: how far positions, velocities and accelerations reach along a
// direction n.
//
//   const MotionSet<2> turns = changes_by(Manoeuvre::turn, base)->between<2>(-10, 10);    // motion/changes.h
//   turns.velocity.support({0, 1})                               // no changed motion is faster northward
//
// The support functions are upper bounds that include all rounding: of these computations, and of the stored
// numbers. A stored number may be off by 4 units in the last place: of each component of the velocity, or of
// the longest one for a turn; 0 stays 0. Bounds are as tight as a convex set allows: a segment for speed,
// climb and accelerate, an arc for a turn. A delay gives a segment too, padded by the curvature of an
// accelerated path. Cost: tens of nanoseconds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "motion/motion.h"
#include "numbers/correct_rounding.h"

namespace foresee {

/// The vectors `centre` + s `along`, |s| <= 1, or `centre` turned by at most a half width; each of them
/// inflated by `pad` on every axis.
template <int D>
struct VectorSet {
  Vec<D> centre = Vec<D>::zero(), along = Vec<D>::zero(), pad = Vec<D>::zero();
  bool is_arc = false;          ///< `centre` is turned
  double sine = 0, cosine = 1;  ///< of the half width of a turn
  bool whole_circle = false;
  double radius = 0;  ///< upper bound of the turn's radius
  double bulge = 0;   ///< without a turn: how far vectors may be from the chord of the first and the last

  /// The support function along n: an upper bound of n w over all vectors w of the set.
  double support(const Vec<D>& n) const {
    const Vec<D> size = n.abs();
    if (!is_arc) {
      const double straight = (n * centre).sum(), across = std::abs((n * along).sum());
      return straight + across + (size * (pad + 0x1p-49 * (centre.abs() + along.abs()))).sum();
    }
    return support_of_arc(n) + (size * pad).sum();
  }

  /// Bounds on one axis.
  double max(int axis) const { return support(unit(axis, 1)); }
  double min(int axis) const { return -support(unit(axis, -1)); }

 private:
  static Vec<D> unit(int axis, double length) {
    Vec<D> vector = Vec<D>::zero();
    vector[axis] = length;
    return vector;
  }

  /// The maximum of A cos f + B sin f over |f| <= the half width.
  double support_of_arc(const Vec<D>& n) const {
    if constexpr (D == 1) {
      return 0;  // nothing turns on one axis
    } else {
      const double a = n[0] * centre[0] + n[1] * centre[1], b = n[0] * centre[1] - n[1] * centre[0];
      const double all = std::sqrt(n[0] * n[0] + n[1] * n[1]) * radius;
      const bool inside = whole_circle || a >= cosine * all;
      double bound = inside ? all : std::min(all, cosine * a + sine * std::abs(b));
      bound += 0x1p-47 * all;
      if constexpr (D == 3) bound += n[2] * centre[2] + 0x1p-49 * std::abs(n[2] * centre[2]);
      return bound;
    }
  }
};

/// Relative error of stored numbers: eight units in the last place cover four beside the stored number, its
/// rounding, and the roundings of these lines.
inline constexpr double pad_of_stored = 0x1p-49;
/// Covers the underflow of a number that is not 0.
inline constexpr double lost_by_underflow = 8 * std::numeric_limits<double>::denorm_min();

/// One vector as it is stored.
template <int D>
VectorSet<D> stored_vector(const Vec<D>& vector);

/// `vector` turned by any angle of [middle - half, middle + half], in degrees.
template <int D>
VectorSet<D> turned_vectors(const Vec<D>& vector, double middle, double half);

/// `vector` + s `course` for all |s - middle| <= half.
template <int D>
VectorSet<D> added_vectors(const Vec<D>& vector, const Vec<D>& course, double middle, double half);

/// `vector` times ((m + k) / m)^2 for all k of [p, q].
template <int D>
VectorSet<D> vectors_scaled_by_square(const Vec<D>& vector, double m, double p, double q);

/// Motions relative to a reference motion: tau seconds after its t, each position is in place + velocity tau +
/// acceleration tau^2 / 2, relative to its position.
template <int D>
struct MotionSet {
  VectorSet<D> place, velocity, acceleration;
  double begin = 0, end = 0;  ///< no motion exists before or after, in seconds since the reference's t
  /// Of motions that each start at a time of their own, all at one position with one velocity.
  struct Starts {
    double from = 0, to = 0;
    VectorSet<D> velocity;
  };
  std::optional<Starts> starts = {};
};

/// One approximate motion of a set, relative to the position of the reference, and when it exists.
template <int D>
struct TrajectoryEstimate {
  Vec<D> x, v, a;
  double begin = 0, end = 0;
};

}  // namespace foresee
