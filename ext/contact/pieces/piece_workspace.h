// The stays of all pairs of pieces that were tested (pair_tests.h), side by side in memory that is used again
// for the next pair of objects.
#pragma once

#include <vector>

#include "contact/pieces/tested_pairs.h"
#include "contact/pieces/uncertain_interval.h"
#include "numbers/crossed_root.h"

namespace foresee {

/// A condition that begins or ceases to hold where a stay may begin or end.
template <class Condition>
struct EndpointCandidate {
  Condition condition;
  CrossingDirection direction;
  Enclosure at;
};

/// A stay of two pieces, and what it may begin and end with.
struct PieceInterval : UncertainInterval {
  std::uint32_t first_end, end_count;  ///< among all ends
  bool is_instant = false;             ///< begin and end are one root: certain, whatever encloses it

  bool is_certain() const { return is_instant || UncertainInterval::is_certain(); }
};

/// Space for tests, used for one pair of objects after another.
template <class Condition>
struct PieceWorkspace {
  struct Tested {
    std::uint32_t first_interval = 0, interval_count = 0;
    bool is_complete = false;  ///< else they begin later than was asked about
  };
  TestedPairs numbers;
  std::vector<Tested> tested;  ///< by those numbers
  std::vector<PieceInterval> intervals;
  std::vector<EndpointCandidate<Condition>> ends;
  std::vector<PieceInterval> seen;
  // Of the part at hand:
  std::vector<EndpointCandidate<Condition>> all_ends;
  std::size_t shared_ends = 0;  ///< as many of these are of all parts
  IntervalUnion clipped, outer;

  std::uint64_t tests = 0;  ///< of two pieces, in all pairs of objects so far

  void clear() { numbers.clear(), tested.clear(), intervals.clear(), ends.clear(); }
};

}  // namespace foresee
