// Certificate that an object moves away at once from one so near that doubles do not separate the two.
//
//   const Departure departure = departure_of<2>(encounter, family);  // encounter.nearly_touches
//   departure.away_until >= encounter.end                            // clear: a proof for every change
//
// Exact contact has found the two apart, so a separating plane exists at the start. It still separates them
// later if they move apart along its normal. The plane itself need not be known: every plane that it may be
// is tested. Cost: some 50 ns.
#pragma once

#include "contact/clearance/trajectory_family.h"

namespace foresee {

/// What all changes of a range do at first.
struct Departure {
  double away_until;  ///< no change touches for so long after the start; below 0: no proof
  bool all_approach;  ///< every change certainly approaches at once
  bool all_touch;     ///< every change very probably touches at once
};

/// Requires: encounter.nearly_touches, and no family.all.starts.
template <int D>
Departure departure_of(const Encounter<D>& encounter, const TrajectoryFamily<D>& family);

/// Whether an object that starts apart is so near that departure_of() is worth its cost.
template <int D>
bool starts_nearly_touching(const Encounter<D>& encounter);

}  // namespace foresee
