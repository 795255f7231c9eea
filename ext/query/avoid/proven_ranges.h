// The changes of one manoeuvre that are proven clear of all near objects.
//
//   const std::vector<KRange> clear = proven_ranges(manoeuvre, exact, interrupt);
//
// Every near object, and every leg of its plan, beside every leg of the changed object is one encounter with a
// certificate. ClearRanges bisects the changes for all of them together. Exact contact says which of them touch before
// the change. Cost: that of ClearRanges, and some hundred ns per encounter.
#pragma once

#include <vector>

#include "query/avoid/clear_ranges.h"
#include "query/avoid/exact_avoidance.h"

namespace foresee {

/// Requires: lo < hi, and the motion at the change is finite.
std::vector<KRange> proven_ranges(const ManoeuvreCase& manoeuvre, ExactAvoidance& exact,
                                  Interrupt& interrupt);

}  // namespace foresee
