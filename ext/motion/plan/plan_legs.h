// Legs of a plan: the velocity between two knots, rounded once, and the rules that every plan satisfies.
//
//   velocity_between(0, 1, 0, 3) == 1.0 / 3                    // from 0 at time 0 to 1 at time 3
//   check_plan(plan);                                          // throws Error: "knot 4: t is 5 after 5: …"
//   const std::vector<Leg> legs = legs_of(plan);
//
// The velocity of the leg between two knots is the exact quotient of the exact differences, rounded once, ties to
// even: the same on every machine. From there on these doubles are the plan, so a leg ends within rounding of the
// next knot, not on it. Cost: some 10 ns per axis; exact arithmetic, about a microsecond, where doubles leave the
// rounding open (some 30 of a million) or the numbers are extreme.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "motion/plan/plan.h"

namespace foresee {

/// (to - from) / (t1 - t0), rounded once and never -0; infinite if no double holds it; 0 for an infinite t1.
/// Requires: all finite, or t1 infinite; t0 < t1.
double velocity_between(double from, double to, double t0, double t1);

/// The legs in their order. Throws Error if no double holds a velocity. Requires: check_plan() accepts it.
std::vector<Leg> legs_of(const Plan& plan);

/// Throws Error for a plan without legs, times that do not rise, legs that overlap, or an infinite time of a mover
/// that does not rest. Requires: all numbers are finite, except perhaps times.
void check_plan(const Plan& plan);

/// Throws Error for a plan of more than max_plan_legs.
void check_size(const Plan& plan);

/// The number of legs.
std::size_t leg_count(const Plan& plan);

// Plans moved in time, and parts of plans between two times.
//
//   shifted_plan(plan, 86400)                          // the same tomorrow
//   cut_plan(plan, 60, 120)                            // what the mover does from 60 to 120
//   cut_plan(plan, 60, 120, knot_on_other_path)        // if legs between knots are not straight in these numbers
//
// A plan of knots stays one of knots, with its parts. Each time is rounded once, as t + seconds. A cut between two
// knots is a new knot at the exact position, rounded once. A leg that is cut starts there with its position and
// velocity, each rounded once. So positions are those of the whole plan within rounding.
// Cost: a copy; a microsecond per cut.

/// Throws Error if a time is beyond the largest double, or if rounding makes two times equal. Requires: seconds finite.
Plan shifted_plan(const Plan& plan, double seconds);

/// A new knot of a plan of knots on the leg that ends at knot `after`.
using KnotBetween = std::function<Knot(const Plan& plan, std::size_t after, double time)>;
/// The one on the straight leg.
Knot knot_between(const Plan& plan, std::size_t after, double time);

/// Nothing if the mover does not exist for any time between. Either end may be infinite. Throws Error if a position
/// at a cut is beyond the largest double. Requires: from <= to.
std::optional<Plan> cut_plan(const Plan& plan, double from, double to,
                             const KnotBetween& between = knot_between);

}  // namespace foresee
