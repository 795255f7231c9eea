// Certificate that an object separates from one that it touches when it changes its motion, for every change
// of a range. If no path is bent, the slope of the distance increases with time, so its sign at the change
// decides. On bent paths intervals bound the slope (bent_separation.h).
#pragma once

#include "contact/clearance/separation.h"

namespace foresee {

/// Certifies a range of changes for two objects that touch at the change. A change is clear if the distance of
/// the centres never decreases while they touch, and they do not touch again (bent_separation.h). Convex sets
/// never touch again if no path is bent. If extents grow, the gap must not decrease. Bent paths of growing
/// extents or of pieces are blocked. `evaluations`: as for certify_clearance().
template <int D>
ClearanceVerdict certify_separation_increases(const Encounter<D>& encounter,
                                              const TrajectoryFamily<D>& family, std::uint64_t& evaluations);

/// The same for one of several pieces, or for a piece that rotates: whether it touches at the change is not
/// known. A change that never touches it is clear too. If doubles cannot decide whether it touches at first,
/// the two must move apart along every line that may separate them.
template <int D>
ClearanceVerdict certify_piece_separation_increases(const Encounter<D>& encounter,
                                                    const TrajectoryFamily<D>& family,
                                                    std::uint64_t& evaluations);

}  // namespace foresee
