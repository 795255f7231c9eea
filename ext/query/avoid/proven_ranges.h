// The changes of one manoeuvre that are proven clear of all near objects.
//
//   const std::vector<KRange> clear = proven_ranges(manoeuvre, exact, interrupt);
//
// Every near object, and every leg of its plan, has an encounter with every leg of the changed object: an Intruder.
// RangeBisection tests the changes for all of them together. Exact contact says which of them touch at the start of
// the manoeuvre. Cost: that of RangeBisection, and some hundred ns per encounter.
#pragma once

#include <vector>

#include "query/avoid/exact_avoidance.h"
#include "query/avoid/range_bisection.h"

namespace foresee {

/// Requires: lo < hi, and the motion at the start of the manoeuvre is finite.
std::vector<KRange> proven_ranges(const ManoeuvreCase& manoeuvre, ExactAvoidance& exact,
                                  Interrupt& interrupt);

}  // namespace foresee
