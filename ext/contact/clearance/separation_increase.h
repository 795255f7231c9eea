// Does an object part from another that it touches when it changes its motion, whichever change of a range it
// makes? Where no path is bent the slope of the distance grows with time, so that of the first moment
// decides; else place times velocity is looked at as intervals.
#pragma once

#include "contact/clearance/separation.h"

namespace foresee {

/// About an object that is touched when the change is made. A change is clear of it if the distance
/// of the two centres never shrinks while they touch, and they do not touch again (bent_parting.h); on paths
/// that are not bent, what is convex never is. Of what grows it is the gap that must not shrink; between bent
/// paths that is blocked, and so is what has pieces. `evaluations`: as for judge().
template <int D>
ClearanceVerdict certify_separation_increases(const Encounter<D>& encounter,
                                              const TrajectoryFamily<D>& family, std::uint64_t& evaluations);

/// The same of one of several pieces, or of one that turns, about which it is not known whether it is touched
/// when the change is made: clear of it is also who is not met at all. Where that is not told from touching,
/// whatever line may part the two must move away.
template <int D>
ClearanceVerdict certify_piece_separation_increases(const Encounter<D>& encounter,
                                                    const TrajectoryFamily<D>& family,
                                                    std::uint64_t& evaluations);

}  // namespace foresee
