// Estimates of the changes at which touching starts or ends: they save the bisection of ranges. The results are
// guesses and prove nothing.
//
// For any motion they are found by regula falsi. If a convex outline turns with a straight path, they have a closed
// form. The path relative to the other object passes a pair of corners on one side or the other. The side is the sign
// of A + B cos k + C sin k. Two pairs on opposite sides, both passed while the two objects exist, show that they touch.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "contact/clearance/trajectory_family.h"

namespace foresee {

/// No value for bent paths, and for the slope of growing extents or sums of pieces.
using SignedDistance = std::optional<double>;

/// The smallest distance of a changed motion from the other object; 0 or less if it touches.
template <int D>
SignedDistance gap_of(const Encounter<D>& encounter, const Changes& changes, double k);

/// Half the slope of the squared distance of the centres at the start, of two that touch then; below 0 if
/// they approach.
template <int D>
SignedDistance opening_rate_of(const Encounter<D>& encounter, const Changes& changes, double k);

/// The change between p and q at which `distance_at` passes 0, within `width`. No value unless the distance
/// is above 0 at exactly one of the two.
std::optional<double> end_between(const std::function<SignedDistance(double)>& distance_at, double p,
                                  double q, double width);

/// A range of turns, in degrees, of which each touches.
struct TouchingTurns {
  double from, to;
};

/// Of a sum that rotates with the turns, in any encounter of them: approximate, and not always all. A range may also be
/// meant 360 degrees farther. None for bent paths, extents that grow, and on one or three axes.
/// `own`: the motion before the turn, at whose place all turns start.
template <int D>
std::vector<TouchingTurns> touching_turns(const Encounter<D>& encounter, const TrajectoryEstimate<D>& own);

/// Less than 180 degrees from the first to the last.
struct TurnsBetween {
  SineCosine<double> first, last;
};

/// Whether one of these turns may touch the disc around all poses, whose radius the encounter has: cheap and
/// approximate. False on one or three axes.
template <int D>
bool disc_may_touch(const Encounter<D>& encounter, const TrajectoryEstimate<D>& own,
                    const TurnsBetween& turns);

}  // namespace foresee
