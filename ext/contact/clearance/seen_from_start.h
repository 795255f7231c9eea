// A delay seen from its start: so many seconds after the own start, whichever change that is, the object is
// at the same place, and the others are where they are by then.
//
//   const SeenFromStart<2> seen = seen_from_start<2>(encounter, family);        // ways.delayed
//   judge as ever, about seen.encounter and seen.family
//
// Who rests is then met by all changes of a range as by one; and nobody need be clear of a path that leads to
// the start before it. Cost: some 100 ns.
#pragma once

#include "contact/clearance/trajectory_family.h"

namespace foresee {

template <int D>
struct SeenFromStart {
  Encounter<D> encounter;
  TrajectoryFamily<D> family;
};

/// Requires: ways.delayed.
template <int D>
SeenFromStart<D> seen_from_start(const Encounter<D>& encounter, const TrajectoryFamily<D>& family);

}  // namespace foresee
