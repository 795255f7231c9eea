// All pairs as candidates: the index without an index, against which tests and benchmarks compare the others.
//
//   auto candidates = make_all_pairs(count, interrupt);
//
// Cost: O(n²) pairs, no set-up and no memory.
#pragma once

#include "index/candidates.h"

namespace foresee {

/// All pairs of `count` objects, each once.
std::unique_ptr<Candidates> make_all_pairs(std::size_t count, Interrupt& interrupt);

/// All pairs between `count_a` and `count_b` objects.
std::unique_ptr<Candidates> make_all_pairs(std::size_t count_a, std::size_t count_b, Interrupt& interrupt);

}  // namespace foresee
