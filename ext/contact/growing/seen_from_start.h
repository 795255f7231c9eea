// A delay seen from its start: so many seconds after the own start, whichever change that is, the object is
// at the same place, and the others are where they are by then.
//
//   const SeenFromStart<2> seen = seen_from_start<2>(met, ways);        // ways.delayed
//   judge as ever, about seen.met and seen.ways
//
// Who rests is then met by all changes of a range as by one; and nobody need be clear of a path that leads to
// the start before it. Cost: some 100 ns.
#pragma once

#include "contact/growing/changed_ways.h"

namespace foresee::contact {

template <int D>
struct SeenFromStart {
  Encounter<D> met;
  ChangedWays<D> ways;
};

/// Requires: ways.delayed.
template <int D>
SeenFromStart<D> seen_from_start(const Encounter<D>& met, const ChangedWays<D>& ways);

}  // namespace foresee::contact
