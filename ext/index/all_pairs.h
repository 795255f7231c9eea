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

// Candidates of a query about one object: its row paired with every row of the other side, in linear time.
//
//   auto of_one = make_one_with_all({.one = 7, .count = 1000}, interrupt);  // (7, 0), (7, 1), …
//
// The pair of a row with itself is included: only the caller knows whether both sides are the same table.

enum class Side : std::uint8_t { a, b };

struct OneWithAll {
  std::uint32_t one = 0;    ///< the row number that every pair has …
  Side side = Side::a;      ///< … on this side
  std::uint32_t count = 0;  ///< how many rows the other side has
};

std::unique_ptr<Candidates> make_one_with_all(const OneWithAll& rows, Interrupt& interrupt);

}  // namespace foresee
