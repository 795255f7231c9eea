// At which change does touching begin or cease? A guess, so that a proof need not halve its way to it.
#pragma once

#include <functional>
#include <optional>

#include "contact/clearance/trajectory_family.h"

namespace foresee {

/// Nothing where it is not known: paths that bend, extents that grow away from a centre.
using SignedDistance = std::optional<double>;

/// How far outside the other a changed motion stays; 0 or less where it touches.
template <int D>
SignedDistance gap_of(const Encounter<D>& encounter, const OwnMotion& base, const Change& change, double k);

/// Of one that touches the other at first: how its centre moves away then; 0 or less where it does not part.
template <int D>
SignedDistance opening_rate_of(const Encounter<D>& encounter, const OwnMotion& base, const Change& change,
                               double k);

/// Between p and q, the change at which `distance_at` passes 0, as near as `width`; nothing unless one of
/// the two is above 0 and the other is not.
std::optional<double> end_between(const std::function<SignedDistance(double)>& distance_at, double p,
                                  double q, double width);

}  // namespace foresee
