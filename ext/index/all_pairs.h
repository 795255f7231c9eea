// The plain answer: every pair is a candidate. O(n²), no set-up, no memory; every index proves itself equal
// to it.
#pragma once

#include "index/candidates.h"

namespace foresee {

/// All pairs of `count` objects, each once.
std::unique_ptr<Candidates> make_all_pairs(std::size_t count, Interrupt& interrupt);

/// All pairs between `count_a` and `count_b` objects.
std::unique_ptr<Candidates> make_all_pairs(std::size_t count_a, std::size_t count_b, Interrupt& interrupt);

}  // namespace foresee
