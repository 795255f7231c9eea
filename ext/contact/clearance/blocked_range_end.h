// Estimate of the change at which touching starts or ends, by regula falsi: it saves the bisection of ranges.
// The result is a guess and proves nothing.
#pragma once

#include <functional>
#include <optional>

#include "contact/clearance/trajectory_family.h"

namespace foresee {

/// No value for bent paths, and for the slope of growing extents or sums of pieces.
using SignedDistance = std::optional<double>;

/// The smallest distance of a changed motion from the other object; 0 or less if it touches.
template <int D>
SignedDistance gap_of(const Encounter<D>& encounter, const Changes& changes, double k);

/// Half the slope of the squared distance of the centres at the change, of two that touch then; below 0 if
/// they approach.
template <int D>
SignedDistance opening_rate_of(const Encounter<D>& encounter, const Changes& changes, double k);

/// The change between p and q at which `distance_at` passes 0, within `width`. No value unless the distance
/// is above 0 at exactly one of the two.
std::optional<double> end_between(const std::function<SignedDistance(double)>& distance_at, double p,
                                  double q, double width);

}  // namespace foresee
