// Circular turn as accelerated legs, each within a proven distance of the arc at every time of its life.
//
//   const TurnManoeuvre turn{.t = 0, .x = {0, 0}, .v = {0, 200}, .rate = 3, .duration = 30, .until = 120};
//   const Plan plan = turn_plan(turn, 1);                  // turns right by 90 degrees, then goes straight
//
// A quadratic through both ends and the middle of an arc of angle θ and radius ρ is within ρ θ³ √3/216 of it: the
// error of interpolation, |P'''| T³ √3/216, along the direction of the error. A turn by 90 degrees of radius 1 km
// within 1 m has 4 legs. The bound on all roundings, of the arithmetic, the stored numbers and the times of the legs,
// is subtracted from the permitted error first (arc.cpp). The straight leg behind the turn is included up to its end;
// if it has none, its velocity is right within 2^-47 of the speed. The turn ends at t + duration, rounded once. The
// same bits on every machine. Cost: some 200 ns per leg.
#pragma once

#include <array>

#include "motion/plan/plan.h"

namespace foresee {

struct TurnManoeuvre {
  double t = 0;
  std::array<double, 2> x{}, v{};  ///< at t
  double rate = 0;                 ///< degrees per unit of time, clockwise with x east and y north
  double duration = 0;             ///< of the turn
  double until = no_end;           ///< end of the straight leg behind the turn
};

/// A plan of PlanKind::accelerated on two axes. Throws Error that names the input: a duration that is not above 0, an
/// until before the end of the turn, an error that doubles or max_plan_legs do not reach.
/// Requires: all numbers are finite, except perhaps until; error > 0.
Plan turn_plan(const TurnManoeuvre& turn, double error);

}  // namespace foresee
