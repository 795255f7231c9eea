// At which change does touching begin or cease? A guess, so that a proof need not halve its way to it.
#pragma once

#include <functional>
#include <optional>

#include "contact/growing/changed_ways.h"

namespace foresee::contact {

/// Between p and q, the change at which touching begins or ceases, as near as `width`: a guess, where one of
/// the two touches, the other does not, and no path is bent. `met_at`: the encounter of a change.
template <int D>
std::optional<double> end_between(const std::function<const Encounter<D>&(double)>& met_at,
                                  const OwnMotion& base, const Change& change, double p, double q,
                                  double width);

}  // namespace foresee::contact
