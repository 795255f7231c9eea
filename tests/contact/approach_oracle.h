// The oracle of the closest approach: all local extrema of the squared distance, found by Sturm's theorem,
// and both ends of the lifetime, compared exactly.
#pragma once

#include "contact/oracle.h"

namespace foresee::oracle {

/// Compares the answer of the engine with the exact one. Returns "" if they agree, else a description of the
/// difference. Requires: both exist at some time of the horizon.
std::string judge_approach(const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                           const Horizon& horizon, const ClosestApproach& answer);

}  // namespace foresee::oracle
