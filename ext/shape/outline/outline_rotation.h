// Where does an outline lie that is turned? Every coordinate is the exact real one, rounded once.
//
//   Outline rotated = turned(hull, 37.5);         // degrees clockwise from the y axis
//
//   x' = x cos h + y sin h        y' = y cos h - x sin h        each the nearest double, ties to even
//
// So a turned outline is the same on every machine, which sin() and cos() of the C library are not. From the
// right angle that is nearest h differs by 45 degrees at most, exactly. Sine and cosine are known to 2^-100,
// as two doubles each; a sum of two products that, whatever the error, rounds to one double is accepted; else
// more bits decide. These come to an end: a sum that is rational has h a multiple of 30 or 45 degrees (else
// the root of unity of angle h would be of degree 2 over the complex rationals), and what is rational there
// is exact.
//
// Cost: a microsecond an outline, some 40 ns a corner.
#pragma once

#include <optional>

#include "numbers/double_double.h"
#include "numbers/sine_cosine.h"
#include "shape/outline/outline.h"

namespace foresee {

/// One heading, for many corners.
class Turn {
 public:
  /// Requires: -360 <= heading <= 360.
  explicit Turn(double heading);

  /// Infinite where no double is near.
  Corner operator()(const Corner& corner);

 private:
  /// a cos + b sin of the angle that is left, rounded once.
  double rounded_sum(double a, double b);
  double rounded_sum_of_more_bits(double a, double b);

  int right_angles_;  ///< the nearest, modulo 4
  double degrees_;    ///< what is left: at most 45 either way
  SineCosine<DoubleDouble> close_;
  std::optional<SineCosine<Midrad>> closer_;  ///< once asked for
};

/// Throws Error where the turned corner, of which messages speak, is beyond the largest double. `heading`:
/// that of the turn.
Corner finite_turn(Turn& turn, const Corner& corner, double heading);

/// The outline turned. A corner that comes to lie on the one before it is dropped. Throws Error where a
/// corner is beyond the largest double. Whether it is an outline still, validity.h tells. Requires: -360 <=
/// heading <= 360.
Outline turned(const Outline& outline, double heading);

}  // namespace foresee
