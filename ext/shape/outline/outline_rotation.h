// Rotates an outline by a heading; every coordinate is the exact real one, correctly rounded.
//
//   Outline rotated = turned(hull, 37.5);         // degrees clockwise from the y axis
//
//   x' = x cos h + y sin h        y' = y cos h - x sin h        each the nearest double, ties to even
//
// A rotated outline is therefore the same on every machine, unlike with sin() and cos() of the C library. The
// heading is reduced exactly to at most 45 degrees from the nearest right angle. Sine and cosine are known to
// 2^-100, as two doubles each. A sum of two products is accepted if it rounds to one double whatever the
// error; otherwise more bits decide. This terminates: a rational sum implies that h is a multiple of 30 or 45
// degrees, and rational values there are exact. (For other angles the root of unity of angle h would have
// degree 2 over the complex rationals.)
//
// Cost: a microsecond per outline, some 40 ns per corner.
#pragma once

#include <optional>

#include "numbers/double_double.h"
#include "numbers/sine_cosine.h"
#include "shape/outline/outline.h"

namespace foresee {

/// Rotation by one heading, for many corners.
class Turn {
 public:
  /// Requires: -360 <= heading <= 360.
  explicit Turn(double heading);

  /// The rotated corner; infinite beyond the largest double.
  Corner operator()(const Corner& corner);

 private:
  /// a cos + b sin of the remaining angle, rounded once.
  double rounded_sum(double a, double b);
  double rounded_sum_of_more_bits(double a, double b);

  int right_angles_;  ///< the nearest, modulo 4
  double degrees_;    ///< the remaining angle, from -45 to 45
  SineCosine<DoubleDouble> close_;
  std::optional<SineCosine<Midrad>> closer_;  ///< computed on demand
};

/// The rotated corner. Throws Error, which names it, if it is beyond the largest double. `heading`: the one
/// of `turn`.
Corner finite_turn(Turn& turn, const Corner& corner, double heading);

/// The rotated outline. A corner that rounds to the one before it is dropped. Throws Error if a corner is
/// beyond the largest double. The result may be invalid: check it (validity.h). Requires: -360 <= heading <=
/// 360.
Outline turned(const Outline& outline, double heading);

}  // namespace foresee
