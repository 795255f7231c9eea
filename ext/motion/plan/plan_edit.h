// Plans moved in time, and parts of plans between two times.
//
//   shifted_plan(plan, 86400)                          // the same tomorrow
//   cut_plan(plan, 60, 120)                            // what the mover does from 60 to 120
//
// A plan of knots stays one of knots, with its parts. Each time is rounded once, as t + seconds. A cut between two
// knots is a new knot at the exact position, rounded once. A leg that is cut starts there with its position and
// velocity, each rounded once. So positions are those of the whole plan within rounding.
// Cost: a copy; a microsecond per cut.
#pragma once

#include <optional>

#include "motion/plan/plan.h"

namespace foresee {

/// Throws Error if a time is beyond the largest double, or if rounding makes two times equal. Requires: seconds finite.
Plan shifted_plan(const Plan& plan, double seconds);

/// Nothing if the mover does not exist for any time between. Either end may be infinite. Throws Error if a position
/// at a cut is beyond the largest double. Requires: from <= to.
std::optional<Plan> cut_plan(const Plan& plan, double from, double to);

}  // namespace foresee
