// The stays of all pairs of pieces that were tested (pair_tests.h), side by side in memory that is used again
// for the next pair of objects.
#pragma once

#include <vector>

#include "contact/pieces/stays.h"
#include "contact/pieces/tested_pairs.h"
#include "numbers/crossed_root.h"

namespace foresee {

/// A condition that begins or ceases to hold where a stay may begin or end.
template <class Condition>
struct StayEnd {
  Condition condition;
  Way way;
  Enclosure at;
};

/// A stay of two pieces, and what it may begin and end with.
struct PieceStay : Stay {
  std::uint32_t first_end, end_count;  ///< among all ends
  bool is_moment = false;              ///< begin and end are one root: certain, whatever encloses it

  bool is_certain() const { return is_moment || Stay::is_certain(); }
};

/// Space for tests, used for one pair of objects after another.
template <class Condition>
struct PieceSpace {
  struct Tested {
    std::uint32_t first_stay = 0, stay_count = 0;
    bool is_told = false;  ///< else they begin later than was asked about
  };
  TestedPairs numbers;
  std::vector<Tested> tested;  ///< by those numbers
  std::vector<PieceStay> stays;
  std::vector<StayEnd<Condition>> ends;
  std::vector<PieceStay> seen;
  // Of the part at hand:
  std::vector<StayEnd<Condition>> all_ends;
  std::size_t shared_ends = 0;  ///< as many of these are of all parts
  Stays clipped, outer;

  std::uint64_t tests = 0;  ///< of two pieces, in all pairs of objects so far

  void clear() { numbers.clear(), tested.clear(), stays.clear(), ends.clear(); }
};

}  // namespace foresee
