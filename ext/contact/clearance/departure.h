// Does an object move away at once from one that it starts beside, so near that doubles do not tell it from
// touching? Exact contact has found the two apart; the plane that stood between them then still does if they
// move apart along its normal.
//
//   const Departure leaving = departure_of<2>(encounter, family);            // met.beside
//   leaving.away_until >= encounter.end                                    // clear: a proof for every change
//
// Which plane that is need not be known: all are looked at that may be. Cost: some 50 ns.
#pragma once

#include "contact/clearance/trajectory_family.h"

namespace foresee {

struct Departure {
  double away_until;  ///< no change touches so long after the start; below 0: not known of any time
  bool all_approach;  ///< every change surely comes nearer at once
  bool all_touch;     ///< every change touches at once, nearly surely
};

/// Requires: met.beside, not ways.delayed (seen_from_start.h).
template <int D>
Departure departure_of(const Encounter<D>& encounter, const TrajectoryFamily<D>& family);

/// Whether an object that starts apart is so near that the above is worth asking.
template <int D>
bool is_beside(const Encounter<D>& encounter);

}  // namespace foresee
