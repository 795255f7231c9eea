// Candidates of a query about one object: its row paired with every row of the other side, in linear time.
//
//   auto candidates = make_one_with_all({.one = 7, .count = 1000}, interrupt);  // (7, 0), (7, 1), …
//
// The pair of a row with itself is included: only the caller knows whether both sides are the same table.
#pragma once

#include "index/candidates.h"

namespace foresee {

enum class Side : std::uint8_t { a, b };

struct OneWithAll {
  std::uint32_t one = 0;    ///< the row number that every pair has …
  Side side = Side::a;      ///< … on this side
  std::uint32_t count = 0;  ///< how many rows the other side has
};

std::unique_ptr<Candidates> make_one_with_all(const OneWithAll& rows, Interrupt& interrupt);

}  // namespace foresee
