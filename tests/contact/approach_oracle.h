// The judge of the closest approach: every place where the squared distance stops falling or rising, by
// Sturm's theorem, compared with both ends of the moments asked about.
#pragma once

#include "contact/oracle.h"

namespace foresee::oracle {

/// Compares the engine's answer with the exact one; empty if they agree, else what is wrong.
/// Requires: both exist at some moment of the horizon.
std::string judge_approach(const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                           const Horizon& horizon, const ClosestApproach& answer);

}  // namespace foresee::oracle
