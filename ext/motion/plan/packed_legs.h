// Binary form of a plan: little-endian doubles behind eight bytes. Programs write it, and SQL's aggregates return it.
//
//   const std::vector<std::byte> blob = encode_plan(plan, interrupt);
//   decode_plan(blob, interrupt) == plan                       // every number bit for bit
//
//   bytes 0 to 7     'p' 'l' 1 axes kind 0 0 0
//   then             kind 0: per knot t, x…            between two parts a knot whose numbers are all NaN
//                    kind 1: per leg t, until, x…, v…
//                    kind 2: per leg t, until, x…, v…, a…
//
// The last t or until may be infinite. decode_plan() throws Error with the byte for another number that is not finite,
// and by check_plan() for legs that overlap; it accepts any number of legs. Cost: some ns per number.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/error.h"
#include "motion/plan/plan.h"

namespace foresee {

/// Requires: check_plan() accepts the plan.
std::vector<std::byte> encode_plan(const Plan& plan, Interrupt& interrupt);

Plan decode_plan(std::span<const std::byte> blob, Interrupt& interrupt);

}  // namespace foresee
